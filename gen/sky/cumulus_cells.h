#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "cloud/cumulus_column.h"
#include "cloud/look.h"

namespace wold::sky {

/// The heaps of a layer that has relief, over its flat base: rounded columns bitten into between
/// heads. Places are world space; shapes turn into each other by their tops.
class CumulusCells {
 public:
  /// `sheets`: the layer's at that moment.
  CumulusCells(const cloud::LayerState& state, std::vector<cloud::Sheet> sheets);

  /// Above the base.
  double top_m(const glm::dvec2& place_m) const;
  double highest_m() const { return highest_m_; }

  /// cloud::heap_field(), at least -1; heads finer than footprint_m are evened out.
  double field(const glm::dvec3& place_m, double footprint_m) const;

  /// Optical depth of the droplets between the place and the sun.
  double depth_to_sun(const glm::dvec3& place_m) const;

 private:
  glm::dvec2 in_periods(const glm::dvec2& place_m) const;

  std::shared_ptr<const cloud::Layer> layer_;
  glm::dvec2 way_m_;
  std::vector<cloud::Sheet> shapes_;
  cloud::PeriodicMap<float> tops_m_;  ///< where they would be without drift
  double highest_m_;
  cloud::Billows billows_;
};

}  // namespace wold::sky
