#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/parallel.h"
#include "snow/flake_look.h"
#include "snow/snow_view.h"
#include "snow/tornado.h"

namespace wold::snow {

/// What a view sees of the snow in the air.
struct SeenFlakes {
  std::vector<SeenFlake> flakes;      ///< from the farthest to the nearest
  double fog_extinction_per_m = 0.0;  ///< of all that are not among them, everywhere the same
};

inline constexpr double nearest_flake_m = 0.15;  ///< nearer ones would hide the picture

/// Whether any of a flake is within the view, not too near, and above the ground.
bool is_in_view(const Flake& flake, const Frustum& frustum, const Heightfield& ground);

/// What is seen, in an order that does not depend on threads.
class Gathering {
 public:
  /// Adds what pick(i, seen) puts at the end of `seen`, for every i in [0, count).
  template <class Pick>
  void add(std::uint64_t count, const Pick& pick) {
    constexpr std::uint64_t block = 4096;
    const std::size_t before = parts_.size();
    parts_.resize(before + static_cast<std::size_t>((count + block - 1) / block));
    parallel_for(parts_.size() - before, [&](std::size_t b) {
      const std::uint64_t end = std::min<std::uint64_t>(count, (b + 1) * block);
      for (std::uint64_t i = b * block; i < end; ++i) pick(i, parts_[before + b]);
    });
  }

  /// A tornado's flakes that are in view, by `look`, which should have whirl_shutter_s at least.
  void add(const Tornado& tornado, double time_s, const FlakeLook& look, const Frustum& frustum,
           const Heightfield& ground);

  std::vector<SeenFlake> farthest_first(const glm::dvec3& eye_m) const;

 private:
  std::vector<std::vector<SeenFlake>> parts_;
};

}  // namespace wold::snow
