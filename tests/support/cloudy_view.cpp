#include "support/cloudy_view.h"

#include <algorithm>
#include <cmath>

namespace wold::test {
namespace {

constexpr float extinction_per_m = 0.01F;
constexpr float cloud_radiance = 0.12F;
constexpr float upper_radiance = 0.06F;
constexpr float lower_radiance = 0.03F;

}  // namespace

void make_cloudy_view(landscape::Landscape& scene) {
  scene.cells.clear();
  scene.blade_cells.clear();
  scene.camera = {{1.5, 1.5, 5.0}, {1.5, 231.5, 45.0}, 40.0};
  landscape::CloudBox cloud{"cloud_1", {12, 6, 8}, 10.0, {-20.0, 200.0, 10.0}, {}, {}};
  cloud.extinction_per_m.assign(12 * 6 * 8, extinction_per_m);
  cloud.radiance.assign(12 * 6 * 8, glm::vec3(cloud_radiance));
  scene.clouds = {cloud};
  landscape::Backdrop backdrop{
      Image(64, 36, 3), {-298.5, 600.0, -100.0}, {600.0, 0.0, 0.0}, {0.0, 0.0, 400.0}};
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 64; ++x)
      std::fill_n(backdrop.picture.pixel(x, y), 3, y < 18 ? upper_radiance : lower_radiance);
  scene.backdrop = backdrop;
}

double radiance_of_cloudy_view(const landscape::Landscape& scene, const glm::dvec3& direction) {
  const landscape::CloudBox& box = scene.clouds.front();
  const glm::dvec3 low = (box.corner_m - scene.camera.eye_m) / direction;
  const glm::dvec3 high =
      (box.corner_m + glm::dvec3(box.voxels) * box.voxel_m - scene.camera.eye_m) / direction;
  const glm::dvec3 in = glm::min(low, high);
  const glm::dvec3 out = glm::max(low, high);
  const double length_m =
      std::max(0.0, std::min({out.x, out.y, out.z}) - std::max({in.x, in.y, in.z}));
  const double through = std::exp(-double{extinction_per_m} * length_m);
  const landscape::Backdrop& backdrop = *scene.backdrop;
  const double away = (backdrop.corner_m.y - scene.camera.eye_m.y) / direction.y;
  const double up = scene.camera.eye_m.z + away * direction.z - backdrop.corner_m.z;
  const double behind = double{up > 0.5 * backdrop.up_m.z ? upper_radiance : lower_radiance};
  return double{cloud_radiance} * (1.0 - through) + behind * through;
}

}  // namespace wold::test
