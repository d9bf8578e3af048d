#include "cloud/cumulus_column.h"

#include <algorithm>
#include <cmath>

namespace wold::cloud {

double column_profile(double t) {
  constexpr double soft_base = 1.0 / 7.0;
  if (t <= 0.0 || t >= 1.0) return 0.0;
  return std::min(1.0, t / soft_base) * std::sqrt(1.0 - t);
}

double eroded(double profile, double t, double billow) {
  constexpr double depth = 0.9;
  const double bites = std::clamp((t - 0.05) / 0.3, 0.0, 1.0);
  return std::max(0.0, profile - depth * bites * (1.0 - billow));
}

double heap_field(double height, double top, double billow) {
  constexpr double lowest_billow = 0.4;  // hardly any place is less
  constexpr double lowered = 0.38;       // of the thickness: the top where no head is
  constexpr double depth = 0.7;          // of the field: how far space bites into the sides
  constexpr double base_depth = 0.8;     // of the field: and into the base
  constexpr double soft_base = 0.12;     // of the thickness: over it the base becomes dense
  const double bite = std::min((1.0 - billow) / (1.0 - lowest_billow), 1.0);
  const double left = top - lowered * bite;
  if (left <= 0.0) return std::max(left / lowered - 0.2, -1.0);
  const double t = height / left;
  const double column = t < 1.0 ? std::sqrt(1.0 - std::max(t, 0.0)) : 1.0 - t;
  return std::min(column - depth * bite, height / soft_base - base_depth * bite);
}

Billows::Billows(const LayerState& state)
    : layer_(state.layer), billow_cells_(&state.layer->billow_cells.value()) {
  // As many as make the period whole.
  const double wanted_m = 0.25 * BillowBox::billow_cells * state.layer->thickness_m;
  const glm::dvec2 boxes = glm::max(glm::round(state.layer->period_m / wanted_m), 1.0);
  per_m_ = glm::dvec3(boxes / state.layer->period_m, 1.0 / wanted_m);
  origin_m_ = glm::dvec3(state.moment.way_m, state.layer->base_m);
}

double Billows::at(const glm::dvec3& place_m) const {
  return in_box((place_m - origin_m_) * per_m_);
}

double Billows::in_box(const glm::dvec3& place) const {
  return static_cast<double>(billow_cells_->at(glm::vec3(place)));
}

double Billows::fine_at(const glm::dvec3& place_m, double footprint_m) const {
  constexpr double mean = 0.7;  // of BillowBox
  const glm::dvec3 place = (place_m - origin_m_) * per_m_;
  const auto octave = [&](double times, double weight) {
    const double billow_cell_m = 0.5 / (per_m_.z * BillowBox::billow_cells * times);
    const double shown = std::clamp(billow_cell_m / (2.0 * footprint_m) - 0.5, 0.0, 1.0);
    if (shown <= 0.0) return weight * mean;
    return weight * std::lerp(mean, in_box(place * times), shown);
  };
  return octave(1.0, 0.5) + octave(4.0, 0.3) + octave(16.0, 0.2);
}

}  // namespace wold::cloud
