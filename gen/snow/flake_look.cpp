#include "snow/flake_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "snow/turns.h"

namespace wold::snow {
namespace {

/// Flakes tilt to either side of facing the eye by up to 60 degrees and turn about their middle: an
/// aggregate is no sheet, and is never seen edge on. Cosines of tilts 60 degrees sin(phase) have
/// the mean J0(pi / 3).
constexpr double most_tilt = std::numbers::pi / 3.0;
constexpr double mean_tilt_cosine = 0.74407;

double cross_section_m2(const Flake& flake) {
  return 0.25 * std::numbers::pi * flake.diameter_m * flake.diameter_m;
}

int individual_of(const Flake& flake) {
  static_assert(FlakePictures::individuals == 4);
  return static_cast<int>(flake.bits >> 62);
}

}  // namespace

FlakeLook::FlakeLook(const FlakePictures& pictures, const Frustum& frustum, double shutter_s)
    : pictures_(pictures), frustum_(frustum), shutter_s_(shutter_s) {}

SeenFlake FlakeLook::seen(const Flake& flake) const {
  const glm::dvec3 to_eye = frustum_.eye_m() - flake.centre_m;
  const double distance_m = glm::length(to_eye);
  const glm::dvec3 towards_eye = to_eye / distance_m;
  const double pixel_m = distance_m * frustum_.pixel_angle();
  const glm::dvec3 way_m =
      shutter_s_ * (flake.velocity_m_s - glm::dot(flake.velocity_m_s, towards_eye) * towards_eye);
  const bool near = distance_m <= textured_within_m;
  const double size_m = near ? crystal_side_m(flake) : flake.diameter_m;
  if (glm::length(way_m) > std::max(size_m, pixel_m))
    return streak(flake, towards_eye, way_m, pixel_m);
  return near ? crystal(flake, towards_eye, pixel_m) : disc(flake, towards_eye, pixel_m);
}

double FlakeLook::crystal_side_m(const Flake& flake) const {
  const int finest = pictures_.crystal(flake.crystal, individual_of(flake), 0);
  const double mean = static_cast<double>(pictures_.mean_opacity(finest));
  return std::sqrt(cross_section_m2(flake) / (mean * mean_tilt_cosine));
}

SeenFlake FlakeLook::streak(const Flake& flake, const glm::dvec3& towards_eye,
                            const glm::dvec3& way_m, double pixel_m) const {
  const double way = glm::length(way_m);
  const double width = std::max(flake.diameter_m, pixel_m);
  const double length = width + way;
  const glm::dvec3 along = way_m / way;
  const double mean = static_cast<double>(pictures_.mean_opacity(pictures_.streak()));
  const double opacity = cross_section_m2(flake) / (mean * width * length);
  return {flake.centre_m, 0.5 * width * glm::cross(along, towards_eye), 0.5 * length * along,
          pictures_.streak(), static_cast<float>(std::min(1.0, opacity))};
}

SeenFlake FlakeLook::disc(const Flake& flake, const glm::dvec3& towards_eye, double pixel_m) const {
  const double mean = static_cast<double>(pictures_.mean_opacity(pictures_.disc()));
  const double area = cross_section_m2(flake) / mean;
  const double side = std::max(std::sqrt(area), pixel_m);
  const auto [right, up] = facing(towards_eye);
  return {flake.centre_m, 0.5 * side * right, 0.5 * side * up, pictures_.disc(),
          static_cast<float>(area / (side * side))};
}

SeenFlake FlakeLook::crystal(const Flake& flake, const glm::dvec3& towards_eye,
                             double pixel_m) const {
  const double side = crystal_side_m(flake);
  const int level =
      std::clamp(static_cast<int>(std::floor(std::log2(FlakePictures::finest_px * pixel_m / side))),
                 0, FlakePictures::levels - 1);

  const double tilt = most_tilt * static_cast<double>(sine_of_turns(flake.tilt_turns));
  const auto [right, up] = facing(towards_eye);
  const auto sine = static_cast<double>(sine_of_turns(flake.spin_turns));
  const auto cosine = static_cast<double>(cosine_of_turns(flake.spin_turns));
  const glm::dvec3 axis = cosine * right + sine * up;
  const glm::dvec3 across = cosine * up - sine * right;
  const glm::dvec3 tilted = std::cos(tilt) * across + std::sin(tilt) * towards_eye;
  return {flake.centre_m, 0.5 * side * axis, 0.5 * side * tilted,
          pictures_.crystal(flake.crystal, individual_of(flake), level), 1.0F};
}

}  // namespace wold::snow
