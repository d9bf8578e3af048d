#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field in an item of [[paths]], for reading and writing alike.
#define ITEM_FIELD(path) ([item](auto& scene) -> auto& { return scene.paths[item].path; })

namespace wold::scene {

std::vector<Key> path_keys(std::size_t item) {
  return {
      bound(list(Kind::numbers, "paths.way", "m", {0, 200000}, {.min_items = 0, .max_items = 60},
                 "East and north of each place that it leads to, one after the other, inside the "
                 "terrain: two places at least. From one to the next it goes as people walk, round "
                 "what is steep, as finely as a 160th of the distance."),
            ITEM_FIELD(way_m)),
      bound(number("paths.width", "m", {0.1, 10}, "Width of what feet have worn bare."),
            ITEM_FIELD(width_m)),
  };
}

}  // namespace wold::scene
