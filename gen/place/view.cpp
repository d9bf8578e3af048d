#include "place/view.h"

#include <algorithm>

#include "core/mesh_height.h"
#include "core/pinhole.h"
#include "scene/species.h"
#include "snowpack/snow_layer.h"

namespace wold::place {

namespace {

/// A place over the ground as renderers have it: a camera must not stand below that.
glm::dvec3 above_mesh(const Heightfield& terrain, const glm::dvec2& at_m, double height_m) {
  return {at_m, mesh_height_m(terrain, at_m) + height_m};
}

/// A place on the straight way from `from_m` to `end` (east, north, height above the ground).
glm::dvec3 on_the_way(const Heightfield& terrain, const glm::dvec3& from_m,
                      const std::vector<double>& end, double time) {
  if (end.empty()) return from_m;
  return glm::mix(from_m, above_mesh(terrain, {end[0], end[1]}, end[2]), time);
}

}  // namespace

glm::dvec3 above_ground(const Heightfield& terrain, const glm::dvec2& at_m, double height_m) {
  return {at_m, terrain.sample(at_m.x, at_m.y) + height_m};
}

scene::Camera on_snow(const scene::Scene& scene, scene::Camera camera) {
  constexpr double over_snow = 0.5;
  if (scene.snow_cover.cover != scene::CoverModel::depth) return camera;
  const double snow_m = snowpack::lain_snow(scene.snow_cover.initial_mm).depth_m;
  const auto raised_by = [&](double eye_m) {
    return std::max(snow_m - (1.0 - over_snow) * eye_m, 0.0);
  };
  const double by_m = raised_by(camera.eye_height_m);
  const double at_end_m = camera.eye_end.empty() ? by_m : raised_by(camera.eye_end[2]);
  camera.eye_height_m += by_m;
  camera.target_height_m += by_m;
  if (!camera.eye_end.empty()) camera.eye_end[2] += at_end_m;
  if (!camera.target_end.empty()) camera.target_end[2] += at_end_m;
  return camera;
}

landscape::Camera resolved_camera(const scene::Camera& camera, const Heightfield& terrain,
                                  double time) {
  const auto placed = [&](const std::array<double, 2>& at_m, double height_m,
                          const std::vector<double>& end) {
    return on_the_way(terrain, above_mesh(terrain, {at_m[0], at_m[1]}, height_m), end, time);
  };
  return {placed(camera.eye_m, camera.eye_height_m, camera.eye_end),
          placed(camera.target_m, camera.target_height_m, camera.target_end),
          camera.field_of_view_deg};
}

landscape::Camera camera_of_frame(const scene::Scene& scene, const Heightfield& terrain,
                                  int frame) {
  return resolved_camera(on_snow(scene, scene::camera_of(scene, frame)), terrain,
                         scene::way_of_frame(scene, frame));
}

glm::dvec3 eye_direction(const scene::Scene& scene, const Heightfield& terrain,
                         const scene::Take& take) {
  const int middle = take.first + take.count / 2;
  const landscape::Camera camera =
      resolved_camera(on_snow(scene, scene::camera_of(scene, middle)), terrain, /*time=*/0.5);
  return glm::normalize(camera.eye_m - camera.target_m);
}

double pixels_per_radian(const scene::Scene& scene) {
  double most = 0.0;
  for (const scene::Camera& camera : scene::cameras_of(scene))
    most =
        std::max(most, wold::pixels_per_radian(camera.field_of_view_deg, scene.render.size_px[0]));
  return most;
}

double farthest_standing_m(const scene::Scene& scene) {
  return pixels_per_radian(scene) * scene::mean_grass(scene).height_m /
         (min_standing * scene.grass.far_field_below_pixels);
}

View::View(const landscape::Camera& camera, int width_px, int height_px) : eye_m_(camera.eye_m) {
  const CameraAxes axes(camera.eye_m, camera.target_m);
  const auto& [forward, right, up] = axes;
  const double across = half_width(camera.field_of_view_deg);
  const double upwards = across * height_px / width_px;
  inwards_ = {glm::normalize(forward * across + right), glm::normalize(forward * across - right),
              glm::normalize(forward * upwards + up), glm::normalize(forward * upwards - up),
              forward};
  pixels_per_radian_ = wold::pixels_per_radian(camera.field_of_view_deg, width_px);
}

bool View::may_see(const glm::dvec3& centre_m, double radius_m) const {
  return std::all_of(inwards_.begin(), inwards_.end(), [&](const glm::dvec3& inwards) {
    return glm::dot(inwards, centre_m - eye_m_) >= -radius_m;
  });
}

View View::over(const Heightfield& terrain) const {
  View view = *this;
  view.ground_ = std::make_shared<const GroundInSight>(terrain, eye_m_);
  return view;
}

View View::outside(const Square& square) const {
  View view = *this;
  view.left_out_ = square;
  return view;
}

View View::reaching(double reach_m) const {
  View view = *this;
  view.reach_m_ = reach_m;
  return view;
}

bool View::may_see_ground(const glm::dvec3& at_m, double margin_m) const {
  if (left_out_ && left_out_->contains(glm::dvec2(at_m))) return false;
  return may_see(at_m, margin_m) && (!ground_ || ground_->may_see(glm::dvec2(at_m), margin_m));
}

double View::pixels(double length_m, const glm::dvec3& at_m) const {
  return pixels_per_radian_ * length_m / std::max(glm::length(at_m - eye_m_), 1e-6);
}

glm::dvec3 View::line_of_sight(const glm::dvec3& at_m) const {
  return glm::normalize(at_m - eye_m_);
}

}  // namespace wold::place
