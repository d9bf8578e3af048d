#pragma once

#include <array>
#include <vector>

#include "grass/texel/columns.h"
#include "grass/texel/texel.h"
#include "grass/texel/volume_data.h"

namespace wold::grass {

/// Mean transmittance of a tiled texel from the elevations that levels are matched at.
struct Transmittances {
  static constexpr std::array<double, 3> elevations_deg = {15.0, 45.0, 90.0};
  std::array<double, 3> value{};

  /// Largest difference between two sets.
  static double difference(const Transmittances& a, const Transmittances& b);
};

/// The directions behind Transmittances: two azimuths for each elevation, one for the vertical.
std::vector<glm::dvec3> transmittance_directions(double elevation_deg);

/// `density`: extinction per voxel, 1/m.
Transmittances transmittances(const VoxelRows& voxels, const std::vector<float>& density);

/// The opacity of a level: changes the extinction so that the mean transmittances become `wanted`,
/// in the least-squares sense over the three elevations: density' = density (a + b q + c Q^2),
/// where q and Q in [0, 1] say how filled the voxel and the column over its ground are; always
/// positive. Depths are linear in a, b and c, so the box is swept once per term and
/// Levenberg-Marquardt runs on the rays alone.
///
/// Averaged voxels are too opaque (Jensen's inequality): this is what keeps coarse levels from
/// looking denser.
std::vector<float> fitted_density(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
                                  const std::vector<float>& density, const Transmittances& wanted);

/// The volume without the voxels that are too faint to see, whose area is given to the others, in
/// proportion; unchanged when all are faint.
VolumeData without_faint(const VolumeData& volume);

/// Extent of the same patch cut into `side` voxels per side.
TexelShape coarse_shape(const TexelShape& fine, int side);

/// The same patch with `side` voxels per side: areas add up, emission is averaged by area. The
/// extinction is the plain mean, not yet fitted.
VolumeData coarser(const VolumeData& fine, int side);

/// Mean radiance per turn, seen from a middle elevation.
std::vector<glm::dvec3> radiances(const VolumeData& volume);

/// Scales the emission of each turn so that radiances() become `wanted`; levels then join without a
/// step in brightness.
void match_radiances(VolumeData& volume, const std::vector<glm::dvec3>& wanted);

}  // namespace wold::grass
