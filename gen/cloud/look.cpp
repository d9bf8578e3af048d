#include "cloud/look.h"

#include <cmath>

namespace wold::cloud {
namespace {

/// Light that comes through, of the light that falls in.
double base_brightness(const Layer& layer, double share_of_densest) {
  if (layer.lit_as_paper) return 1.0;
  return 1.0 / (1.0 + 0.75 * (1.0 - layer.asymmetry) * layer.optical_depth * share_of_densest);
}

glm::vec4 seen(const LayerState& state, double rank, double share) {
  const Layer& layer = *state.layer;
  const LayerMoment& moment = state.moment;
  const double depth =
      optical_depth_of_rank(layer, rank, moment.amount_is_alpha ? 1.0 : moment.amount);
  const double brightness = base_brightness(layer, depth > 0.0 ? depth / layer.seen_depth : 0.0);
  double alpha = moment.shapes_by_alpha ? -share * std::expm1(-depth) : -std::expm1(-share * depth);
  if (moment.amount_is_alpha) alpha *= moment.amount;
  return glm::vec4(glm::vec3(moment.light * (brightness * alpha)), alpha);
}

Sheet sheet_of(const LayerState& state, const std::shared_ptr<const LayerMap>& map, double share,
               double pixel_m) {
  Sheet sheet{map, state.moment.way_m / pixel_m, {}};
  sheet.look.reserve(look_entries);
  for (int entry = 0; entry < look_entries; ++entry)
    sheet.look.push_back(seen(state, (entry + 0.5) / look_entries, share));
  return sheet;
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
