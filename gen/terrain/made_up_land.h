#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"

namespace wold::terrain {

/// Land that nobody knows, as it may be: ridges and smooth valleys of all sizes below the largest,
/// by a hybrid multifractal (Musgrave 1993, Methods for realistic landscape imaging), whose small
/// features are high where the large ones are.
class MadeUpLand {
 public:
  /// Land that goes on from `ground`: its deviation grows from that of the ground's heights, over
  /// half of their square, by a Hurst exponent of 0.7 up to features of 8 km, and is 500 m at most:
  /// modelling choices.
  MadeUpLand(const Heightfield& ground, std::uint64_t seed);

  /// Metres above or below the mean land, as a map with this step shows it, at a distance from
  /// land that is known. Features begin there over their own size, the small ones at once. 0 at
  /// distance 0.
  double height_m(const glm::dvec2& at_m, double step_m, double from_known_m) const;

 private:
  /// Features of one size.
  struct Octave {
    double feature_m;
    double part;         ///< how high they are
    double round = 0.0;  ///< how round their crests are, in deviations of the noise
    glm::dmat2 turn{1.0};
    glm::dvec2 shift{0.0};
    std::uint64_t key = 0;
    double mean_ridge = 0.0;   ///< over all places
    double mean_weight = 0.0;  ///< of what larger features leave for it, where all have begun
  };

  static double ridge(const Octave& octave, const glm::dvec2& at_m);
  void measure();

  std::vector<Octave> octaves_;  ///< from the largest
  double deviation_m_;           ///< of heights far from all that is known
  double scale_ = 1.0;           ///< by which the sum of octaves has deviation 1
};

}  // namespace wold::terrain
