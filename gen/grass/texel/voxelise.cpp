#include "grass/texel/voxelise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::grass {
namespace {

constexpr float golden_angle = 2.39996323F;  // spreads the points of a disc evenly (Vogel 1979)
constexpr float quarter_pi = std::numbers::pi_v<float> / 4.0F;
/// Matter nearer to the axis than this fraction of the radius is vein.
constexpr float vein_radius = 0.35F;

/// A bit of a blade: where, how much, how far off the axis (in units of the local radius).
struct Speck {
  glm::ivec3 voxel;
  float area_m2;
  glm::vec3 offset;
};

/// Orthonormal frame whose z axis is the blade's.
struct AxisFrame {
  explicit AxisFrame(const Blade& blade)
      : along(blade.heading * math::sin(blade.lean), math::cos(blade.lean)),
        across(-blade.heading.y, blade.heading.x, 0.0F),
        side(glm::cross(across, along)) {}
  glm::vec3 along, across, side;
};

/// One slice of the cone, its area spread over the disc.
void add_slice(const Blade& blade, const AxisFrame& frame, float arc_m, float slice_m,
               const TexelShape& shape, std::vector<Speck>& specks) {
  const float radius = blade.radius_m * (1.0F - arc_m / blade.length_m);
  const float area = quarter_pi * 2.0F * radius * slice_m;
  const auto voxel_m = static_cast<float>(shape.voxel_m);
  const int count =
      std::max(3, static_cast<int>(std::ceil(12.0F * radius * radius / voxel_m / voxel_m)));
  const glm::vec3 centre = foot_m(blade) + frame.along * arc_m;
  for (int k = 0; k < count; ++k) {
    const float weight = std::sqrt((static_cast<float>(k) + 0.5F) / static_cast<float>(count));
    const float turn = golden_angle * static_cast<float>(k);
    const glm::vec3 offset =
        weight * (math::cos(turn) * frame.across + math::sin(turn) * frame.side);
    const glm::vec3 place = (centre + offset * radius) / voxel_m;
    const glm::ivec3 voxel(glm::floor(place));
    specks.push_back(
        {{voxel.x, voxel.y, std::max(voxel.z, 0)}, area / static_cast<float>(count), offset});
  }
}

bool before(const glm::ivec3& a, const glm::ivec3& b) {
  return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
}

/// Sums up the specks of each voxel.
std::vector<BladeVoxel> gathered(std::vector<Speck>& specks) {
  std::stable_sort(specks.begin(), specks.end(),
                   [](const Speck& a, const Speck& b) { return before(a.voxel, b.voxel); });
  std::vector<BladeVoxel> voxels;
  for (const Speck& speck : specks) {
    if (voxels.empty() || voxels.back().voxel != speck.voxel) voxels.push_back({speck.voxel});
    voxels.back().area_m2 += speck.area_m2;
    voxels.back().normal += speck.offset * speck.area_m2;
  }
  for (BladeVoxel& voxel : voxels) {
    const glm::vec3 offset = voxel.normal / voxel.area_m2;
    const float distance = glm::length(offset);
    voxel.normal = distance > vein_radius ? offset / distance : glm::vec3(0.0F);
  }
  return voxels;
}

}  // namespace

double cone_area_m2(const Blade& blade) {
  return std::numbers::pi / 4.0 * double{blade.length_m} * double{blade.radius_m};
}

std::vector<BladeVoxel> voxelise_blade(const Blade& blade, const TexelShape& shape) {
  const AxisFrame frame(blade);
  const int slices =
      std::max(4, static_cast<int>(std::ceil(2.0 * double{blade.length_m} / shape.voxel_m)));
  const float slice_m = blade.length_m / static_cast<float>(slices);
  std::vector<Speck> specks;
  for (int slice = 0; slice < slices; ++slice)
    add_slice(blade, frame, (static_cast<float>(slice) + 0.5F) * slice_m, slice_m, shape, specks);
  return gathered(specks);
}

}  // namespace wold::grass
