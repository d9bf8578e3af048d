#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "advice/scene_warnings.h"
#include "scene/calendar.h"
#include "scene/cloud_consistency.h"
#include "scene/registry.h"
#include "scene/species.h"
#include "scene/winter.h"

namespace wold::advice {
namespace {

using Keys = std::vector<std::string>;

/// A key that only counts when another one is so.
struct Condition {
  const char* key;
  bool holds;
  const char* needs;
};

bool is_given(const scene::Scene& scene, const char* name) {
  static const scene::Scene plain;
  const scene::Key& key = *scene::find_key(name);
  return key.get(scene) != key.get(plain);
}

bool moves(const scene::Camera& camera) {
  return !camera.eye_end.empty() || !camera.target_end.empty();
}

/// In a picture that is blurred by what moves.
bool something_moves(const scene::Scene& scene) {
  return scene.wind.grass == scene::GrassMotion::waving || moves(scene.camera) ||
         std::ranges::any_of(scene.shots,
                             [](const scene::Shot& shot) { return moves(shot.camera); });
}

void warn_of_other_choices(const scene::Scene& scene, Keys& warnings) {
  const bool paper_flakes = scene.snowfall.motion == scene::Law::paper;
  const bool paper_cover = scene.snow_cover.cover == scene::CoverModel::paper;
  const bool real_place = !scene.terrain.elevation.empty();
  for (const Condition& condition : {
           Condition{"snowfall.box", paper_flakes, "snowfall.motion = \"paper\""},
           Condition{"snow_cover.white_after", paper_cover, "snow_cover.cover = \"paper\""},
           Condition{"snow_cover.blowing",
                     scene.snow_cover.blowing <= 0.0 || scene::is_stormy(scene) ||
                         !scene.weather.table.empty() || !scene.season.table.empty(),
                     "snow that lies and a wind.speed of some 7 m/s"},
           Condition{"film.shutter", something_moves(scene),
                     "a camera that moves or wind.grass = \"waving\""},
           Condition{"wind.grass", !scene::has_hair(scene), "grass: hair lies as it is combed"},
           Condition{"terrain.centre", real_place, "terrain.elevation"},
           Condition{"terrain.system", real_place, "terrain.elevation"},
           Condition{"terrain.surroundings", real_place, "terrain.elevation"},
           Condition{"terrain.cover", real_place, "terrain.elevation"},
           Condition{"terrain.photo", real_place, "terrain.elevation"},
           Condition{"terrain.water", real_place, "terrain.elevation"},
       })
    if (!condition.holds && is_given(scene, condition.key))
      warnings.push_back(
          fmt::format("{} changes nothing without {}", condition.key, condition.needs));
}

/// Keys of a layer that is moved as [Wang2010] has it, and of the events that happen to it.
Keys unused_by_paper_motion(const scene::Scene& scene, std::size_t layer) {
  static const scene::CloudLayer usual;
  static const scene::CloudEvent usual_event;
  const scene::CloudLayer& clouds = scene.clouds[layer];
  Keys unused;
  const auto add = [&](bool given, const char* list, std::size_t item, const char* key) {
    if (given) unused.push_back(fmt::format("{}[{}].{}", list, item + 1, key));
  };
  add(clouds.speed_m_s != usual.speed_m_s, "clouds", layer, "speed");
  add(clouds.heading_deg != usual.heading_deg, "clouds", layer, "heading");
  add(clouds.gusts_m_s != usual.gusts_m_s, "clouds", layer, "gusts");
  for (std::size_t item = 0; item < scene.cloud_events.size(); ++item) {
    const scene::CloudEvent& event = scene.cloud_events[item];
    if (!scene::happens_to(event, layer)) continue;
    add(event.speed_m_s != usual_event.speed_m_s, "cloud_events", item, "speed");
    add(event.factor != usual_event.factor, "cloud_events", item, "factor");
  }
  return unused;
}

void warn_of_paper_motion(const scene::Scene& scene, Keys& warnings) {
  for (std::size_t layer = 0; layer < scene.clouds.size(); ++layer) {
    if (scene.clouds[layer].motion != scene::Law::paper) continue;
    const Keys unused = unused_by_paper_motion(scene, layer);
    if (unused.empty()) continue;
    warnings.push_back(fmt::format(
        "clouds[{0}].motion = \"paper\" drifts by 0.0001 cells a frame whatever the speed: {1} "
        "change{2} nothing; set clouds[{0}].motion = \"physical\"",
        layer + 1, fmt::join(unused, ", "), unused.size() == 1 ? "s" : ""));
  }
}

/// A date has its own sun.
void warn_of_sun(const scene::Scene& scene, Keys& warnings) {
  if (scene.sun.date.empty() || scene::is_season(scene)) return;
  for (const char* key : {"sun.elevation", "sun.azimuth"})
    if (is_given(scene, key))
      warnings.push_back(fmt::format(
          "{} changes nothing: sun.date and sun.time say where the sun stands; remove one of them",
          key));
}

/// Patches have a size where a species does not stand everywhere.
void warn_of_features(const scene::Scene& scene, Keys& warnings) {
  for (std::size_t item = 0; item < scene.species.size(); ++item) {
    const scene::Species& species = scene.species[item];
    if (!scene::has_habitat(species) && species.habitat.feature_m != scene::Habitat().feature_m)
      warnings.push_back(
          fmt::format("species[{}].feature changes nothing where the species grows "
                      "everywhere; set its cover or one of its limits",
                      item + 1));
  }
}

/// What a species says of leaves that stalks are not: `usual` has what it would else have.
Keys unused_by_stalks(const scene::Species& species, const scene::Scene& usual) {
  const scene::Plant& plant = species.plant;
  const scene::Physiology& ageing = species.physiology;
  Keys unused;
  const auto add = [&](bool given, const char* key) {
    if (given) unused.emplace_back(key);
  };
  add(plant.bend != usual.grass.bend, "bend");
  add(plant.keel_depth_m != usual.grass.keel_depth_m, "keel_depth");
  add(ageing.droop != usual.ageing.droop, "droop");
  add(ageing.droop_spread != usual.ageing.droop_spread, "droop_spread");
  add(ageing.droop_rule != usual.ageing.droop_rule, "droop_rule");
  add(ageing.litter != usual.ageing.litter, "litter");
  add(ageing.fresh_spread != usual.ageing.fresh_spread, "fresh_spread");
  return unused;
}

/// Stalks are stiff and of this year; without petals there is no flower.
void warn_of_flowers(const scene::Scene& scene, Keys& warnings) {
  for (std::size_t item = 0; item < scene.species.size(); ++item) {
    const scene::Species& species = scene.species[item];
    if (!scene::flowers(species)) {
      if (species.flower != scene::Flower())
        warnings.push_back(
            fmt::format("species[{0}]: what it says of petals and disc changes nothing; set "
                        "species[{0}].petals",
                        item + 1));
      continue;
    }
    const Keys unused = unused_by_stalks(species, scene);
    if (unused.empty()) continue;
    warnings.push_back(fmt::format("species[{}]: {} change{} nothing of stiff stalks with flowers",
                                   item + 1, fmt::join(unused, ", "),
                                   unused.size() == 1 ? "s" : ""));
  }
}

}  // namespace

std::vector<std::string> unused_key_warnings(const scene::Scene& film) {
  Keys warnings;
  warn_of_other_choices(film, warnings);
  warn_of_paper_motion(film, warnings);
  warn_of_features(film, warnings);
  warn_of_flowers(film, warnings);
  warn_of_sun(film, warnings);
  return warnings;
}

}  // namespace wold::advice
