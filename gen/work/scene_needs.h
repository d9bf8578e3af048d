#pragma once

#include "scene/scene.h"

namespace wold::work {

/// What a renderer has to be able to show, or pictures of the scene would lack it. A film needs it
/// when any frame may.
struct SceneNeeds {
  bool grass_volumes = false;  ///< grass as texels
  bool cloud_volumes = false;
  bool blown_snow = false;  ///< as volumes, in a storm that the scene's keys name
  bool fog = false;         ///< far flakes, as a homogeneous medium
};

SceneNeeds needs_of(const scene::Scene& scene);

inline bool needs_volumes(const SceneNeeds& needs) {
  return needs.grass_volumes || needs.cloud_volumes || needs.blown_snow;
}

}  // namespace wold::work
