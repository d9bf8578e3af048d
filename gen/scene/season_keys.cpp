#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field, for reading and writing alike.
#define FIELD(path) ([](auto& scene) -> auto& { return scene.path; })
/// The same in an item of [[season_keys]].
#define ITEM_FIELD(path) ([item](auto& scene) -> auto& { return scene.season_keys[item].path; })

namespace wold::scene {
namespace {

constexpr ListRule year_month_day = {.min_items = 0, .max_items = 3};

}  // namespace

std::vector<Key> season_keys() {
  return {
      bound(list(Kind::integers, "season.first", "", {1, 2999}, year_month_day,
                 "Year, month and day of the first frame: with it the film is a season, and "
                 "weathering degrees, weather and sun (at sun.time and the sun's place) follow the "
                 "days instead of their own keys; an empty list is no season."),
            FIELD(season.first)),
      bound(list(Kind::integers, "season.last", "", {1, 2999}, year_month_day,
                 "The last frame's; the frames are spread evenly over the days, or lie where "
                 "[[shots]] say."),
            FIELD(season.last)),
      bound(integer("season.frames", "", {2, max_film_frames},
                    "How many frames the season has; with [[shots]] these say it."),
            FIELD(season.frames)),
      bound(
          plain(Kind::file, "season.table", "", {0, 0},
                "Weather day by day as comma-separated values: date (YYYY-MM-DD), tmin_c, tmax_c, "
                "precipitation_mm and, if known, wind_speed_m_s, wind_heading_deg, cloud_cover, "
                "visual_range_m. It should begin some months before the first frame. Relative "
                "paths start at the scene file."),
          FIELD(season.table)),
      bound(number("season.hollow_frost", "K", {0, 15},
                   "How much colder nights are in the deepest hollows, where cold air gathers."),
            FIELD(season.hollow_frost_k)),
      bound(number("season.spread", "days", {0, 30},
                   "Standard deviation of the days by which soil makes places wither earlier or "
                   "later; such places have the size of ageing.age_spread_feature."),
            FIELD(season.spread_days)),
  };
}

std::vector<Key> season_key_keys(std::size_t item) {
  return {
      bound(list(Kind::integers, "season_keys.date", "", {1, 2999}, year_month_day,
                 "Year, month and day on which what follows is so; linear between days that say, "
                 "held before and after; \"auto\" says nothing, and what no day says is as "
                 "season.table, [weather] and [wind] have it."),
            ITEM_FIELD(date)),
      bound(automatic("season_keys.weathering", "", {0, 1},
                      "Weathering degree at the terrain's mean height, instead of what the weather "
                      "makes of the grass."),
            ITEM_FIELD(weathering)),
      bound(automatic("season_keys.temperature", "deg C", {-60, 50},
                      "The day's mean at the terrain's zero."),
            ITEM_FIELD(temperature_c)),
      bound(automatic(
                "season_keys.precipitation", "mm/day", {0, 500},
                "Of water; it falls within some hours, and is seen as heavily as it does then."),
            ITEM_FIELD(precipitation_mm_day)),
      bound(automatic("season_keys.cloud_cover", "", {0, 1},
                      "How much of the layers of clouds has gathered."),
            ITEM_FIELD(cloud_cover)),
      bound(automatic("season_keys.wind_speed", "m/s", {0, 60},
                      "Of the wind that carries flakes; with it, and with where it blows, change "
                      "clouds and the lean of the grass, which are as [[clouds]] and [wind] say "
                      "when it is as [wind] says."),
            ITEM_FIELD(wind_speed_m_s)),
      bound(automatic("season_keys.wind_heading", "deg", {0, 360},
                      "Where it blows to, clockwise from north; it turns the shorter way."),
            ITEM_FIELD(wind_heading_deg)),
      bound(automatic("season_keys.visual_range", "m", {100, 1e6},
                      "As sky.visual_range; rain and snow hide more."),
            ITEM_FIELD(visual_range_m)),
  };
}

}  // namespace wold::scene
