#include "ground/land_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/pinhole.h"
#include "ground/line_of_sight.h"
#include "light/daylight.h"

namespace wold::ground {
namespace {

using std::numbers::pi;

double rise_of(const glm::dvec3& direction) {
  return direction.z / std::max(glm::length(glm::dvec2(direction)), 1e-12);
}

/// The rise per distance of the skyline of the scene's own ground.
double own_skyline(const Heightfield& ground, const glm::dvec3& eye_m, double azimuth) {
  const glm::dvec2 towards(light::direction_of(azimuth, 0.0));
  const double end_m = to_border_m(ground.square(), glm::dvec2(eye_m), towards);
  double highest = -std::numeric_limits<double>::infinity();
  for (double distance_m = ground.step_m(); distance_m <= end_m;
       distance_m += std::max(0.5 * ground.step_m(), 0.003 * distance_m)) {
    const glm::dvec2 at_m = glm::dvec2(eye_m) + towards * distance_m;
    highest = std::max(highest, (double{ground.sample(at_m.x, at_m.y)} - eye_m.z) / distance_m);
  }
  return highest;
}

/// Half the width and height of a picture and of a little around it, at a distance of 1.
glm::dvec2 half_size(const landscape::Camera& camera, int width_px, int height_px) {
  constexpr double margin = 1.1;
  const double half = margin * half_width(camera.field_of_view_deg);
  return {half, half * height_px / width_px};
}

/// Directions to the border of what half_size() has.
std::vector<glm::dvec3> border_of(const landscape::Camera& camera, int width_px, int height_px) {
  constexpr int places = 16;  // along each side
  const CameraAxes axes(camera.eye_m, camera.target_m);
  const glm::dvec2 half = half_size(camera, width_px, height_px);
  std::vector<glm::dvec3> border;
  for (int i = -places; i <= places; ++i)
    for (const double side : {-1.0, 1.0}) {
      border.push_back(axes.forward + axes.right * (side * half.x) +
                       axes.up * (half.y * i / places));
      border.push_back(axes.forward + axes.right * (half.x * i / places) +
                       axes.up * (side * half.y));
    }
  return border;
}

}  // namespace

Panorama panorama(const landscape::Camera& camera, int width_px, int height_px) {
  const CameraAxes axes(camera.eye_m, camera.target_m);
  const double step_rad = 0.5 / pixels_per_radian(camera.field_of_view_deg, width_px);
  const double middle_rad = azimuth_rad(axes.forward);
  const double half_height = half_size(camera, width_px, height_px).y;
  const double steepest_rad = std::abs(math::asin(axes.forward.z)) + math::atan(half_height);
  if (steepest_rad > 0.48 * pi) return {middle_rad, pi, step_rad};
  double half_rad = 0.0;
  for (const glm::dvec3& direction : border_of(camera, width_px, height_px))
    half_rad = std::max(half_rad, std::abs(turned_rad(azimuth_rad(direction) - middle_rad)));
  return {middle_rad, half_rad, step_rad};
}

LandView::LandView(const terrain::Surroundings& land, const Heightfield& ground,
                   const glm::dvec3& eye_m, const Panorama& panorama)
    : eye_m_(eye_m),
      panorama_(panorama),
      profiles_(static_cast<std::size_t>(2.0 * panorama.half_rad / panorama.step_rad) + 2) {
  land.reach_m();  // made now, by all threads, and not by one while the others wait
  parallel_for(profiles_.size(), [&](std::size_t i) {
    profiles_[i] = {own_skyline(ground, eye_m, azimuth_of(i)), seen(land, azimuth_of(i))};
  });
}

double LandView::azimuth_of(std::size_t profile) const {
  return panorama_.middle_rad - panorama_.half_rad +
         panorama_.step_rad * static_cast<double>(profile);
}

std::vector<LandView::Seen> LandView::seen(const terrain::Surroundings& land,
                                           double azimuth) const {
  constexpr double spacing = 0.003;  // over distance
  const glm::dvec2 towards(light::direction_of(azimuth, 0.0));
  const double begin_m = to_border_m(land.square(), glm::dvec2(eye_m_), towards);
  const double end_m = begin_m + land.reach_m();
  const auto place_m = [&](double distance_m) { return glm::dvec2(eye_m_) + towards * distance_m; };
  const auto rise_to = [&](double height_m, double distance_m) {
    return (height_m - (drop_m(distance_m) - drop_m(begin_m)) - eye_m_.z) / distance_m;
  };
  const auto rise_at = [&](double distance_m) {
    return rise_to(land.height_m(place_m(distance_m)), distance_m);
  };
  std::vector<Seen> all;
  const auto rises_above_all = [&](double rise) { return all.empty() || rise > all.back().rise; };
  for (double distance_m = std::max(begin_m, 1e-3), before_m = distance_m; distance_m < end_m;) {
    const glm::dvec2 at_m = place_m(distance_m);
    // Most land is hidden, and the bound is found in a fraction of the time.
    if (rises_above_all(rise_to(land.highest_m(at_m), distance_m)))
      if (const double rise = rise_at(distance_m); rises_above_all(rise))
        all.push_back({distance_m, rise, before_m, all.empty() ? 0.0 : rise_at(before_m)});
    before_m = distance_m;
    distance_m += std::max(0.7 * land.step_m(at_m), spacing * distance_m);
  }
  return all;
}

const LandView::Profile& LandView::towards(double azimuth) const {
  const double from_begin_rad = turned_rad(azimuth - panorama_.middle_rad) + panorama_.half_rad;
  const double place = std::round(from_begin_rad / panorama_.step_rad);
  return profiles_[static_cast<std::size_t>(
      std::clamp(place, 0.0, static_cast<double>(profiles_.size() - 1)))];
}

std::optional<glm::dvec2> LandView::place(const glm::dvec3& direction) const {
  const Profile& profile = towards(azimuth_rad(direction));
  const double rise = rise_of(direction);
  if (rise < profile.own_skyline - 2.0 * panorama_.step_rad) return std::nullopt;
  const auto seen = std::ranges::lower_bound(profile.seen, rise, {}, &Seen::rise);
  if (seen == profile.seen.end()) return std::nullopt;
  const double part = std::clamp(
      (rise - seen->rise_of_nearer) / std::max(seen->rise - seen->rise_of_nearer, 1e-12), 0.0, 1.0);
  const double distance_m = std::lerp(seen->nearer_m, seen->distance_m, part);
  return glm::dvec2(eye_m_) + glm::normalize(glm::dvec2(direction)) * distance_m;
}

double LandView::covered_m(const glm::dvec2& at_m) const {
  constexpr double lines_of_sight = 2.0, root_of_ten = 3.16;
  return lines_of_sight * root_of_ten * panorama_.step_rad * glm::length(at_m - glm::dvec2(eye_m_));
}

std::vector<LandView::Strip> LandView::strips() const {
  std::vector<Strip> all;
  for (std::size_t i = 0; i < profiles_.size(); ++i) {
    const double own = profiles_[i].own_skyline, around = profiles_[i].seen.back().rise;
    if (around <= own) continue;
    const glm::dvec3 level = light::direction_of(azimuth_of(i), 0.0);
    const auto rising = [&](double rise) { return level + glm::dvec3(0.0, 0.0, rise); };
    all.push_back({rising(own), rising(around)});
  }
  return all;
}

namespace {

/// Whether all of a picture lies below the skyline of the scene's own ground.
bool shows_own_ground_alone(const Heightfield& ground, const landscape::Camera& camera,
                            int width_px, int height_px, const Panorama& around) {
  double steepest = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& direction : border_of(camera, width_px, height_px))
    steepest = std::max(steepest, rise_of(direction));
  for (double aside_rad = -around.half_rad; aside_rad <= around.half_rad;
       aside_rad += around.step_rad)
    if (own_skyline(ground, camera.eye_m, around.middle_rad + aside_rad) < steepest) return false;
  return true;
}

}  // namespace

bool sees_land_around(const terrain::Surroundings& land, const Heightfield& ground,
                      const landscape::Camera& camera, int width_px, int height_px) {
  constexpr double looks = 48.0, far_m = 1000.0;
  Panorama coarse = panorama(camera, width_px, height_px);
  coarse.step_rad = std::max(2.0 * coarse.half_rad / looks, coarse.step_rad);
  if (shows_own_ground_alone(ground, camera, width_px, height_px, coarse)) return false;
  const place::View picture(camera, width_px, height_px);
  const auto is_in_picture = [&](const glm::dvec3& direction) {
    return picture.may_see(camera.eye_m + direction * far_m, 0.0);
  };
  return std::ranges::any_of(LandView(land, ground, camera.eye_m, coarse).strips(),
                             [&](const LandView::Strip& strip) {
                               return is_in_picture(strip.lower) || is_in_picture(strip.upper);
                             });
}

}  // namespace wold::ground
