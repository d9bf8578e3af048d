#include "grass/optics/light_under_grass.h"

#include "grass/geometry/blade_places.h"
#include "grass/optics/blade_light.h"

namespace wold::grass {

glm::vec3 light_under_grass(const BladePatch& patch, const MeadowModel& model,
                            const Lighting& lighting) {
  constexpr double shadow_pixel_m = 1.5e-3;
  return place_light(patch, blade_places(patch, model).places, lighting, shadow_pixel_m).on_ground;
}

}  // namespace wold::grass
