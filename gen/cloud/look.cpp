#include "cloud/look.h"

#include <cmath>

namespace wold::cloud {
namespace {

glm::vec4 seen(const LayerState& state, double rank, double share) {
  const LayerMoment& moment = state.moment;
  const double depth =
      optical_depth_of_rank(*state.layer, rank, moment.amount_is_alpha ? 1.0 : moment.amount);
  double alpha = moment.shapes_by_alpha ? -share * std::expm1(-depth) : -std::expm1(-share * depth);
  if (moment.amount_is_alpha) alpha *= moment.amount;
  return {glm::vec3(moment.light * alpha), alpha};
}

/// What is left of the light where the whole layer would leave `brightness`.
double light_left(const LayerState& state, double brightness) {
  if (state.layer->lit_as_paper) return 1.0;
  const double amount = state.moment.amount_is_alpha ? 1.0 : state.moment.amount;
  return brightness_of_less(brightness, depth_factor(amount));
}

/// entry(value) for the middle of every entry's steps, in [0, 1].
template <class Entry>
std::vector<glm::vec4> table(int steps_per_entry, const Entry& entry) {
  const int entries = 65536 / steps_per_entry;
  std::vector<glm::vec4> values;
  values.reserve(static_cast<std::size_t>(entries));
  for (int i = 0; i < entries; ++i) values.push_back(entry((i + 0.5) / entries));
  return values;
}

Sheet sheet_of(const LayerState& state, const std::shared_ptr<const ShapeMaps>& map, double share,
               double pixel_m) {
  return {map, state.moment.way_m / pixel_m,
          table(ranks_per_entry, [&](double rank) { return seen(state, rank, share); }),
          table(lights_per_entry, [&](double brightness) {
            return glm::vec4(glm::vec3(static_cast<float>(light_left(state, brightness))), 1.0F);
          })};
}

}  // namespace

std::vector<Sheet> sheets_of(const LayerState& state, double pixel_m) {
  const double next_share = state.next_map ? state.moment.next_share : 0.0;
  std::vector<Sheet> sheets;
  if (next_share < 1.0) sheets.push_back(sheet_of(state, state.map, 1.0 - next_share, pixel_m));
  if (next_share > 0.0) sheets.push_back(sheet_of(state, state.next_map, next_share, pixel_m));
  return sheets;
}

}  // namespace wold::cloud
