#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field, for reading and writing alike.
#define FIELD(path) ([](auto& scene) -> auto& { return scene.path; })

namespace wold::scene {

std::vector<Key> weather_keys() {
  return {
      bound(
          number("weather.temperature", "deg C", {-60, 50},
                 "At the terrain's zero; it falls by 6.5 degrees per km of height. Below 1 degree "
                 "precipitation is snow."),
          FIELD(weather.temperature_c)),
      bound(number("weather.precipitation", "mm/h", {0, 50},
                   "Of water: rain, or snow by the temperature. The sky is overcast as far as it "
                   "falls."),
            FIELD(weather.precipitation_mm_h)),
      bound(plain(Kind::file, "weather.table", "", {0, 0},
                  "Weather over time as comma-separated values: columns hours, and any of "
                  "temperature_c, precipitation_mm_h, wind_speed_m_s and wind_heading_deg, which "
                  "win over the keys. Relative paths start at the scene file."),
            FIELD(weather.table)),
      bound(
          number("weather.earlier", "h", {0, 10000},
                 "How long the weather had lasted when the film starts: the snow that lies in its "
                 "first frame fell then."),
          FIELD(weather.earlier_h)),
  };
}

std::vector<Key> snowfall_keys() {
  return {
      bound(
          word("snowfall.strength",
               "How much snow falls: the weather's precipitation, or 0.4, 1.2 or 4 mm of water an "
               "hour."),
          FIELD(snowfall.strength)),
      bound(word("snowfall.motion",
                 "Flakes of physical sizes at their terminal speeds, or as the paper has them."),
            FIELD(snowfall.motion)),
      bound(word("snowfall.crystal", "What near flakes look like."), FIELD(snowfall.crystal)),
      bound(integer("snowfall.flakes", "", {0, 1000000},
                    "Flakes drawn in the picture, about; more of the far ones are drawn singly. 0 "
                    "is 30000, or the paper's 500, 1000 or 4000 for its motion. All others dim and "
                    "whiten the air."),
            FIELD(snowfall.flakes)),
      bound(list(Kind::numbers, "snowfall.box", "m", {1, 1000}, {.min_items = 3, .max_items = 3},
                 "Paper: the box before the eye in which flakes fall, east, north and up."),
            FIELD(snowfall.box_m)),
      bound(
          number("snowfall.shutter", "s", {0, 1}, "How long a picture is exposed: flakes streak."),
          FIELD(snowfall.shutter_s)),
  };
}

std::vector<Key> rainfall_keys() {
  return {
      bound(integer("rainfall.drops", "", {0, 1000000},
                    "Drops drawn in the picture, about; 0 is 30000. All others dim and whiten the "
                    "air."),
            FIELD(rainfall.drops)),
      bound(number("rainfall.shutter", "s", {0, 1},
                   "How long a picture is exposed for drops: the longer, the longer and fainter "
                   "their streaks."),
            FIELD(rainfall.shutter_s)),
  };
}

std::vector<Key> snow_cover_keys() {
  return {
      bound(
          word("snow_cover.cover",
               "Snow of a depth that follows the weather, the paper's whitening by growing noise, "
               "or none."),
          FIELD(snow_cover.cover)),
      bound(number("snow_cover.initial", "mm", {0, 5000},
                   "Water of the snow that lies when the weather begins: 10 mm are 8 cm, 100 mm 44 "
                   "cm, 300 mm 1 m."),
            FIELD(snow_cover.initial_mm)),
      bound(
          number("snow_cover.drifting", "", {0, 1},
                 "How much the wind moves snow into the lee and carves its surface: 0 not at all."),
          FIELD(snow_cover.drifting)),
      bound(number("snow_cover.blowing", "", {0, 10},
                   "How much of it storms lift into the air over the ground, times what has been "
                   "measured: 0 none."),
            FIELD(snow_cover.blowing)),
      bound(number("snow_cover.melt", "mm/day", {0, 20},
                   "Water that melts per day and degree above freezing; in a season sun, air and "
                   "rain melt it instead."),
            FIELD(snow_cover.melt_mm_per_day)),
      bound(number("snow_cover.feature", "m", {0.02, 100},
                   "Size of the first patches of white; on large terrains of the smallest: they "
                   "have all sizes there."),
            FIELD(snow_cover.feature_m)),
      bound(number("snow_cover.white_after", "mm", {0.001, 1000},
                   "Paper: snowfall, as water, after which the noise has its full strength."),
            FIELD(snow_cover.white_after_mm)),
  };
}

}  // namespace wold::scene
