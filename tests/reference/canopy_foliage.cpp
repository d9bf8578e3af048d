#include "reference/canopy_foliage.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "grass/geometry/blade_tubes.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"
#include "light/daylight.h"
#include "mitsuba/leaf_files.h"

namespace wold::test {
namespace {

using std::numbers::pi;

/// Blades with reflectance and transmittance; how they are lit does not matter.
Tubes tubes_of(const grass::BladePatch& patch, const grass::MeadowModel& model,
               const scene::Scene& scene) {
  const grass::Lighting any =
      grass::make_lighting(light::Daylight(scene.sun, scene.sky), {0.0, 0.0, 1.0}, glm::vec3(0.0F));
  Tubes tubes = grass::blade_tubes(patch, model, any, {}, patch.patch_m);
  grass::add_leaf_shades(patch, model, tubes);
  return tubes;
}

/// Where a corner of a leaf has its colour.
std::size_t ring_at(const Tubes& tubes, const glm::vec2& uv) {
  const auto ring = static_cast<std::size_t>(uv.x * static_cast<float>(tubes.rings));
  const auto tube = static_cast<std::size_t>(uv.y * static_cast<float>(tubes.count()));
  return tube * static_cast<std::size_t>(tubes.rings) + ring;
}

LeafBit bit_of(const mitsuba::Mesh& mesh, const std::array<std::uint32_t, 3>& triangle,
               const Tubes& tubes) {
  const auto corner = [&](int i) { return glm::dvec3(mesh.vertices[triangle[i]].place_m); };
  const glm::dvec3 normal = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
  const double twice_m2 = glm::length(normal);
  LeafBit bit{0.5 * twice_m2, std::acos(std::min(1.0, std::abs(normal.z) / twice_m2)), 0.0,
              glm::dvec3(0.0), glm::dvec3(0.0)};
  for (int i = 0; i < 3; ++i) {
    const std::size_t ring = ring_at(tubes, mesh.vertices[triangle[i]].uv);
    bit.height_m += corner(i).z / 3.0;
    bit.reflectance += glm::dvec3(tubes.reflectance[ring]) / 3.0;
    bit.transmittance += glm::dvec3(tubes.transmittance[ring]) / 3.0;
  }
  return bit;
}

/// Both edges of all leaves.
double outline_m(const mitsuba::Mesh& mesh, const Tubes& tubes) {
  double sum_m = 0.0;
  const auto per_tube = 2 * static_cast<std::size_t>(tubes.rings);
  for (std::size_t v = 2; v < mesh.vertices.size(); ++v)
    if (v % per_tube > 1)
      sum_m += glm::distance(mesh.vertices[v].place_m, mesh.vertices[v - 2].place_m);
  return sum_m;
}

}  // namespace

CanopyFoliage::CanopyFoliage(const scene::Scene& scene, double weathering) {
  const grass::MeadowModel model(scene);
  for (int variant = 0; variant < scene.grass.variants; ++variant) {
    const grass::BladePatch patch = grass::WitheringPatch(scene, model, variant).at(weathering);
    const Tubes tubes = tubes_of(patch, model, scene);
    const mitsuba::Mesh mesh = mitsuba::leaf_mesh(tubes);
    for (const auto& triangle : mesh.triangles) {
      bits_.push_back(bit_of(mesh, triangle, tubes));
      area_m2_ += bits_.back().area_m2;
    }
    outline_m_ += outline_m(mesh, tubes);
    ground_m2_ += patch.patch_m * patch.patch_m;
  }
  std::ranges::sort(bits_, std::greater<>(), &LeafBit::height_m);
}

double CanopyFoliage::hot_spot() const {
  double height_m = 0.0;
  for (const LeafBit& bit : bits_) height_m += 2.0 * bit.height_m * bit.area_m2 / area_m2_;
  return pi * area_m2_ / outline_m_ / height_m;
}

LeafAngles leaf_angles(const std::vector<LeafBit>& bits) {
  constexpr int classes = 18;
  constexpr double width = pi / 2.0 / classes;
  LeafAngles angles{std::vector<double>(classes), std::vector<double>(classes)};
  for (int i = 0; i < classes; ++i)
    angles.inclination[static_cast<std::size_t>(i)] = (i + 0.5) * width;
  double area_m2 = 0.0;
  for (const LeafBit& bit : bits) area_m2 += bit.area_m2;
  for (const LeafBit& bit : bits) {
    const int at = std::min(static_cast<int>(bit.inclination / width), classes - 1);
    angles.fraction[static_cast<std::size_t>(at)] += bit.area_m2 / area_m2;
  }
  return angles;
}

void MeanLeaf::add(const LeafBit& bit) {
  area_m2 += bit.area_m2;
  const double share = bit.area_m2 / area_m2;
  reflectance = glm::mix(reflectance, bit.reflectance, share);
  transmittance = glm::mix(transmittance, bit.transmittance, share);
}

Leaf MeanLeaf::leaf(int channel) const { return {reflectance[channel], transmittance[channel]}; }

}  // namespace wold::test
