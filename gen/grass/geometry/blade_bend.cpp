#include "grass/geometry/blade_bend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/elementary.h"

namespace wold::grass {
namespace {

constexpr int segments = BladePlaces::per_blade - 1;

/// By how much a blade turns at `along`, east and north.
glm::dvec2 angle_rad(const BladeBend& bend, double along) {
  return cantilever_turn(along) * BladeBend::step_rad * glm::dvec2(bend.east, bend.north);
}

using Axis = std::array<glm::dvec3, BladePlaces::per_blade>;

/// A step that would end below the ground ends on it, as long as it is.
glm::dvec3 above_ground(const glm::dvec3& from_m, const glm::dvec3& step_m) {
  if (from_m.z + step_m.z >= 0.0) return from_m + step_m;
  const double length_m = glm::length(step_m), fall_m = std::min(from_m.z, length_m);
  const glm::dvec2 level(step_m);
  const double was_m = std::max(glm::length(level), 1e-12);
  return {glm::dvec2(from_m) + level * (std::sqrt(length_m * length_m - fall_m * fall_m) / was_m),
          from_m.z - fall_m};
}

/// An axis whose parts have turned.
Axis bent_axis(const Axis& straight_m, const BladeBend& bend) {
  Axis bent_m;
  bent_m[0] = straight_m[0];
  for (std::size_t i = 1; i < bent_m.size(); ++i) {
    const double middle = (static_cast<double>(i) - 0.5) / segments;
    bent_m[i] = above_ground(
        bent_m[i - 1], turned_over(straight_m[i] - straight_m[i - 1], angle_rad(bend, middle)));
  }
  return bent_m;
}

glm::dvec3 at_along(const Axis& axis_m, double along) {
  const double place = std::clamp(along, 0.0, 1.0) * segments;
  const auto i = std::min(static_cast<std::size_t>(place), axis_m.size() - 2);
  return glm::mix(axis_m[i], axis_m[i + 1], place - static_cast<double>(i));
}

Axis axis_of(const BladePlaces& places, std::size_t blade) {
  Axis axis_m;
  for (std::size_t i = 0; i < axis_m.size(); ++i)
    axis_m[i] = glm::dvec3(places.places[blade * axis_m.size() + i].position_m);
  return axis_m;
}

}  // namespace

double cantilever_turn(double along) {
  const double left = 1.0 - along;
  return 4.0 / 3.0 * (1.0 - left * left * left);
}

glm::dvec3 turned_over(const glm::dvec3& v, const glm::dvec2& angle_rad) {
  const double angle = glm::length(angle_rad);
  if (angle == 0.0) return v;
  const glm::dvec2 towards = angle_rad / angle;
  const double cosine = math::cos(angle), sine = math::sin(angle);
  const double with = glm::dot(glm::dvec2(v), towards);
  const double turned = cosine * with + sine * v.z;
  return {glm::dvec2(v) + (turned - with) * towards, cosine * v.z - sine * with};
}

std::string suffix_of(const BladeBend& bend) {
  return bend.is_none() ? std::string() : fmt::format("_b{}_{}", bend.east, bend.north);
}

glm::dvec2 tip_lean(const BladeBend& bend) {
  if (bend.is_none()) return glm::dvec2(0.0);
  Axis upright_m;
  for (std::size_t i = 0; i < upright_m.size(); ++i)
    upright_m[i] = {0.0, 0.0, static_cast<double>(i) / segments};
  const glm::dvec3 tip_m = bent_axis(upright_m, bend).back();
  return glm::dvec2(tip_m) / tip_m.z;
}

BladeBend nearest_bend(const glm::dvec2& lean, int multiple) {
  const double height = glm::length(lean);
  if (height == 0.0) return {};
  const double steps = math::atan(height) / (BladeBend::step_rad * multiple);
  const auto nearest = [&](double part) {
    return multiple * static_cast<int>(std::lround(steps * part / height));
  };
  return {nearest(lean.x), nearest(lean.y)};
}

Tubes bent(const Tubes& straight, const BladePlaces& places, const BladeBend& bend) {
  Tubes result = straight;
  if (bend.is_none()) return result;
  const auto corners = static_cast<std::size_t>(straight.corners);
  const auto per_blade = static_cast<std::size_t>(BladePlaces::per_blade);
  for (std::size_t first = 0; first < places.places.size(); first += per_blade) {
    const std::uint32_t blade = places.places[first].blade;
    const std::uint32_t bends = places.carried_by[blade];
    const Axis was_m = axis_of(places, bends);
    const Axis is_m = bent_axis(was_m, bend);
    for (std::size_t ring = first; ring < first + per_blade; ++ring) {
      // What a blade carries goes with its tip.
      const double along = bends == blade ? double{places.places[ring].along} : 1.0;
      const glm::dvec2 turn_rad = angle_rad(bend, along);
      const glm::dvec3 from_m = at_along(was_m, along), to_m = at_along(is_m, along);
      for (std::size_t k = ring * corners; k < (ring + 1) * corners; ++k)
        result.vertices_m[k] =
            glm::vec3(to_m + turned_over(glm::dvec3(straight.vertices_m[k]) - from_m, turn_rad));
    }
  }
  return result;
}

}  // namespace wold::grass
