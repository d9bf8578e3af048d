#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "cloud/ordinates.h"
#include "cloud/voxel_box.h"

namespace wold::cloud {

/// Light at a place by its mean over all directions and its net flux over 4 pi, a vector along
/// which it travels. Colours are the first three numbers.
struct LightMoments {
  glm::vec4 mean{0.0F};
  std::array<glm::vec4, 3> flux{};  ///< its parts to the east, north and up

  void add(float times, const LightMoments& other) {
    mean += times * other.mean;
    for (std::size_t axis = 0; axis < 3; ++axis) flux[axis] += times * other.flux[axis];
  }

  /// The mean and the flux's part along a direction.
  glm::vec4 along(const glm::vec3& way) const {
    return mean + way.x * flux[0] + way.y * flux[1] + way.z * flux[2];
  }
};

/// What scatters in a box, and the light that comes to it. Extinction is that of droplets which
/// leave in their forward peak what they scatter there: asymmetry^2 of all (Joseph, Wiscombe and
/// Weinman 1976, The delta-Eddington approximation for radiative flux transfer).
struct ScatteringBox {
  VoxelBox box;
  std::vector<float> extinction_per_m;
  std::vector<float> sunlight;  ///< fraction of the sun's light that is left at each voxel
  double asymmetry = 0.46;      ///< of what does not stay in the peak
  glm::vec3 sun_irradiance{0.0F};
  glm::dvec3 sun_direction = {0.0, 0.0, 1.0};  ///< towards it, unit vector
  ArrivingRadiance arriving{};                 ///< from all around
};

/// The same of voxels that are twice as large. Where their number is odd, what the last ones have
/// beyond the box is clear air.
ScatteringBox halved(const ScatteringBox& scattering);

/// Where the numbers of the eight voxels around the centre of one half as large are stored, and
/// what each counts.
struct CoarseNeighbours {
  std::array<std::size_t, 8> voxels;
  std::array<float, 8> weights;

  CoarseNeighbours(const VoxelBox& coarse, const glm::ivec3& fine);
};

/// What droplets send of the sun's light and of diffuse light, without what stays in the peak:
/// along each direction LightMoments::along().
std::vector<LightMoments> scattered(const ScatteringBox& scattering,
                                    const std::vector<LightMoments>& light);

/// Light that was scattered in the box or came from all around, without the sun's own, at the
/// voxels' centres: all orders of scattering without absorption, by discrete ordinates
/// (Chandrasekhar 1960, Radiative Transfer), whose sweeps go from plane to plane with the light.
/// The orders are added one by one, on coarser voxels first, from where finer ones begin. The same
/// for any number of threads.
std::vector<LightMoments> diffuse_light(const ScatteringBox& scattering);

}  // namespace wold::cloud
