#include "terrain/ground.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "terrain/creep.h"
#include "terrain/elevation.h"
#include "terrain/hillside.h"
#include "terrain/model_lakes.h"
#include "terrain/mountain.h"
#include "terrain/relief.h"

namespace wold::terrain {
namespace {

/// The finest step that heights need: soil has levelled what is smaller.
constexpr double finest_step_m = 1.0;

/// The relief below the model's cells, or below the heights' steps where these are coarser.
FinerRelief relief_below(scene::Terrain terrain, double cell_m, std::uint64_t seed) {
  constexpr int least = 17, most = 4097;
  const double step_m = terrain.size_m / (terrain.samples - 1);
  const double samples = 2.0 * terrain.size_m / std::max(cell_m, step_m) + 1.0;
  terrain.samples = static_cast<int>(std::clamp<double>(samples, least, most));
  const Elevation place = read_elevation(terrain);
  const bool between_cells = place.heights_m.step_m() < cell_m;
  return {place.heights_m,
          measured_roughness(place.heights_m,
                             between_cells ? Held::by_cubic_convolution : Held::exactly),
          terrain.roughness, seed};
}

template <class Heights>
void add_relief(Heights& heights_m, const FinerRelief& relief) {
  const FinerRelief::Weights weights = relief.shown_at(heights_m.step_m());
  parallel_for(static_cast<std::size_t>(heights_m.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < heights_m.samples(); ++i) {
      auto& height_m = heights_m.at(i, j);
      const double bump_m = relief.at(heights_m.place_m(i, j), weights).height_m;
      height_m = static_cast<std::decay_t<decltype(height_m)>>(height_m + bump_m);
    }
  });
}

/// The lakes of the model and of its cover, if the scene has any.
std::shared_ptr<const Water> water_of(const scene::Terrain& terrain, const LandCover* cover,
                                      double zero_m, const Heightfield& heights_m,
                                      std::uint64_t seed) {
  if (terrain.water == scene::WaterSource::none) return nullptr;
  auto lakes = model_lakes(terrain, zero_m);
  if (cover != nullptr) lakes = with_covered_water(std::move(lakes), *cover, heights_m);
  return lakes ? std::make_shared<const Water>(std::move(*lakes), seed) : nullptr;
}

Ground real_place(const scene::Terrain& terrain, std::uint64_t seed,
                  const std::vector<scene::CoverClass>& cover_classes) {
  Elevation place = read_elevation(terrain);
  std::shared_ptr<const FinerRelief> relief;
  if (terrain.relief_m > 0.0) {
    relief = std::make_shared<const FinerRelief>(relief_below(terrain, place.cell_m, seed));
    add_relief(place.heights_m, *relief);
  }
  if (place.heights_m.step_m() <= finest_step_m) relief = nullptr;
  Ground ground{crept(std::move(place.heights_m)), std::move(relief)};
  if (auto cover = read_land_cover(terrain, cover_classes, seed))
    ground.cover = std::make_shared<const LandCover>(std::move(*cover));
  if (auto photo = read_photo(terrain, ground.heights_m))
    ground.photo = std::make_shared<const Photo>(std::move(*photo));
  ground.water = water_of(terrain, ground.cover.get(), place.zero_m, ground.heights_m, seed);
  if (ground.water) ground.water->settle(ground.heights_m);
  return ground;
}

/// The heights of a landscape of the scene's own at a fraction of its relief's largest features.
GroundMap<double> at_features(const Heightfield& heights_m, const scene::Terrain& terrain) {
  constexpr double cells_per_feature = 8.0;
  const double cell_m = terrain.relief_feature_m / cells_per_feature;
  const double step_m = 0.5 * std::max(cell_m, heights_m.step_m());
  const int samples = std::max(17, static_cast<int>(heights_m.size_m() / step_m) + 1);
  GroundMap<double> map(samples, heights_m.square());
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      map.at(i, j) = double{heights_m.sample(at_m.x, at_m.y)};
    }
  return map;
}

/// Of such a landscape, which streams, slides and creep have smoothed more than weather smooths
/// rock: as rough as its fractal relief is at this size, a third of that where soil lies and more
/// on steep ground, where rock stands. Modelling choices.
Roughness own_roughness(const GroundMap<double>& heights_m, const scene::Terrain& terrain) {
  constexpr double of_soil = 0.3, of_rock = 2.5, strip_deg = 15.0;
  const double wave_m = FinerRelief::cell_m(heights_m);
  const double fractal_m =
      terrain.relief_m * math::pow(wave_m / terrain.relief_feature_m, terrain.roughness);
  Roughness roughness{
      FactorMap(heights_m.samples(), heights_m.square()),
      FactorMap(heights_m.samples(), heights_m.square(), static_cast<float>(terrain.roughness))};
  const Heightfield heights = crept(heights_m);
  for (int j = 0; j < heights_m.samples(); ++j)
    for (int i = 0; i < heights_m.samples(); ++i) {
      const glm::dvec2 at_m = heights_m.place_m(i, j);
      const double steep =
          glm::smoothstep(terrain.rock_slope_deg - strip_deg, terrain.rock_slope_deg,
                          slope_deg(heights, at_m.x, at_m.y));
      roughness.deviation_m.at(i, j) =
          static_cast<float>(fractal_m * std::lerp(of_soil, of_rock, steep));
    }
  return roughness;
}

Ground own_place(const scene::Terrain& terrain, std::uint64_t seed) {
  Heightfield heights_m = terrain.shape == scene::TerrainShape::mountain
                              ? make_mountain(terrain, seed)
                              : make_hillside(terrain, seed);
  if (terrain.relief_m <= 0.0 || heights_m.step_m() <= finest_step_m)
    return {std::move(heights_m), nullptr};
  const GroundMap<double> features_m = at_features(heights_m, terrain);
  const auto relief = std::make_shared<const FinerRelief>(
      features_m, own_roughness(features_m, terrain), terrain.roughness, seed);
  add_relief(heights_m, *relief);
  return {std::move(heights_m), relief};
}

}  // namespace

Ground make_ground(const scene::Terrain& terrain, std::uint64_t seed,
                   const std::vector<scene::CoverClass>& cover_classes,
                   const std::vector<scene::Path>& paths) {
  Ground ground = terrain.elevation.empty() ? own_place(terrain, seed)
                                            : real_place(terrain, seed, cover_classes);
  if (ground.finer)
    ground.scree = std::make_shared<const Scree>(ground.heights_m, terrain.rock_slope_deg, seed);
  if (std::ranges::any_of(paths, [](const scene::Path& path) { return !path.way_m.empty(); }))
    ground.paths = std::make_shared<const Paths>(ground.heights_m, paths, seed, ground.water.get());
  if (terrain.grazing_steps > 0.0)
    ground.grazing_steps =
        std::make_shared<const GrazingSteps>(terrain.grazing_steps, terrain.rock_slope_deg, seed);
  if (terrain.boulders_per_hectare > 0.0)
    ground.boulders = std::make_shared<const Boulders>(
        ground.heights_m, terrain, seed, ground.scree.get(), ground.water, ground.paths);
  return ground;
}

}  // namespace wold::terrain
