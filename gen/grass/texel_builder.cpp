#include "grass/texel_builder.h"

#include <cmath>

#include "grass/visible.h"

namespace wold::grass {
namespace {

glm::vec3 times(const float (&d)[6], const glm::vec3& v) {
  return {d[0] * v.x + d[3] * v.y + d[4] * v.z, d[3] * v.x + d[1] * v.y + d[5] * v.z,
          d[4] * v.x + d[5] * v.y + d[2] * v.z};
}

/// The dyad's longest column: never orthogonal to the main axis.
glm::vec3 longest_column(const float (&d)[6]) {
  if (d[0] >= d[1] && d[0] >= d[2]) return {d[0], d[3], d[4]};
  if (d[1] >= d[2]) return {d[3], d[1], d[5]};
  return {d[4], d[5], d[2]};
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0F ? v / length : otherwise;
}

/// Shorter mean normals than this come from both sides of a vein: the vein itself.
constexpr float vein_normal = 0.2F;

}  // namespace

glm::vec3 main_axis(const float (&dyad)[6]) {
  constexpr glm::vec3 up(0.0F, 0.0F, 1.0F);
  glm::vec3 axis = unit_or(longest_column(dyad), up);
  // Power iteration; a blade's own voxels are one fibre, for which the first step is exact.
  for (int step = 0; step < 6; ++step) {
    const glm::vec3 next = unit_or(times(dyad, axis), up);
    const bool settled = glm::dot(next, axis) > 1.0F - 1e-7F;
    axis = next;
    if (settled) break;
  }
  return axis.z < 0.0F ? -axis : axis;
}

TexelBuilder::TexelBuilder(const TexelShape& shape) : shape_(shape), touched_(shape) {}

void TexelBuilder::prepare() {
  voxel_ = touched_.number_members();
  sums_.resize(voxel_.size());
}

void TexelBuilder::add(std::uint32_t voxel, float share, const Contribution& what) {
  Sum& sum = sums_[touched_.place(voxel)];
  const float area = share * what.area_m2;
  const glm::vec3 t = what.tangent;
  sum.area += area;
  sum.dyad[0] += area * t.x * t.x;
  sum.dyad[1] += area * t.y * t.y;
  sum.dyad[2] += area * t.z * t.z;
  sum.dyad[3] += area * t.x * t.y;
  sum.dyad[4] += area * t.x * t.z;
  sum.dyad[5] += area * t.y * t.z;
  sum.normal += area * what.normal;
  sum.albedo += area * what.albedo;
  sum.specular += area * what.specular;
}

Texel TexelBuilder::build() const {
  Texel texel;
  texel.shape = shape_;
  std::vector<float> density(sums_.size());
  for (std::size_t i = 0; i < sums_.size(); ++i)
    density[i] = static_cast<float>(sums_[i].area / shape_.voxel_volume_m3());
  const std::vector<std::uint32_t> kept = visible_voxels(density, shape_);
  const std::size_t count = kept.size();
  texel.voxel.resize(count);
  texel.density.resize(count);
  texel.tangent.resize(count);
  texel.normal.resize(count);
  texel.albedo.resize(count);
  texel.specular.resize(count);
  double all = 0.0;
  double shown = 0.0;
  for (const Sum& sum : sums_) all += double{sum.area};
  for (std::uint32_t i : kept) shown += double{sums_[i].area};
  const auto per_volume = static_cast<float>(all / shown / shape_.voxel_volume_m3());
  for (std::size_t i = 0; i < count; ++i) {
    const Sum& sum = sums_[kept[i]];
    texel.voxel[i] = voxel_[kept[i]];
    const float mean = sum.area > 0.0F ? 1.0F / sum.area : 0.0F;
    const glm::vec3 normal = sum.normal * mean;
    const float length = glm::length(normal);
    texel.density[i] = sum.area * per_volume;
    texel.tangent[i] = main_axis(sum.dyad);
    texel.normal[i] = length > vein_normal ? normal / length : glm::vec3(0.0F);
    texel.albedo[i] = sum.albedo * mean;
    texel.specular[i] = sum.specular * mean;
  }
  return texel;
}

}  // namespace wold::grass
