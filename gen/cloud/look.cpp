#include "cloud/look.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::cloud {
namespace {

float opacity(const LayerState& state, double rank, double fraction) {
  const LayerMoment& moment = state.moment;
  const double depth =
      optical_depth_of_rank(*state.layer, rank, moment.amount_is_alpha ? 1.0 : moment.amount);
  const double alpha =
      moment.shapes_by_alpha ? -fraction * math::expm1(-depth) : -math::expm1(-fraction * depth);
  return static_cast<float>(moment.amount_is_alpha ? moment.amount * alpha : alpha);
}

/// How deep the layer's clouds are, of the depth that the whole layer's have.
double depth_left(const LayerState& state) {
  return depth_factor(state.moment.amount_is_alpha ? 1.0 : state.moment.amount);
}

/// What is left of the light where the whole layer would leave `brightness`.
double light_left(const LayerState& state, double brightness) {
  if (state.layer->lit_as_paper) return 1.0;
  return brightness_of_less(brightness, depth_left(state));
}

/// entry(value) for the middle of every entry's steps, in [0, 1].
template <class Entry>
auto table(unsigned steps_per_entry, const Entry& entry) {
  const unsigned entries = 65536 / steps_per_entry;
  std::vector<decltype(entry(0.0))> values;
  values.reserve(entries);
  for (unsigned i = 0; i < entries; ++i) values.push_back(entry((i + 0.5) / entries));
  return values;
}

Sheet sheet_of(const LayerState& state, const std::shared_ptr<const ShapeMaps>& map,
               double fraction, double pixel_m) {
  return {map,
          state.moment.way_m / pixel_m,
          table(ranks_per_entry, [&](double rank) { return opacity(state, rank, fraction); }),
          table(lights_per_entry,
                [&](double brightness) {
                  return glm::vec4(glm::vec3(state.moment.light * light_left(state, brightness)),
                                   1.0F);
                }),
          fraction,
          depth_left(state)};
}

}  // namespace

std::vector<float> top_m_by_rank(const LayerState& state) {
  const double amount = state.moment.amount_is_alpha ? 1.0 : state.moment.amount;
  return table(ranks_per_entry, [&](double rank) {
    return static_cast<float>(top_m(*state.layer, relative_depth(*state.layer, rank, amount)));
  });
}

double by_rank(const std::vector<float>& table, double rank) {
  const auto entry = static_cast<std::size_t>(std::clamp(rank, 0.0, 65535.0)) / ranks_per_entry;
  return double{table[std::min(entry, table.size() - 1)]};
}

std::vector<Sheet> sheets_of(const LayerState& state, double pixel_m) {
  const double next_fraction = state.next_map ? state.moment.next_fraction : 0.0;
  std::vector<Sheet> sheets;
  if (next_fraction < 1.0)
    sheets.push_back(sheet_of(state, state.map, 1.0 - next_fraction, pixel_m));
  if (next_fraction > 0.0)
    sheets.push_back(sheet_of(state, state.next_map, next_fraction, pixel_m));
  return sheets;
}

}  // namespace wold::cloud
