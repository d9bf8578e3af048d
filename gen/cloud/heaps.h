#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "cloud/cumulus_column.h"
#include "cloud/look.h"

namespace wold::cloud {

/// The heaps of a layer that stands in heaps, over its flat base: rounded columns bitten into
/// between heads. Places are world space; shapes turn into each other by their tops.
class Heaps {
 public:
  /// `sheets`: the layer's at that moment. Throws std::bad_optional_access where the layer has no
  /// heads.
  Heaps(const LayerState& state, std::vector<Sheet> sheets);

  /// Above the base.
  double top_m(const glm::dvec2& place_m) const;
  double highest_m() const { return highest_m_; }

  /// heap_field(), at least -1; heads finer than footprint_m are evened out.
  double field(const glm::dvec3& place_m, double footprint_m) const;

  /// Optical depth of the droplets between the place and the sun.
  double depth_to_sun(const glm::dvec3& place_m) const;

 private:
  glm::dvec2 in_periods(const glm::dvec2& place_m) const;

  std::shared_ptr<const Layer> layer_;
  glm::dvec2 way_m_;
  std::vector<Sheet> shapes_;
  PeriodicMap<float> tops_m_;  ///< where they would be without drift
  double highest_m_;
  Billows billows_;
};

}  // namespace wold::cloud
