#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "core/noise.h"

namespace wold::terrain {

/// The look of bare rock: beds that dip a little and differ in colour, thick ones made of thinner
/// ones, broken by joints into blocks, these into smaller ones and so on (cellular noise, Worley
/// 1996), from buttresses of 300 m to chips of 3 cm. Each block has a face of its own that turns
/// to or away from the light, and dark joints about it. Keyed, in space, so that steep faces show
/// blocks and not their plan drawn out.
class Rock {
 public:
  /// As a map with that step, > 0, shows it: blocks finer than the step are evened out. `albedo` is
  /// linear red, green and blue in [0, 1].
  Rock(const glm::vec3& albedo, std::uint64_t seed, double step_m);

  /// Radiance over that of a smooth white surface which faces `up` and is lit by the sun and the
  /// sky: the albedo on the mean, 2.69 times that at most. World space; `up`, not below the
  /// horizon, and `to_sun` are unit vectors.
  glm::vec3 at(const glm::dvec3& place_m, const glm::dvec3& up, const glm::dvec3& to_sun) const;

  /// The same of its debris: stones of 1.2 m down to 3 cm, mixed from all of its beds, each of its
  /// own shade, with dark gaps between them.
  glm::vec3 debris_at(const glm::dvec3& place_m, const glm::dvec3& up,
                      const glm::dvec3& to_sun) const;

 private:
  struct Size {
    double block_m;
    double tilt;             ///< how far faces turn from the ground's
    double dark;             ///< fraction of the light that joints take
    double own_shade = 0.0;  ///< how far a block's own shade is off the mean at most
  };
  /// Blocks in blocks, and how much of each size a map shows.
  template <std::size_t count>
  struct Sizes {
    std::array<Size, count> sizes;
    std::array<double, count> shown{};
    std::uint64_t key = 0;

    void show(double step_m, std::uint64_t with_key);
  };

  template <std::size_t count>
  float shade(const Sizes<count>& broken, const glm::dvec3& place_m, const glm::dvec3& up,
              const glm::dvec3& to_sun) const;
  glm::dvec3 bedded(const glm::dvec3& place_m) const;
  glm::vec3 bed_at(const glm::dvec3& bedded_m) const;
  glm::vec3 stain_at(const glm::dvec3& place_m) const;

  glm::vec3 albedo_;
  std::uint64_t key_;
  ScaleFreeNoise bend_, beds_;
  Fbm stain_;
  double stain_shown_;
  glm::dmat3 to_beds_;
  Sizes<8> blocks_{{{{300.0, 0.16, 0.1},
                     {75.0, 0.2, 0.16},
                     {19.0, 0.24, 0.24},
                     {4.8, 0.3, 0.36},
                     {1.2, 0.42, 0.6},
                     {0.4, 0.26, 0.4},
                     {0.12, 0.16, 0.2},
                     {0.03, 0.14, 0.07}}}};
  Sizes<4> stones_{{{{1.2, 0.35, 0.3, 0.2},
                     {0.4, 0.45, 0.5, 0.25},
                     {0.12, 0.4, 0.4, 0.25},
                     {0.03, 0.2, 0.2, 0.15}}}};
};

}  // namespace wold::terrain
