#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "advice/scene_warnings.h"
#include "core/elementary.h"
#include "core/pinhole.h"
#include "place/view.h"
#include "scene/registry.h"
#include "scene/shots.h"
#include "scene/species.h"

namespace wold::advice {
namespace {

/// A camera over the plane that its feet and its target's lie in: places on the ground, heights
/// above it.
struct Pose {
  glm::dvec2 eye_m;
  double eye_height_m;
  glm::dvec2 target_m;
  double target_height_m;
  double pixels_per_radian;
};

glm::dvec3 on_the_way(const std::array<double, 2>& from_m, double height_m,
                      const std::vector<double>& end, double time) {
  const glm::dvec3 from(from_m[0], from_m[1], height_m);
  return end.empty() ? from : glm::mix(from, glm::dvec3(end[0], end[1], end[2]), time);
}

Pose pose_at(const scene::Scene& scene, const scene::Camera& camera, double time) {
  const glm::dvec3 eye = on_the_way(camera.eye_m, camera.eye_height_m, camera.eye_end, time);
  const glm::dvec3 target =
      on_the_way(camera.target_m, camera.target_height_m, camera.target_end, time);
  return {glm::dvec2(eye), eye.z, glm::dvec2(target), target.z,
          pixels_per_radian(camera.field_of_view_deg, scene.render.size_px[0])};
}

std::vector<Pose> poses(const scene::Scene& scene) {
  std::vector<Pose> all;
  for (const scene::Camera& on_ground : scene::cameras_of(scene)) {
    const scene::Camera camera = place::on_snow(scene, on_ground);
    const bool moves = !camera.eye_end.empty() || !camera.target_end.empty();
    for (const double time : {0.0, 0.5, 1.0})
      if (moves || time == 0.0) all.push_back(pose_at(scene, camera, time));
  }
  return all;
}

/// How far the grass at the picture's lower edge is away; infinite where that looks into the sky.
double nearest_grass_m(const scene::Scene& scene, const Pose& pose) {
  const double half_height = 0.5 * scene.render.size_px[1] / pose.pixels_per_radian;
  const double ahead_m = std::max(glm::distance(pose.eye_m, pose.target_m), 1e-6);
  const double down_rad =
      math::atan2(pose.eye_height_m - pose.target_height_m, ahead_m) + math::atan(half_height);
  if (down_rad <= 0.0) return std::numeric_limits<double>::infinity();
  const double above_m =
      std::max(pose.eye_height_m - 0.5 * scene::mean_grass(scene).height_m, 1e-3);
  return above_m / math::sin(std::min(down_rad, glm::half_pi<double>()));
}

/// "render.grass = ...", and a finer level if one will do.
std::string finer_grass(const scene::Scene& scene, double pixels_per_m) {
  const auto& possible = scene::find_key("grass.levels")->members;
  std::vector<int> lods = scene.grass.lods;
  std::string way = "set render.grass = \"auto\", which draws blades there";
  for (const std::int64_t voxels : std::vector<std::int64_t>(possible.rbegin(), possible.rend()))
    if (voxels > lods.front() && scene.grass.patch_m / static_cast<double>(voxels) * pixels_per_m <=
                                     scene.grass.pixels_per_voxel) {
      if (lods.size() >= possible.size()) lods.pop_back();
      lods.insert(lods.begin(), static_cast<int>(voxels));
      return fmt::format("set grass.levels = [{}], or {}", fmt::join(lods, ", "), way.substr(4));
    }
  return way;
}

void warn_of_coarse_texels(const scene::Scene& scene, std::vector<std::string>& warnings) {
  if (scene.render.grass != scene::GrassForm::texels) return;
  double nearest_m = std::numeric_limits<double>::infinity(), pixels_per_m = 0.0;
  for (const Pose& pose : poses(scene)) {
    const double here_m = nearest_grass_m(scene, pose);
    if (pose.pixels_per_radian / here_m <= pixels_per_m) continue;
    nearest_m = here_m;
    pixels_per_m = pose.pixels_per_radian / here_m;
  }
  const double voxel_m = scene.grass.patch_m / scene.grass.lods.front();
  constexpr double unseen = 1.5;  // at the picture's lower edge alone
  if (voxel_m * pixels_per_m <= unseen * scene.grass.pixels_per_voxel) return;
  warnings.push_back(fmt::format(
      "grass looks coarse {:.2g} m before the camera: a voxel of the finest texel covers {:.2g} "
      "pixels there, more than grass.pixels_per_voxel = {:.3g}; {}, or raise camera.eye_height",
      nearest_m, voxel_m * pixels_per_m, scene.grass.pixels_per_voxel,
      finer_grass(scene, pixels_per_m)));
}

/// How far the terrain reaches from the eye to where it looks.
double farthest_ground_m(const scene::Scene& scene, const Pose& pose) {
  const glm::dvec2 ahead = glm::normalize(pose.target_m - pose.eye_m);
  double reach_m = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 2; ++axis) {
    const double border_m = ahead[axis] > 0.0 ? scene.terrain.size_m : 0.0;
    if (ahead[axis] != 0.0)
      reach_m = std::min(reach_m, (border_m - pose.eye_m[axis]) / ahead[axis]);
  }
  return reach_m;
}

void warn_of_far_cells(const scene::Scene& scene, std::vector<std::string>& warnings) {
  static const scene::Grass usual;
  if (scene.render.grass == scene::GrassForm::points || scene.grass.far_field_below_pixels >= 1.0)
    return;
  double farthest_m = 0.0;
  for (const Pose& pose : poses(scene))
    if (pose.eye_m != pose.target_m)
      farthest_m = std::max(farthest_m, farthest_ground_m(scene, pose));
  farthest_m = std::min(farthest_m, place::farthest_standing_m(scene));
  const double pixels = place::pixels_per_radian(scene) * scene::mean_grass(scene).height_m /
                        std::max(farthest_m, 1e-6);
  if (pixels >= place::min_standing) return;
  warnings.push_back(fmt::format(
      "grass {:.3g} m away is {:.2g} pixels high and still stands there as cells, which flicker "
      "and take time; set grass.far_field_below_pixels = {:.3g}, which paints it on the ground",
      farthest_m, pixels, usual.far_field_below_pixels));
}

/// Shrubs stand over the grass around them, and in Mitsuba a place is of one volume at most.
void warn_of_shared_places(const scene::Scene& scene, std::vector<std::string>& warnings) {
  if (scene.render.grass != scene::GrassForm::texels ||
      std::ranges::find(scene.render.renderers, "mitsuba") == scene.render.renderers.end() ||
      !scene::has_placed_shrubs(scene, /*mixture=*/0))
    return;
  warnings.emplace_back(
      "Mitsuba shows one volume at a place, and shrubs stand over the grass around them: both have "
      "holes there; set render.grass = \"blades\" for it");
}

}  // namespace

std::vector<std::string> grass_warnings(const scene::Scene& film) {
  std::vector<std::string> warnings;
  warn_of_coarse_texels(film, warnings);
  warn_of_far_cells(film, warnings);
  warn_of_shared_places(film, warnings);
  return warnings;
}

}  // namespace wold::advice
