#include "scene/consistency.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scene/calendar.h"
#include "scene/cloud_consistency.h"
#include "scene/season_consistency.h"
#include "scene/shot_consistency.h"
#include "scene/species.h"
#include "scene/species_consistency.h"
#include "scene/sun_position.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

/// Soil creeps about a metre, over the more samples the finer they are: what is finer is smooth.
constexpr double max_samples_per_root_m = 376.0;
/// Square metres of leaf per square metre of ground; dense turf has 10.
constexpr double max_leaf_area = 50.0;

Rule inside_terrain(const std::string& key, const std::array<double, 2>& place_m, double size_m) {
  const bool inside =
      place_m[0] >= 0.0 && place_m[0] <= size_m && place_m[1] >= 0.0 && place_m[1] <= size_m;
  return {{key, "terrain.size"},
          inside,
          fmt::format("{}: found [{}, {}] m, expected a place inside the terrain, from 0 to {} m "
                      "(terrain.size)",
                      key, place_m[0], place_m[1], size_m)};
}

Rule looks_somewhere(const std::string& table, const Camera& camera) {
  return {{table + ".target", table + ".eye"},
          camera.eye_m != camera.target_m,
          fmt::format("{0}.target: found [{1}, {2}] m, expected another place than {0}.eye", table,
                      camera.target_m[0], camera.target_m[1])};
}

Rule date_is_a_day(const Sun& sun) {
  const bool complete = sun.date.size() == 3;
  return {{"sun.date"},
          !complete || date_of(sun.date).ok(),
          complete ? fmt::format("sun.date: found [{}, {}, {}], expected a year, month and day of "
                                 "the calendar",
                                 sun.date[0], sun.date[1], sun.date[2])
                   : ""};
}

/// There is day or dusk.
Rule sun_gives_light(const Sun& sun) {
  const bool dated = sun.date.size() == 3 && date_of(sun.date).ok();
  const double elevation_deg = dated ? sun_position(sun).elevation_deg : 90.0;
  return {
      {"sun.time", "sun.date", "sun.latitude", "sun.longitude"},
      elevation_deg >= min_sun_elevation_deg,
      fmt::format("sun.time: found {} h, when the sun stands at {:.1f} degrees, expected a time "
                  "when it stands at {} degrees at least",
                  sun.time_h, elevation_deg, min_sun_elevation_deg)};
}

/// A day has its own sun, and so has a season.
Rule sun_ends_where_it_may(const Scene& scene) {
  constexpr double max_deg = 90.0;
  const std::vector<double>& end = scene.sun.end;
  const bool dated = !scene.sun.date.empty() || is_season(scene);
  const bool up =
      end.size() != 2 || (end[0] >= min_sun_elevation_deg && end[0] <= max_deg && end[1] >= 0.0);
  return {{"sun.end"},
          end.empty() || (up && !dated),
          dated ? "sun.end: found a place, but the sun stands where it stood on a day; expected no "
                  "sun.end, or neither sun.date nor season.first"
                : fmt::format("sun.end: found {} degrees, expected a height of {} to {} and a "
                              "direction of 0 to 360",
                              end, min_sun_elevation_deg, max_deg)};
}

Rule grows_somewhere(const Growth& growth) {
  return {{"growth.highest", "growth.lowest"},
          growth.lowest_m < growth.highest_m,
          fmt::format("growth.highest: found {} m, expected more than {} m (growth.lowest)",
                      growth.highest_m, growth.lowest_m)};
}

Rule has_all_or_none(const std::string& key, std::size_t items, std::size_t all,
                     const char* numbers) {
  return {{key},
          items == 0 || items == all,
          fmt::format("{}: found a list of {}, expected {} numbers, or none", key, items, numbers)};
}

/// Where the camera is in the last frame: east, north, height above the ground.
Rule ends_inside(const std::string& key, const std::vector<double>& end, double size_m,
                 double lowest_m) {
  const bool judged = end.size() == 3;
  const bool inside = !judged || (std::max(end[0], end[1]) <= size_m && end[2] >= lowest_m);
  return {{key, "terrain.size"},
          inside,
          inside ? ""
                 : fmt::format("{}: found [{}, {}, {}] m, expected a place inside the terrain, "
                               "from 0 to {} m (terrain.size), at least {} m above the ground",
                               key, end[0], end[1], end[2], size_m, lowest_m)};
}

/// Of [camera] or of an item of [[shots]], whose keys are the same.
std::vector<Rule> camera_rules(const std::string& table, const Camera& camera, double size_m) {
  std::vector<Rule> rules = {
      has_all_or_none(table + ".eye_end", camera.eye_end.size(), 3, "three"),
      has_all_or_none(table + ".target_end", camera.target_end.size(), 3, "three"),
      inside_terrain(table + ".eye", camera.eye_m, size_m),
      inside_terrain(table + ".target", camera.target_m, size_m),
      looks_somewhere(table, camera),
      ends_inside(table + ".eye_end", camera.eye_end, size_m, 0.01),
      ends_inside(table + ".target_end", camera.target_end, size_m, 0.0),
  };
  for (Rule& rule : rules) rule.keys.push_back(table);
  return rules;
}

Rule a_texel_is_one_sample_of_grass(const Scene& scene) {
  const bool hair = has_hair(scene);
  if (!scene.species.empty())
    return {
        {"grass.from_texel", "species[1]"},
        scene.grass.from_texel.empty(),
        "grass.from_texel: found a volume, expected \"\" with [[species]], which are scattered"};
  return {{"grass.from_texel", "grass.mingle", "fur.clumps"},
          scene.grass.from_texel.empty() || (scene.grass.mingle.empty() && !hair),
          hair ? "grass.from_texel: found a volume, expected \"\" for fur (fur.clumps)"
               : "grass.from_texel: found a volume, expected \"\" with grass.mingle, whose samples "
                 "are scattered"};
}

Rule points_are_not_blurred(const Scene& scene) {
  const bool holds = scene.film.shutter == 0.0 || scene.render.grass != GrassForm::points;
  return {{"film.shutter", "render.grass"},
          holds,
          holds
              ? ""
              : fmt::format("film.shutter: found {}, expected 0 with render.grass = \"points\", of "
                            "which there are no passes",
                            scene.film.shutter)};
}

Rule patch_fits(const Scene& scene) {
  const double size_m = scene.terrain.size_m;
  const double patch_m = scene.grass.patch_m;
  return {{"grass.patch", "terrain.size"},
          patch_m <= size_m,
          fmt::format("grass.patch: found {} m, expected at most {} m (terrain.size)", patch_m,
                      size_m)};
}

Rule heights_are_coarse_enough(const Terrain& terrain) {
  const int max = static_cast<int>(max_samples_per_root_m * std::sqrt(terrain.size_m));
  return {
      {"terrain.samples", "terrain.size"},
      terrain.samples <= max,
      fmt::format("terrain.samples: found {}, expected at most {} on {} m (terrain.size): finer "
                  "heights take erosion long and show no more",
                  terrain.samples, max, terrain.size_m)};
}

Rule blades_leave_room(const Scene& scene) {
  const Grass& grass = scene.grass;
  const double leaf_area = max_blade_area_m2(scene) / (grass.patch_m * grass.patch_m);
  return {{"grass.blades", "grass.patch", "grass.width", "grass.height"},
          leaf_area <= max_leaf_area,
          fmt::format("grass.blades: found {} blades, {:.0f} m2 of leaf on each m2 of ground, "
                      "expected at most {} m2: fewer or smaller blades, leaves of shrubs and "
                      "petals, or a larger grass.patch",
                      grass.blades, leaf_area, max_leaf_area)};
}

/// The place, from 1, that is the same as the one before it; 0: none.
std::size_t place_twice(const std::vector<double>& way_m) {
  for (std::size_t k = 2; k + 1 < way_m.size(); k += 2)
    if (way_m[k] == way_m[k - 2] && way_m[k + 1] == way_m[k - 1]) return k / 2 + 1;
  return 0;
}

/// East and north of two places at least, each inside the terrain and another than the one before.
std::vector<Rule> path_rules(const std::string& table, const std::vector<double>& way_m,
                             double size_m) {
  const std::string key = table + ".way";
  const bool pairs = way_m.size() >= 4 && way_m.size() % 2 == 0;
  const double farthest_m = way_m.empty() ? 0.0 : std::ranges::max(way_m);
  const std::size_t twice = place_twice(way_m);
  return {{{key, table},
           pairs,
           fmt::format("{}: found a list of {}, expected east and north of two places or more: 4, "
                       "6, 8 ... numbers",
                       key, way_m.size())},
          {{key, "terrain.size"},
           farthest_m <= size_m,
           fmt::format("{}: found {} m, expected at most {} m (terrain.size)", key, farthest_m,
                       size_m)},
          {{key},
           twice == 0,
           fmt::format("{}: found place {} where the one before it is, expected another place", key,
                       twice)}};
}

}  // namespace

void report_contradictions(const Scene& scene, const Places& places,
                           std::vector<Problem>& problems) {
  std::vector<Rule> rules = {
      patch_fits(scene),
      heights_are_coarse_enough(scene.terrain),
      blades_leave_room(scene),
      a_texel_is_one_sample_of_grass(scene),
      points_are_not_blurred(scene),
      grows_somewhere(scene.growth),
      has_all_or_none("terrain.centre", scene.terrain.centre.size(), 2, "two"),
      has_all_or_none("sun.date", scene.sun.date.size(), 3, "three"),
      has_all_or_none("sun.end", scene.sun.end.size(), 2, "two"),
      date_is_a_day(scene.sun),
      sun_gives_light(scene.sun),
      sun_ends_where_it_may(scene),
  };
  for (std::size_t item = 0; item < scene.cover_classes.size(); ++item)
    rules.push_back(has_all_or_none(item_name("cover_classes", item) + ".albedo",
                                    scene.cover_classes[item].albedo.size(), 3, "three"));
  const auto add = [&](std::vector<Rule> more) {
    for (Rule& rule : more) rules.push_back(std::move(rule));
  };
  add(camera_rules("camera", scene.camera, scene.terrain.size_m));
  for (std::size_t item = 0; item < scene.shots.size(); ++item)
    add(camera_rules(item_name("shots", item), scene.shots[item].camera, scene.terrain.size_m));
  for (std::size_t item = 0; item < scene.paths.size(); ++item)
    add(path_rules(item_name("paths", item), scene.paths[item].way_m, scene.terrain.size_m));
  add(species_rules(scene));
  report_broken(rules, places, problems);
  report_cloud_contradictions(scene, places, problems);
  report_season_contradictions(scene, places, problems);
  report_shot_contradictions(scene, places, problems);
}

}  // namespace wold::scene
