#include "support/snowy_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.h"

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

/// A star of `arms` arms with soft edges.
landscape::FlakePicture star(const char* name, int arms) {
  constexpr int side = 64;
  landscape::FlakePicture picture{name, Image(side, side, 1)};
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) * (2.0 / side) - 1.0;
      const double edge = 0.6 + 0.3 * std::cos(arms * std::atan2(at.y, at.x));
      *picture.opacity.pixel(x, y) =
          static_cast<float>(std::clamp((edge - glm::length(at)) / 0.2, 0.0, 1.0));
    }
  return picture;
}

/// Flake `number`, where a ray to a random place of the picture is at a random distance.
landscape::Flake flake_in_view(const landscape::Landscape& scene, int number, double reach_m) {
  const auto random = [&](const char* purpose) {
    return random_uniform(
        {1, key_of("flake"), static_cast<std::uint64_t>(number), key_of(purpose)});
  };
  const glm::dvec3 forward = glm::normalize(scene.camera.target_m - scene.camera.eye_m);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 0.0, 1.0)));
  const glm::dvec3 up = glm::cross(right, forward);
  const double half_width = std::tan(scene.camera.field_of_view_deg * std::numbers::pi / 360.0);
  const double half_height = half_width * scene.height_px / scene.width_px;
  const double away_m = 0.3 + (reach_m - 0.3) * std::cbrt(random("away"));
  const glm::dvec3 centre_m =
      scene.camera.eye_m + away_m * (forward + right * half_width * (2.0 * random("x") - 1.0) +
                                     up * half_height * (2.0 * random("y") - 1.0));
  const double turn = 2.0 * std::numbers::pi * random("turn");
  const double lean = std::numbers::pi * random("lean");
  const glm::dvec3 own_right(std::cos(turn), std::sin(turn), 0.0);
  const glm::dvec3 own_up = glm::cross(own_right, glm::dvec3(0.0, 0.0, 1.0)) * std::cos(lean) +
                            glm::dvec3(0.0, 0.0, std::sin(lean));
  const double half_m = 0.001 + 0.002 * random("size");
  const double longer = number % 2 == 0 ? 1.0 : 3.0;
  return {glm::vec3(centre_m), glm::vec3(own_right * half_m), glm::vec3(own_up * half_m * longer),
          number % 3, static_cast<float>(random("opacity") / longer)};
}

}  // namespace

void add_flakes(landscape::Landscape& scene, int count, double reach_m) {
  landscape::Flakes& flakes = scene.flakes;
  flakes.radiance = glm::vec3(0.2F, 0.21F, 0.23F);
  flakes.pictures = {star("star_3", 3), star("star_6", 6), star("round", 0)};
  for (int number = 0; number < count; ++number)
    flakes.flakes.push_back(flake_in_view(scene, number, reach_m));
  const auto away_m = [&](const landscape::Flake& flake) {
    return glm::distance(glm::dvec3(flake.centre_m), scene.camera.eye_m);
  };
  std::stable_sort(flakes.flakes.begin(), flakes.flakes.end(),
                   [&](const auto& one, const auto& other) { return away_m(one) > away_m(other); });
}

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
