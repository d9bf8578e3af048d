#include "scene/starter_at_place.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include "scene/species.h"
#include "scene/sun_position.h"

namespace wold::scene {
namespace {

/// What shapes a hill of the scene's own.
const KeyNames& keys_of_own_ground() {
  static const KeyNames names = {"terrain.hill_height",    "terrain.shape",   "terrain.relief",
                                 "terrain.relief_feature", "terrain.streams", "terrain.talus"};
  return names;
}

/// Half a year later.
void move_date(std::vector<std::int64_t>& date) {
  constexpr std::chrono::days half_a_year(182);
  if (date.empty()) return;
  const std::chrono::year_month_day later(std::chrono::sys_days(date_of(date)) + half_a_year);
  date = {static_cast<int>(later.year()), static_cast<unsigned>(later.month()),
          static_cast<unsigned>(later.day())};
}

/// The scene's grass under another name; `share` is relative to that of the grass itself, 1.
Species grass_of(const Scene& scene, const char* name, double share) {
  Species grass = species_of(scene).front();
  grass.name = name;
  grass.share = share;
  return grass;
}

/// Low evergreen bushes amid the grass, as on hills that are grazed: without anything as large the
/// eye does not see how far away a slope is.
Species bushes(const Scene& scene) {
  Species bushes = grass_of(scene, "bushes", 6.0);
  bushes.habitat.cover = 0.12;
  bushes.habitat.feature_m = 1.0;
  bushes.habitat.steepest_deg = 45.0;
  Plant& plant = bushes.plant;
  plant.crown_m = 0.45;
  plant.height_m = 0.035;
  plant.height_spread = 0.35;
  plant.width_m = 0.012;
  plant.lean_deg = 40.0;
  plant.lean_spread_deg = 15.0;
  plant.bend = 0.4;
  plant.mingle = {{"evergreen", {}}};
  Physiology& physiology = bushes.physiology;
  physiology.droop = 0.4;
  physiology.litter = 0.06;
  physiology.fresh_spread = 0.08;
  physiology.chlorophyll_ug_cm2 = 45.0;
  physiology.carotenoid_ug_cm2 = 11.0;
  return bushes;
}

/// Thin, yellowish grass in wide patches, as on poor ground.
Species pale_grass(const Scene& scene) {
  Species grass = grass_of(scene, "pale_grass", 1.0);
  grass.habitat.cover = 0.45;
  grass.habitat.feature_m = 30.0;
  grass.plant.height_m = 0.2;
  grass.plant.width_m = 0.003;
  grass.plant.lean_deg = 22.0;
  grass.physiology.chlorophyll_ug_cm2 = 11.0;
  grass.physiology.brown_pigment = 0.5;
  grass.physiology.fresh_spread = 0.35;
  grass.physiology.litter = 0.8;
  return grass;
}

/// Tall, dark grass in small patches where it is moist.
Species lush_grass(const Scene& scene) {
  Species grass = grass_of(scene, "lush_grass", 1.0);
  grass.habitat.cover = 0.25;
  grass.habitat.feature_m = 8.0;
  grass.habitat.driest = 0.4;
  grass.plant.height_m = 0.42;
  grass.plant.width_m = 0.008;
  grass.plant.lean_deg = 20.0;
  grass.physiology.chlorophyll_ug_cm2 = 38.0;
  grass.physiology.fresh_spread = 0.1;
  grass.physiology.litter = 0.25;
  return grass;
}

/// Yellow flowers amid the grass: two to a patch, one where much else stands.
Species hawkbits(const Scene& scene) {
  Species hawkbits = grass_of(scene, "hawkbit", 0.005);
  Plant& plant = hawkbits.plant;
  plant.height_m = 0.27;
  plant.height_spread = 0.15;
  plant.width_m = 0.0018;
  plant.lean_deg = 10.0;
  Flower& flower = hawkbits.flower;
  flower.petals = 18;
  flower.length_m = 0.014;
  flower.width_m = 0.004;
  flower.opening_deg = 72.0;
  flower.colour = PetalColour::yellow;
  return hawkbits;
}

const KeyNames& keys_of_plants() {
  static const KeyNames names = {"species.name",
                                 "species.share",
                                 "species.cover",
                                 "species.feature",
                                 "species.steepest",
                                 "species.driest",
                                 "species.crown",
                                 "species.height",
                                 "species.height_spread",
                                 "species.width",
                                 "species.lean",
                                 "species.lean_spread",
                                 "species.bend",
                                 "species.mingle",
                                 "species.droop",
                                 "species.litter",
                                 "species.fresh_spread",
                                 "species.chlorophyll_content",
                                 "species.carotenoid_content",
                                 "species.brown_pigment",
                                 "species.petals",
                                 "species.petal_length",
                                 "species.petal_width",
                                 "species.petal_opening",
                                 "species.petal_colour"};
  return names;
}

}  // namespace

void move_to(Scene& scene, const std::array<double, 2>& longitude_latitude_deg) {
  constexpr double deg_per_h = 15.0, day_h = 24.0;
  const auto& [longitude_deg, latitude_deg] = longitude_latitude_deg;
  const double later_h = (scene.sun.longitude_deg - longitude_deg) / deg_per_h;
  const double time_h = std::round(10.0 * (scene.sun.time_h + later_h)) / 10.0;
  scene.sun.time_h = time_h - day_h * std::floor(time_h / day_h);
  scene.sun.longitude_deg = longitude_deg;
  scene.sun.latitude_deg = latitude_deg;
  if (latitude_deg >= 0.0) return;
  move_date(scene.season.first);
  move_date(scene.season.last);
  for (SeasonKey& key : scene.season_keys) move_date(key.date);
}

Starter at_place(Starter starter, const StarterPlace& place) {
  Scene& scene = starter.scene;
  if (place.longitude_latitude_deg) move_to(scene, *place.longitude_latitude_deg);
  scene.terrain = {};
  scene.terrain.elevation = place.elevation;
  scene.terrain.system = place.system;
  scene.terrain.size_m = place.size_m;
  scene.terrain.samples = place.samples;
  scene.sky.visual_range_m = place.visual_range_m;
  scene.camera.eye_m = place.eye_m;
  scene.camera.eye_height_m = place.eye_height_m;
  scene.camera.target_m = place.target_m;
  scene.camera.target_height_m = place.target_height_m;
  std::erase_if(starter.keys, [](std::string_view key) {
    return std::ranges::count(keys_of_own_ground(), key) > 0;
  });
  starter.keys =
      joined(starter.keys, {"terrain.elevation", "terrain.centre", "terrain.size",
                            "terrain.samples", "camera.eye_height", "camera.target_height",
                            "camera.field_of_view", "sky.visual_range"});
  if (!place.system.empty()) starter.keys.emplace_back("terrain.system");
  scene.species = {species_of(scene).front(), pale_grass(scene), lush_grass(scene), bushes(scene),
                   hawkbits(scene)};
  starter.keys = joined(starter.keys, keys_of_plants());
  scene.grass.variants = 2;  // of each of the eight ways in which plants stand together
  starter.keys.emplace_back("grass.variants");
  return starter;
}

}  // namespace wold::scene
