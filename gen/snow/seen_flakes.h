#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/parallel.h"
#include "snow/flake_look.h"
#include "snow/simd_lanes.h"
#include "snow/snow_view.h"
#include "snow/tornado.h"

namespace wold::snow {

/// What a view sees of the snow in the air.
struct SeenFlakes {
  std::vector<SeenFlake> flakes;      ///< from the farthest to the nearest
  double fog_extinction_per_m = 0.0;  ///< of all that are not among them, everywhere the same
};

inline constexpr float nearest_flake_m = 0.15F;  ///< nearer ones would hide the picture

/// Puts how flakes look at the end of `seen`, of those that have any of them within the view, are
/// not too near and above the ground.
class FlakeCuller {
 public:
  FlakeCuller(const FlakeLook& look, const Frustum& frustum, const Heightfield& ground)
      : look_(look), frustum_(frustum), ground_(ground) {}

  /// Of the flakes those below `end` that pass test(lane) as well.
  template <class Test>
  void see(const FlakeLanes& flakes, std::size_t end, const Test& test,
           std::vector<SeenFlake>& seen) const {
    const Frustum frustum = frustum_;
    see_chosen(
        flakes,
        Chosen::by(
            [&](std::size_t i) {
              const glm::vec3 from_eye = flakes.from_eye.at(i);
              return static_cast<int>(glm::dot(from_eye, from_eye) >
                                      nearest_flake_m * nearest_flake_m) &
                     static_cast<int>(frustum.touches_from_eye(from_eye, flakes.diameter[i])) &
                     static_cast<int>(test(i));
            },
            end),
        seen);
  }

 private:
  void see_chosen(const FlakeLanes& flakes, Chosen chosen, std::vector<SeenFlake>& seen) const;

  const FlakeLook& look_;
  const Frustum& frustum_;
  const Heightfield& ground_;
};

/// What is seen, in an order that does not depend on threads.
class FlakeCollector {
 public:
  /// Adds what pick(part, seen) puts at the end of `seen`, for every part in [0, parts).
  template <class Pick>
  void add(std::size_t parts, const Pick& pick) {
    const std::size_t before = parts_.size();
    parts_.resize(before + parts);
    parallel_for(parts, [&](std::size_t part) { pick(part, parts_[before + part]); });
  }

  /// A tornado's flakes that are in view, by `look`, which should have whirl_shutter_s at least.
  void add(const Tornado& tornado, double time_s, const FlakeLook& look, const Frustum& frustum,
           const Heightfield& ground);

  std::vector<SeenFlake> farthest_first(const glm::dvec3& eye_m) const;

 private:
  std::vector<std::vector<SeenFlake>> parts_;
};

/// Flakes first to last of something, for one thread at a time.
struct Range {
  std::size_t of;
  std::uint64_t first, last;
};

/// Appends what splits [first, last) of `of` into parts that are worth a thread's while.
void split(std::size_t of, std::uint64_t first, std::uint64_t last, std::vector<Range>& parts);

}  // namespace wold::snow
