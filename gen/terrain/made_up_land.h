#pragma once

#include <cstdint>
#include <glm/glm.hpp>

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

  /// Size of the largest features.
  double feature_m() const { return feature_m_; }

  /// Standard deviation of its heights.
  double deviation_m() const { return deviation_m_; }

  /// Metres above or below the mean land, as a map with this step shows it.
  double height_m(const glm::dvec2& at_m, double step_m) const;

 private:
  double multifractal(const glm::dvec2& at_m, double step_m) const;

  std::uint64_t key_;
  double feature_m_;
  double deviation_m_;
  double mean_ = 0.0;   ///< of multifractal()
  double scale_ = 1.0;  ///< by which its deviation is 1
};

}  // namespace wold::terrain
