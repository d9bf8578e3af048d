#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field in an item of [[shots]], for reading and writing alike.
#define ITEM_FIELD(path) ([item](auto& scene) -> auto& { return scene.shots[item].path; })

namespace wold::scene {
namespace {

constexpr ListRule pair = {.min_items = 2, .max_items = 2};
constexpr ListRule place_or_none = {.min_items = 0, .max_items = 3};

std::vector<Key> moment_keys(std::size_t item) {
  return {
      bound(plain(Kind::name, "shots.name", "", {1, 64}, "What people call it."), ITEM_FIELD(name)),
      bound(list(Kind::integers, "shots.date", "", {1, 2999}, {.min_items = 0, .max_items = 3},
                 "Year, month and day on which it begins, in a season."),
            ITEM_FIELD(date)),
      bound(
          automatic("shots.time", "h", {0, 24},
                    "Hour of that day, universal time, at which it begins; \"auto\" is sun.time."),
          ITEM_FIELD(time_h)),
      bound(number("shots.start", "s", {0, 1e9},
                   "Where there is no season: when it begins, on the clock of clouds, weather and "
                   "wind."),
            ITEM_FIELD(start_s)),
      bound(number("shots.seconds", "s", {0.01, 3600},
                   "For how long it is played, at film.frames_per_second."),
            ITEM_FIELD(seconds)),
      bound(
          number("shots.frame_seconds", "s", {0.001, 1e6},
                 "Time that passes in the landscape from one of its frames to the next: 0.0417 at "
                 "24 frames a second is as one sees it, 86400 a day from frame to frame. From an "
                 "hour on, in a season, film.frame_seconds pass for clouds, or they would jump. "
                 "Without it film.frame_seconds."),
          ITEM_FIELD(frame_seconds)),
      bound(list(Kind::numbers, "shots.weathering", "", {0, 1}, {.min_items = 0, .max_items = 2},
                 "Where there is no season: weathering degree, all through, or in its first and in "
                 "its last frame; an empty list is 0."),
            ITEM_FIELD(weathering)),
  };
}

std::vector<Key> shot_camera_keys(std::size_t item) {
  return {
      bound(list(Kind::numbers, "shots.eye", "m", {0, 200000}, pair,
                 "As camera.eye, and so are the keys below; without them [camera] says it."),
            ITEM_FIELD(camera.eye_m)),
      bound(number("shots.eye_height", "m", {0.01, 10000},
                   "Height of the eye above the ground; at least half of it over the snow that "
                   "lies at first."),
            ITEM_FIELD(camera.eye_height_m)),
      bound(list(Kind::numbers, "shots.target", "m", {0, 200000}, pair,
                 "Where the camera looks: east and north, inside the terrain."),
            ITEM_FIELD(camera.target_m)),
      bound(
          number("shots.target_height", "m", {0, 10000}, "Height of that point above the ground."),
          ITEM_FIELD(camera.target_height_m)),
      bound(number("shots.field_of_view", "deg", {5, 150}, "Horizontal angle of view."),
            ITEM_FIELD(camera.field_of_view_deg)),
      bound(list(Kind::numbers, "shots.eye_end", "m", {0, 200000}, place_or_none,
                 "Where the camera has moved to in the shot's last frame: east, north and height "
                 "above the ground; an empty list is nowhere."),
            ITEM_FIELD(camera.eye_end)),
      bound(list(Kind::numbers, "shots.target_end", "m", {0, 200000}, place_or_none,
                 "Where it looks in the shot's last frame, likewise."),
            ITEM_FIELD(camera.target_end)),
  };
}

}  // namespace

std::vector<Key> shot_keys(std::size_t item) {
  std::vector<Key> keys = moment_keys(item);
  for (Key& key : shot_camera_keys(item)) keys.push_back(std::move(key));
  return keys;
}

}  // namespace wold::scene
