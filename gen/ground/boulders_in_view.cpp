#include "ground/boulders_in_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/mesh_height.h"
#include "place/view.h"
#include "terrain/boulders.h"

namespace wold::ground {
namespace {

using landscape::RaisedGround;
using terrain::Boulder;

/// The narrowest boulder that is drawn. The ground's pictures, which it shows, have no more than
/// some 1400 steps to a radian, however large the frame is.
constexpr double least_px = 5.0, most_px_per_radian = 1366.0;

double pixels_per_radian(const place::View& view, const glm::dvec3& eye_m) {
  return view.pixels(1.0, eye_m + glm::dvec3(1.0, 0.0, 0.0));
}

/// Whether an eye, so far from a boulder's foot, would be in it or so near that it fills the
/// picture.
bool holds(double width_m, const glm::dvec3& eye_from_foot_m) {
  constexpr double beside = 0.6;  // over the width
  const double away_m = glm::length(glm::dvec2(eye_from_foot_m));
  return away_m < beside * width_m && eye_from_foot_m.z < width_m;
}

/// Rings of corners from the middle to the rim, and one more, which is in the ground.
class BoulderMesh {
 public:
  BoulderMesh(const Boulder& boulder, const Heightfield& bare_m, double width_px)
      : boulder_(boulder),
        bare_m_(bare_m),
        ways_(std::clamp(static_cast<std::uint32_t>(width_px / 3.0), 6U, 48U)),
        rings_(std::clamp(ways_ / 4U, 2U, 9U)) {}

  void add_to(RaisedGround& mesh) const {
    const auto middle = static_cast<std::uint32_t>(mesh.points_m.size());
    mesh.points_m.push_back(on_top(boulder_.middle_m(), mesh));
    for (std::uint32_t way = 0; way < ways_; ++way) add_spoke(way, mesh);
    const auto corner = [&](std::uint32_t way, std::uint32_t ring) {
      return ring == 0 ? middle : middle + way % ways_ * (rings_ + 1) + ring;
    };
    for (std::uint32_t way = 0; way < ways_; ++way)
      for (std::uint32_t ring = 0; ring <= rings_; ++ring) {
        const std::uint32_t near = corner(way, ring), far = corner(way, ring + 1),
                            next_far = corner(way + 1, ring + 1);
        mesh.triangles.emplace_back(near, far, next_far);
        if (ring > 0) mesh.triangles.emplace_back(near, next_far, corner(way + 1, ring));
      }
  }

 private:
  void add_spoke(std::uint32_t way, RaisedGround& mesh) const {
    constexpr double sunk = 0.06;  // over the width
    const double turn = 2.0 * std::numbers::pi * way / ways_;
    const glm::dvec2 along(math::cos(turn), math::sin(turn));
    const double rim_m = boulder_.rim_m(along);
    for (std::uint32_t ring = 1; ring <= rings_; ++ring) {
      // Closer to each other where the sides are steep.
      const double part = math::sin(0.5 * std::numbers::pi * ring / rings_);
      mesh.points_m.push_back(on_top(boulder_.middle_m() + part * rim_m * along, mesh));
    }
    glm::vec3 in_ground = mesh.points_m.back();
    in_ground.z -= static_cast<float>(sunk * boulder_.width_m());
    mesh.points_m.push_back(in_ground);
  }

  /// From the mesh's origin.
  glm::vec3 on_top(const glm::dvec2& at_m, const RaisedGround& mesh) const {
    const double height_m = std::max(0.0, boulder_.top(at_m).height_m);
    const double ground_m{mesh_height_m(bare_m_, at_m)};
    return glm::dvec3(at_m, ground_m + height_m) - mesh.origin_m;
  }

  const Boulder& boulder_;
  const Heightfield& bare_m_;
  std::uint32_t ways_, rings_;
};

}  // namespace

RaisedGround boulders_in_view(const place::Site& site, const landscape::Landscape& landscape) {
  const glm::dvec3& eye_m = landscape.camera.eye_m;
  const place::View view = place::View(landscape.camera, landscape.width_px, landscape.height_px)
                               .over(landscape.terrain);
  const double widths = std::min(pixels_per_radian(view, eye_m), most_px_per_radian) / least_px;
  const auto is_drawn = [&](const glm::dvec2& middle_m, double width_m) {
    const glm::dvec3 foot_m(middle_m, double{mesh_height_m(site.terrain, middle_m)});
    const double snow_m = double{mesh_height_m(landscape.terrain, middle_m)} - foot_m.z;
    return glm::distance(eye_m, foot_m) < widths * width_m &&
           snow_m < Boulder::most_height_m(width_m) && !holds(width_m, eye_m - foot_m) &&
           view.may_see(foot_m, width_m) && view.may_see_ground(foot_m, width_m);
  };
  RaisedGround mesh{glm::floor(eye_m), {}, {}};
  for (const Boulder& boulder : site.boulders->about(glm::dvec2(eye_m), widths, is_drawn)) {
    const double away_m =
        std::max(glm::distance(glm::dvec2(eye_m), boulder.middle_m()), boulder.width_m());
    BoulderMesh(boulder, site.terrain, pixels_per_radian(view, eye_m) * boulder.width_m() / away_m)
        .add_to(mesh);
  }
  return mesh;
}

}  // namespace wold::ground
