#include "support/snowy_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wold::test {
namespace {

constexpr float ground_radiance = 0.03F;
constexpr float sky_radiance = 0.25F;

/// Opaque by `lower` in its lower half and `upper` in its upper one, but for its border.
landscape::FlakePicture two_halves(const char* name, float lower, float upper) {
  landscape::FlakePicture picture{name, Image(16, 16, 1)};
  for (int y = 1; y < 15; ++y)
    for (int x = 1; x < 15; ++x) *picture.opacity.pixel(x, y) = y < 8 ? upper : lower;
  return picture;
}

/// A flake that faces the camera, which looks north.
landscape::Flake facing(const glm::dvec3& centre_m, float half_m, int picture, float opacity) {
  return {glm::vec3(centre_m), {half_m, 0.0F, 0.0F}, {0.0F, 0.0F, half_m}, picture, opacity};
}

/// What is left of a radiance behind a stretch of fog, and what the fog adds.
double behind_fog(const landscape::Fog& fog, double length_m, double radiance) {
  const double through = std::exp(-fog.extinction_per_m * length_m);
  return radiance * through + double{fog.radiance.g} * (1.0 - through);
}

/// How opaque a flake that faces the camera is where a ray meets its plane.
double opacity_at(const landscape::Flakes& flakes, const landscape::Flake& flake,
                  const glm::dvec3& place_m) {
  const glm::dvec2 at((place_m.x - double{flake.centre_m.x}) / double{flake.right_m.x},
                      (place_m.z - double{flake.centre_m.z}) / double{flake.up_m.z});
  if (std::abs(at.x) >= 1.0 || std::abs(at.y) >= 1.0) return 0.0;
  const Image& picture = flakes.pictures[static_cast<std::size_t>(flake.picture)].opacity;
  const int column = static_cast<int>(0.5 * (at.x + 1.0) * picture.width);
  const int row = static_cast<int>(0.5 * (1.0 - at.y) * picture.height);
  return double{*picture.pixel(column, row)} * double{flake.opacity};
}

}  // namespace

void make_snowy_view(landscape::Landscape& scene) {
  scene.cells.clear();
  scene.blade_cells.clear();
  constexpr double side_m = 2000.0;
  scene.terrain = Heightfield(3, side_m);
  scene.ground = ColourMap(3, side_m, glm::vec3(ground_radiance));
  const glm::dvec3 eye(1000.0, 1000.0, 1.5);
  scene.camera = {eye, eye + glm::dvec3(0.0, 10.0, -0.6), 40.0};
  std::fill(scene.sky.values.begin(), scene.sky.values.end(), sky_radiance);
  scene.fog = landscape::Fog{0.05, glm::vec3(0.12F)};
  landscape::Flakes& flakes = scene.flakes;
  flakes.pictures = {two_halves("solid_and_half", 1.0F, 0.5F), two_halves("faint", 0.4F, 0.7F)};
  flakes.radiance = glm::vec3(0.2F, 0.18F, 0.22F);
  flakes.flakes = {facing(eye + glm::dvec3(0.0, 9.0, -0.9), 0.5F, 0, 0.25F),
                   facing(eye + glm::dvec3(0.3, 6.0, -0.6), 0.3F, 1, 0.6F),
                   facing(eye + glm::dvec3(-1.2, 4.0, 0.4), 0.2F, 0, 0.5F),
                   facing(eye + glm::dvec3(0.2, 2.0, -0.2), 0.05F, 0, 1.0F)};
}

std::vector<glm::dvec3> directions_of_snowy_view() {
  const auto to = [](double x, double y, double z) { return glm::normalize(glm::dvec3(x, y, z)); };
  return {to(2.0, 10.0, -1.0),  to(2.0, 10.0, 1.0),   to(-0.3, 9.0, -1.1),  to(-0.3, 9.0, -0.7),
          to(0.15, 6.0, -0.72), to(0.15, 6.0, -0.45), to(0.18, 2.0, -0.22), to(0.18, 2.0, -0.18),
          to(-1.25, 4.0, 0.5),  to(-1.15, 4.0, 0.3)};
}

double radiance_of_snowy_view(const landscape::Landscape& scene, const glm::dvec3& direction) {
  const glm::dvec3& eye = scene.camera.eye_m;
  const bool sky = direction.z >= 0.0;
  double distance_m = sky ? std::numeric_limits<double>::infinity() : -eye.z / direction.z;
  double radiance = double{sky ? sky_radiance : ground_radiance};
  for (const landscape::Flake& flake : scene.flakes.flakes) {
    const double at_m = (double{flake.centre_m.y} - eye.y) / direction.y;
    const double opacity = opacity_at(scene.flakes, flake, eye + at_m * direction);
    radiance = behind_fog(*scene.fog, distance_m - at_m, radiance) * (1.0 - opacity) +
               double{scene.flakes.radiance.g} * opacity;
    distance_m = at_m;
  }
  return behind_fog(*scene.fog, distance_m, radiance);
}

}  // namespace wold::test
