#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/ground_map.h"
#include "terrain/worn_land.h"

namespace wold::terrain {

/// Land that nobody knows, as it may be: mountains and valleys of all sizes below the largest, as
/// streams wear them (WornLand), with smaller ones on their slopes rather than in their valleys.
class MadeUpLand {
 public:
  /// Land that goes on from `ground`: its deviation grows from that of the ground's heights, over
  /// half of their square, by a Hurst exponent of 0.7 up to features of 8 km, or as large as half
  /// of a wider square. It is 300 m at most. These are modelling choices.
  MadeUpLand(const Heightfield& ground, std::uint64_t seed);

  /// Metres above or below the mean land, as a map with this step shows it, at a distance from
  /// land that is known. Features begin there over their own size, the small ones at once. 0 at
  /// distance 0.
  double height_m(const glm::dvec2& at_m, double step_m, double from_known_m) const;

  /// Which steps a map has, and which another one that shows finer features.
  struct Steps {
    double coarse_m, fine_m;
  };
  /// What the finer map shows beyond the coarser one.
  double finer_m(const glm::dvec2& at_m, const Steps& steps, double from_known_m) const;

  /// A bound, metres: finer_m() is nowhere higher, at any distance from known land.
  double most_finer_m(const Steps& steps) const;

 private:
  /// The worn land, once more in another size.
  struct Copy {
    double feature_m;  ///< size of its largest features
    double height_m;   ///< its deviation
    glm::dmat2 turn{1.0};
    glm::dvec2 shift{0.0};

    glm::dvec2 place(const glm::dvec2& at_m) const { return turn * at_m / feature_m + shift; }
  };

  std::optional<WornLand> worn_;  ///< none where the ground is level
  std::vector<Copy> copies_;      ///< from the largest
};

}  // namespace wold::terrain
