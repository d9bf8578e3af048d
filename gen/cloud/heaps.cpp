#include "cloud/heaps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wold::cloud {
namespace {

/// Optical depth of the droplets from a height, a fraction of the highest top's, towards the sun.
double depth_in(const Droplets& droplets, const std::vector<LayerMap>& sunlit,
                const glm::dvec2& place, double height_fraction) {
  const double at = height_fraction * static_cast<double>(sunlit.size());
  const auto low = std::min(static_cast<std::size_t>(at), sunlit.size() - 1);
  const auto light_at = [&](std::size_t i) {
    return i < sunlit.size() ? sunlit[i].sample(place.x, place.y) : 65535.0;
  };
  const double light =
      std::lerp(light_at(low), light_at(low + 1), std::min(at - static_cast<double>(low), 1.0));
  return depth_of_brightness(droplets, light / 65535.0);
}

PeriodicMap<float> mean_tops_m(const std::vector<Sheet>& shapes,
                               const std::vector<float>& top_m_by_rank) {
  const LayerMap& first = shapes.front().map->relief->ranks;
  PeriodicMap<float> tops_m(first.width(), first.height());
  for (const Sheet& shape : shapes) {
    const std::vector<std::uint16_t>& ranks = shape.map->relief->ranks.values();
    for (std::size_t i = 0; i < ranks.size(); ++i)
      tops_m.values()[i] += static_cast<float>(shape.fraction * by_rank(top_m_by_rank, ranks[i]));
  }
  return tops_m;
}

}  // namespace

Heaps::Heaps(const LayerState& state, std::vector<Sheet> sheets)
    : layer_(state.layer), way_m_(state.moment.way_m), shapes_(std::move(sheets)), billows_(state) {
  const std::vector<float> tops = top_m_by_rank(state);
  highest_m_ = double{tops.back()};
  tops_m_ = mean_tops_m(shapes_, tops);
}

glm::dvec2 Heaps::in_periods(const glm::dvec2& place_m) const {
  return (place_m - way_m_) / layer_->period_m;
}

double Heaps::top_m(const glm::dvec2& place_m) const {
  const glm::dvec2 at = in_periods(place_m);
  return tops_m_.sample(at.x, at.y);
}

double Heaps::field(const glm::dvec3& place_m, double footprint_m) const {
  const double top = top_m(glm::dvec2(place_m));
  if (top <= 0.0) return -1.0;
  const double height = (place_m.z - layer_->base_m) / layer_->thickness_m;
  const double column = top / layer_->thickness_m;
  // Above its top it does not matter how a heap is bitten into.
  if (height >= column) return std::max((column - height) / column - 0.5, -1.0);
  return std::max(heap_field(height, column, billows_.fine_at(place_m, footprint_m)), -1.0);
}

double Heaps::depth_to_sun(const glm::dvec3& place_m) const {
  const double height_fraction = (place_m.z - layer_->base_m) / layer_->thickness_m;
  const glm::dvec2 at = in_periods(glm::dvec2(place_m));
  double depth = 0.0;
  for (const Sheet& shape : shapes_)
    depth += shape.fraction * shape.depth_left *
             depth_in(layer_->droplets, shape.map->relief->sunlit, at, height_fraction);
  return depth;
}

}  // namespace wold::cloud
