#include "work/scene_needs.h"

#include <algorithm>

#include "scene/winter.h"

namespace wold::work {

SceneNeeds needs_of(const scene::Scene& scene) {
  const auto is_volume = [](const scene::CloudLayer& layer) {
    return layer.body == scene::CloudBody::volume;
  };
  using enum scene::GrassForm;
  return {.grass_volumes = scene.render.grass == texels || scene.render.grass == automatic,
          .cloud_volumes = std::ranges::any_of(scene.clouds, is_volume),
          .blown_snow = scene::is_stormy(scene),
          .fog = scene::may_snow(scene)};
}

}  // namespace wold::work
