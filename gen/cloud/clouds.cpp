#include "cloud/clouds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "cloud/texture_set.h"
#include "core/elementary.h"
#include "core/error.h"
#include "core/random.h"
#include "light/daylight.h"
#include "scene/sun_position.h"

namespace wold::cloud {
namespace {

constexpr int max_period_px = 16384;
constexpr int finest_cell_px = 1024;
constexpr double widest_heaps = 10.0;  ///< over those of the kind

/// The recipe of a layer's kind; its fibres are combed by the wind, whose turn with height differs
/// from layer to layer.
Recipe recipe_of_layer(const scene::CloudLayer& described, std::uint64_t key) {
  constexpr double turn_deg = 35.0;
  Recipe recipe = recipe_of(described.kind);
  const double turned_deg =
      described.heading_deg + turn_deg * (2.0 * random_uniform({key, key_of("trails")}) - 1.0);
  recipe.trails.heading_rad = glm::radians(turned_deg);
  return recipe;
}

double thickness_m_of(const scene::CloudLayer& layer, const Recipe& recipe) {
  return layer.thickness_m.value_or(recipe.thickness_m);
}

/// A veil has no surface; light that is the same everywhere shows none.
bool has_relief(const scene::CloudLayer& layer, const Recipe& recipe) {
  constexpr double deep = 5.0;
  return layer.light != scene::Law::paper &&
         recipe.extinction_per_km * 1e-3 * thickness_m_of(layer, recipe) > deep;
}

/// Whether nothing of the layer is finer than its map's pixels.
bool is_all_in_its_map(const scene::CloudLayer& layer) {
  const Recipe recipe = recipe_of(layer.kind);
  const bool is_heaps = has_relief(layer, recipe) && layer.cover.value_or(recipe.cover) < 1.0;
  return (layer.body == scene::CloudBody::volume && !is_heaps) || !layer.textures.empty();
}

glm::ivec2 period_px_of(const glm::ivec2& cells, double cell_m, double pixel_m, std::size_t layer) {
  const glm::dvec2 period = glm::dvec2(cells) * cell_m / pixel_m;
  if (!(std::max(period.x, period.y) <= max_period_px))
    throw InputError(fmt::format(
        "clouds[{}]: a period of {} x {} cells of {} m has {:.0f} pixels "
        "of {} m, expected at most {}: fewer or smaller cells",
        layer + 1, cells.x, cells.y, cell_m, std::max(period.x, period.y), pixel_m, max_period_px));
  return glm::max(glm::ivec2(glm::round(period)), glm::ivec2(2));
}

Layer layer_of(std::uint64_t key, const scene::CloudLayer& described, const Recipe& recipe,
               const TextureSet& textures, const glm::ivec2& period_px, double pixel_m) {
  Layer layer;
  layer.key = key;
  layer.base_m = described.base_m.value_or(recipe.base_m);
  layer.thickness_m = thickness_m_of(described, recipe);
  layer.period_px = period_px;
  layer.period_m = glm::dvec2(period_px) * pixel_m;
  layer.is_volume = described.body == scene::CloudBody::volume;
  layer.lit_as_paper = described.light == scene::Law::paper;
  layer.droplets = {recipe.extinction_per_km * 1e-3, recipe.asymmetry};
  layer.has_relief = has_relief(described, recipe);
  if (layer.has_relief || layer.is_volume) layer.billow_cells.emplace(key);
  layer.forward.emplace(forward_through, layer.droplets.asymmetry);
  layer.seen_depth = -math::log1p(-textures.densest_opacity);
  layer.cover = textures.cover;
  layer.profile = textures.profile;
  layer.rank_per_field = textures.rank_per_field;
  if (textures.field_px > 0)
    layer.detail = Detail(recipe, textures.field_px, cell_m_of(described), layer.period_m, key);
  return layer;
}

glm::dvec3 direction_to(const scene::Sun& sun) {
  const scene::SunPosition position = scene::sun_position(sun);
  return light::direction_of(glm::radians(position.azimuth_deg),
                             glm::radians(position.elevation_deg));
}

double profile_at(const std::vector<float>& profile, double rank) {
  const double place = std::clamp(rank, 0.0, 1.0) * (static_cast<double>(profile.size()) - 1.0);
  const auto low = std::min(static_cast<std::size_t>(place), profile.size() - 2);
  const double part = place - static_cast<double>(low);
  return (1.0 - part) * profile[low] + part * profile[low + 1];
}

/// Tops above the base by rank, of the whole layer.
std::vector<float> tops_m(const Layer& layer) {
  std::vector<float> tops(profile_steps + 1);
  for (int i = 0; i <= profile_steps; ++i)
    tops[static_cast<std::size_t>(i)] = static_cast<float>(
        top_m(layer, relative_depth(layer, static_cast<double>(i) / profile_steps, 1.0)));
  return tops;
}

/// The map's rank at a place, in [0, 1].
double rank_at(const LayerMap& map, const glm::dvec2& place_px) {
  return map.sample(place_px.x / map.width(), place_px.y / map.height()) / 65535.0;
}

/// Optical depth of a fraction of a shape, by alpha or by depth.
double fade(double depth, double fraction, bool by_alpha) {
  return by_alpha ? -math::log1p(fraction * math::expm1(-depth)) : fraction * depth;
}

}  // namespace

/// A layer, its time line, and the maps of the shapes that were asked for last.
struct Clouds::LayerHistory {
  std::shared_ptr<const Layer> layer;
  TextureSet textures;
  glm::ivec2 cells;
  bool repeats_as_paper;
  std::uint64_t key;
  double pixel_m;
  Timeline timeline;
  std::mutex mutex;
  std::map<std::size_t, std::shared_ptr<const ShapeMaps>> maps;  ///< by shape

  LayerMap made_ranks(const Shape& shape) const {
    const TextureSet shaped = sheared(textures, shape.heading_rad, shape.shear);
    const auto repeated = repeats_as_paper ? repeated_as_paper : repeated_by_blending;
    return repeated(shaped, cells, layer->period_px, key);
  }

  /// The maps of a shape without light.
  ShapeMaps made_maps(const Shape& shape) const {
    constexpr double smoothed = 0.7;
    ShapeMaps made;
    made.ranks = made_ranks(shape);
    if (layer->has_relief)
      made.relief = Relief{relief_ranks(made.ranks, pixel_m, layer->thickness_m), {}};
    made.detail = 1.0 - smoothed * shape.shear;
    return made;
  }

  void light(ShapeMaps& shape, const glm::dvec3& sun_direction) const {
    const std::vector<float> tops = tops_m(*layer);
    shape.sun_direction = sun_direction;
    shape.sunlit = sunlit(shape.ranks, tops, layer->droplets, sun_direction, pixel_m);
    if (!shape.relief) return;
    const double coarse_m = pixel_m * shape.ranks.width() / shape.relief->ranks.width();
    shape.relief->sunlit =
        relief_light(shape.relief->ranks, tops, layer->droplets, sun_direction, coarse_m);
  }

  std::shared_ptr<const ShapeMaps> map_of(std::size_t number, const glm::dvec3& sun_direction) {
    std::shared_ptr<const ShapeMaps>& map = maps[number];
    if (map && map->sun_direction == sun_direction) return map;
    ShapeMaps lit = map ? *map : made_maps(timeline.shapes()[number]);
    light(lit, sun_direction);
    map = std::make_shared<const ShapeMaps>(std::move(lit));
    return map;
  }

  LayerState at(double time_s, const glm::dvec3& sun_direction) {
    LayerState state;
    state.layer = layer;
    state.moment = timeline.at(time_s);
    const std::size_t first = state.moment.shape, next = state.moment.next_shape;
    const std::lock_guard lock(mutex);
    std::erase_if(maps,
                  [&](const auto& kept) { return kept.first != first && kept.first != next; });
    state.map = map_of(first, sun_direction);
    if (next != first && state.moment.next_fraction > 0.0)
      state.next_map = map_of(next, sun_direction);
    return state;
  }
};

Clouds::Clouds(const scene::CloudsPart& part, double pixel_m, const phenology::FilmSeason* season)
    : pixel_m_(pixel_m), sun_direction_(direction_to(part.sun)) {
  for (std::size_t i = 0; i < part.layers.size(); ++i) {
    const scene::CloudLayer& described = part.layers[i];
    const std::uint64_t key = random_bits({part.seed, key_of("cloud layer"), i});
    const Recipe recipe = recipe_of_layer(described, key);
    const double cell_m = cell_m_of(described);
    const glm::ivec2 cells(described.cells[0], described.cells[1]);
    const glm::ivec2 period_px = period_px_of(cells, cell_m, pixel_m, i);
    const int side_px = std::clamp(period_px.x / cells.x, 1, finest_cell_px);
    TextureSet textures = textures_of(described, recipe, side_px, key);
    auto layer =
        std::make_shared<Layer>(layer_of(key, described, recipe, textures, period_px, pixel_m));
    layer->number = static_cast<int>(i) + 1;
    films_.push_back(std::shared_ptr<LayerHistory>(
        new LayerHistory{layer,
                         std::move(textures),
                         cells,
                         described.repeat == scene::CloudRepeat::paper,
                         key,
                         pixel_m,
                         Timeline(part, i, cell_m, season),
                         {},
                         {}}));
  }
  std::ranges::stable_sort(films_, std::greater<>(),
                           [](const auto& film) { return film->layer->base_m; });
}

double cell_m_of(const scene::CloudLayer& layer) {
  if (layer.cell_m) return *layer.cell_m;
  const Recipe recipe = recipe_of(layer.kind);
  const bool is_heaps = recipe.thermals.weight > 0.0 && layer.textures.empty();
  const double thicker = thickness_m_of(layer, recipe) / recipe.thickness_m;
  return recipe.cell_m * (is_heaps ? std::clamp(thicker, 1.0, widest_heaps) : 1.0);
}

double Clouds::usual_pixel_m(const std::vector<scene::CloudLayer>& layers) {
  const double sharpness = std::ranges::any_of(layers, is_all_in_its_map) ? 2.0 : 1.0;
  const double usual_period_px = 2048.0 * sharpness;
  const double usual_cell_px = 256.0 * sharpness;
  double pixel_m = 0.0, smallest_cell_m = 0.0;
  for (const scene::CloudLayer& layer : layers) {
    const double cell_m = cell_m_of(layer);
    pixel_m =
        std::max(pixel_m, std::max(layer.cells[0], layer.cells[1]) * cell_m / usual_period_px);
    smallest_cell_m = smallest_cell_m == 0.0 ? cell_m : std::min(smallest_cell_m, cell_m);
  }
  return std::max(pixel_m, smallest_cell_m / usual_cell_px);
}

CloudState Clouds::at(double time_s) const { return at(time_s, sun_direction_); }

CloudState Clouds::at(double time_s, const glm::dvec3& sun_direction) const {
  CloudState state{time_s, pixel_m_, {}};
  for (const auto& film : films_) state.layers.push_back(film->at(time_s, sun_direction));
  return state;
}

double droplets_per_seen(const Layer& layer) {
  if (layer.seen_depth <= 0.0) return 1.0;
  return std::max(1.0, layer.droplets.extinction_per_m * layer.thickness_m / layer.seen_depth);
}

double top_m(const Layer& layer, double relative_depth) {
  return layer.thickness_m * math::pow(relative_depth, 0.7);
}

double rank_rise(const Layer& layer, double rank, double field) {
  if (layer.rank_per_field.empty() || field == 0.0) return 0.0;
  return profile_at(layer.rank_per_field, rank) * field;
}

double depth_factor(double amount) { return amount * (2.0 - amount); }

double relative_depth(const Layer& layer, double rank, double amount) {
  const double cover = layer.cover * amount;
  if (cover <= 0.0) return 0.0;
  const double among_clouds = 1.0 - (1.0 - rank) / cover;
  if (among_clouds <= 0.0) return 0.0;
  // Clouds that gather grow and thicken.
  return depth_factor(amount) * profile_at(layer.profile, among_clouds);
}

double optical_depth_of_rank(const Layer& layer, double rank, double amount) {
  return layer.seen_depth * relative_depth(layer, rank, amount);
}

double optical_depth_at(const LayerState& state, double pixel_m, const glm::dvec2& place_m) {
  const LayerMoment& moment = state.moment;
  const glm::dvec2 place_px = (place_m - moment.way_m) / pixel_m;
  const double amount = moment.amount_is_alpha ? 1.0 : moment.amount;
  const auto depth_of = [&](const ShapeMaps& map, double fraction) {
    const double depth = optical_depth_of_rank(*state.layer, rank_at(map.ranks, place_px), amount);
    const double faded = fade(depth, fraction, moment.shapes_by_alpha);
    return moment.amount_is_alpha ? fade(faded, moment.amount, true) : faded;
  };
  const double depth = depth_of(*state.map, 1.0 - moment.next_fraction);
  return state.next_map ? depth + depth_of(*state.next_map, moment.next_fraction) : depth;
}

double mean_transmittance(const CloudState& state, double sine) {
  constexpr int ranks = 64;
  double product = 1.0;
  for (const LayerState& layer : state.layers) {
    const LayerMoment& moment = layer.moment;
    double sum = 0.0;
    for (int i = 0; i < ranks; ++i)
      sum += math::exp(-optical_depth_of_rank(*layer.layer, (i + 0.5) / ranks,
                                              moment.amount_is_alpha ? 1.0 : moment.amount) /
                       sine);
    const double through = sum / ranks;
    product *= moment.amount_is_alpha ? std::lerp(1.0, through, moment.amount) : through;
  }
  return product;
}

}  // namespace wold::cloud
