#include "scene/starter_at_place.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string_view>

#include "scene/starter_plants.h"
#include "scene/sun_position.h"

namespace wold::scene {
namespace {

/// What shapes a hill of the scene's own.
const KeyNames& keys_of_own_ground() {
  static const KeyNames names = {
      "terrain.hill_height", "terrain.shape", "terrain.relief",   "terrain.relief_feature",
      "terrain.streams",     "terrain.talus", "terrain.boulders", "terrain.grazing_steps",
      "paths.way",           "paths.width"};
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
  scene.paths = {};
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
  let_grow(starter, {pale_grass(scene), lush_grass(scene), bushes(scene), hawkbits(scene)});
  return starter;
}

}  // namespace wold::scene
