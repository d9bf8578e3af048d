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
constexpr float most_tilt = std::numbers::pi_v<float> / 3.0F;
constexpr float mean_tilt_cosine = 0.74407F;

constexpr float disc_area = 0.25F * std::numbers::pi_v<float>;  ///< of diameter 1

int individual_of(const Flake& flake) {
  static_assert(FlakePictures::individuals == 4);
  return static_cast<int>(flake.bits >> 62);
}

}  // namespace

FlakeLook::FlakeLook(const FlakePictures& pictures, const Frustum& frustum, double shutter_s)
    : pictures_(pictures),
      frustum_(frustum),
      shutter_s_(static_cast<float>(shutter_s)),
      streak_area_(disc_area / pictures.mean_opacity(pictures.streak())),
      disc_side_(std::sqrt(disc_area / pictures.mean_opacity(pictures.disc()))) {}

SeenFlake FlakeLook::seen(const Flake& flake) const {
  const glm::vec3 to_eye(frustum_.eye_m() - flake.centre_m);
  const float distance = glm::length(to_eye);
  const Sight sight = {flake, glm::vec3(flake.centre_m), to_eye * (1.0F / distance),
                       static_cast<float>(flake.diameter_m),
                       distance * static_cast<float>(frustum_.pixel_angle())};
  const bool near = distance <= static_cast<float>(textured_within_m);
  const glm::vec3 velocity(flake.velocity_m_s);
  const glm::vec3 way =
      shutter_s_ * (velocity - glm::dot(velocity, sight.towards_eye) * sight.towards_eye);
  const float way_length = glm::length(way);
  const float size = near ? crystal_side(sight) : sight.diameter;
  if (way_length > std::max(size, sight.pixel)) return streak(sight, way, way_length);
  return near ? crystal(sight) : disc(sight);
}

float FlakeLook::crystal_side(const Sight& sight) const {
  const int finest = pictures_.crystal(sight.flake.crystal, individual_of(sight.flake), 0);
  return sight.diameter *
         std::sqrt(disc_area / (pictures_.mean_opacity(finest) * mean_tilt_cosine));
}

SeenFlake FlakeLook::streak(const Sight& sight, const glm::vec3& way, float way_length) const {
  const float width = std::max(sight.diameter, sight.pixel);
  const float length = width + way_length;
  const glm::vec3 along = way * (1.0F / way_length);
  const float opacity = streak_area_ * sight.diameter * sight.diameter / (width * length);
  return {sight.centre, 0.5F * width * glm::cross(along, sight.towards_eye), 0.5F * length * along,
          pictures_.streak(), std::min(1.0F, opacity)};
}

SeenFlake FlakeLook::disc(const Sight& sight) const {
  const float wanted = disc_side_ * sight.diameter;
  const float side = std::max(wanted, sight.pixel);
  const auto [right, up] = facing(sight.towards_eye);
  return {sight.centre, 0.5F * side * right, 0.5F * side * up, pictures_.disc(),
          wanted * wanted / (side * side)};
}

SeenFlake FlakeLook::crystal(const Sight& sight) const {
  const Flake& flake = sight.flake;
  const float side = crystal_side(sight);
  const int level = std::clamp(
      static_cast<int>(
          std::floor(std::log2(static_cast<float>(FlakePictures::finest_px) * sight.pixel / side))),
      0, FlakePictures::levels - 1);
  const float tilt = most_tilt * sine_of_turns(flake.tilt_turns);
  const auto [right, up] = facing(sight.towards_eye);
  const float sine = sine_of_turns(flake.spin_turns);
  const float cosine = cosine_of_turns(flake.spin_turns);
  const glm::vec3 axis = cosine * right + sine * up;
  const glm::vec3 across = cosine * up - sine * right;
  const glm::vec3 tilted = std::cos(tilt) * across + std::sin(tilt) * sight.towards_eye;
  return {sight.centre, 0.5F * side * axis, 0.5F * side * tilted,
          pictures_.crystal(flake.crystal, individual_of(flake), level), 1.0F};
}

}  // namespace wold::snow
