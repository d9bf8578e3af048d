#include "place/scene_ground.h"

#include "place/cell_window.h"
#include "scene/cover_classes.h"

namespace wold::place {

terrain::Ground scene_ground(const scene::Scene& scene) {
  terrain::Ground ground =
      terrain::make_ground(scene.terrain, scene.seed, scene::cover_classes_of(scene), scene.paths);
  if (!is_large(scene)) {
    ground.finer = nullptr;
    ground.scree = nullptr;
  }
  return ground;
}

}  // namespace wold::place
