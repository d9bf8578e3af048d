#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "cloud/clouds.h"

/// How a column of a dense cloud is filled: a flat base, a rounded top, and between them heads.
namespace wold::cloud {

/// Extinction at a fraction t of a column's height, of any scale: it rises over the lowest seventh
/// and falls as sqrt(1 - t) to the top. 0 outside [0, 1].
double column_profile(double t);

/// What is left of it between heads, of which `billow` in [0, 1] is Billows::at(); nothing is lost
/// at the flat base.
double eroded(double profile, double t, double billow);

/// Signed field of a heap as it is seen, above 0 inside. `height`, over the base, and `top` of the
/// column there are fractions of the layer's thickness. Between heads, of which `billow` in [0, 1]
/// is Billows::fine_at(), the top lies lower and space bites into the sides, and less deep into the
/// flat base.
double heap_field(double height, double top, double billow);

/// Round heads in a layer, that drift with it and repeat with its period: a quarter of the
/// thickness wide, with smaller ones on them.
class Billows {
 public:
  /// Throws std::bad_optional_access where the layer has no heads.
  explicit Billows(const LayerState& state);

  /// In [0, 1], 1 at the heads' middles; world space.
  double at(const glm::dvec3& place_m) const;

  /// With smaller heads on those, down to some metres; heads finer than what a sample stands for,
  /// footprint_m, are evened out.
  double fine_at(const glm::dvec3& place_m, double footprint_m) const;

 private:
  double in_box(const glm::dvec3& place) const;

  std::shared_ptr<const Layer> layer_;  ///< keeps the heads
  const BillowBox* billow_cells_;
  glm::dvec3 per_m_, origin_m_;
};

}  // namespace wold::cloud
