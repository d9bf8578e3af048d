#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field in an item of [[cover_classes]], for reading and writing alike.
#define ITEM_FIELD(path) ([item](auto& scene) -> auto& { return scene.cover_classes[item].path; })

namespace wold::scene {

std::vector<Key> cover_class_keys(std::size_t item) {
  return {
      bound(integer("cover_classes.number", "", {0, 65535},
                    "A number in terrain.cover; with any of these tables, the numbers of no other "
                    "legend count."),
            ITEM_FIELD(number)),
      bound(number("cover_classes.grass", "", {0, 1},
                   "Share of such ground on which grass grows, within the limits of [growth]."),
            ITEM_FIELD(grass)),
      bound(number("cover_classes.water", "", {0, 1}, "1 is water, 0 is land."), ITEM_FIELD(water)),
      bound(
          list(Kind::numbers, "cover_classes.albedo", "", {0, 1}, {.min_items = 0, .max_items = 3},
               "Colour of what stands or lies there beside the grass, linear red, green and "
               "blue; an empty list is soil and rock."),
          ITEM_FIELD(albedo)),
  };
}

}  // namespace wold::scene
