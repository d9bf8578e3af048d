#include "landscape/raised_cast.h"

#include <array>
#include <vector>

#include "landscape/triangle.h"

namespace wold::landscape {
namespace {

std::vector<Box> boxes_of(const RaisedGround& raised) {
  std::vector<Box> boxes(raised.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (int k = 0; k < 3; ++k) boxes[i].add(raised.points_m[raised.triangles[i][k]]);
  return boxes;
}

}  // namespace

RaisedCast::RaisedCast(const RaisedGround& raised)
    : raised_(raised), triangles_(boxes_of(raised)) {}

std::array<glm::vec3, 3> RaisedCast::corners(std::uint32_t triangle) const {
  const glm::uvec3& places = raised_.triangles[triangle];
  return {raised_.points_m[places.x], raised_.points_m[places.y], raised_.points_m[places.z]};
}

RaisedCast::Hit RaisedCast::first(const glm::dvec3& start_m, const glm::dvec3& direction,
                                  double end_m) const {
  Hit hit{end_m, std::nullopt};
  const glm::dvec3 from_m = start_m - raised_.origin_m;
  triangles_.follow(from_m, direction, end_m, [&](std::uint32_t triangle) {
    const double at_m = meeting_m(from_m, direction, corners(triangle));
    if (at_m < hit.distance_m) hit = {at_m, triangle};
    return hit.distance_m;
  });
  return hit;
}

double RaisedCast::distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction,
                              double end_m) const {
  return first(eye_m, direction, end_m).distance_m;
}

/// From a little way above: what is raised has no overhangs.
std::optional<glm::dvec3> RaisedCast::normal(const glm::dvec3& at_m) const {
  constexpr double above_m = 0.01;
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const Hit hit = first(at_m + above_m * up, -up, 2.0 * above_m);
  if (!hit.triangle) return std::nullopt;
  return glm::normalize(across(corners(*hit.triangle)));
}

}  // namespace wold::landscape
