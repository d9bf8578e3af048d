#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "cloud/diffuse_light.h"

namespace wold::cloud {

/// Radiance that comes from a unit direction.
using Surroundings = std::function<glm::vec3(const glm::dvec3& direction)>;

/// Radiance that travels to an eye through the centre of every voxel, from what lies behind it: of
/// light that left the forward peak, `light` as diffuse_light() has it, and of the surroundings.
std::vector<glm::vec3> light_to_eye(const ScatteringBox& scattering,
                                    const std::vector<LightMoments>& light, const glm::dvec3& eye_m,
                                    const Surroundings& surroundings);

}  // namespace wold::cloud
