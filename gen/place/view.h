#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "place/ground_in_sight.h"
#include "scene/scene.h"
#include "scene/shots.h"

namespace wold::place {

/// A place over the terrain's ground, in world space.
glm::dvec3 above_ground(const Heightfield& terrain, const glm::dvec2& at_m, double height_m);

/// A camera with its heights above the ground, as renderers have it, resolved to world space. One
/// that moves is `time` of its way from the first frame to the last, in [0, 1].
landscape::Camera resolved_camera(const scene::Camera& camera, const Heightfield& terrain,
                                  double time);

/// A camera over the snow that lies when the weather begins: at least half of the eye's height is
/// above that, and what it looks at is raised as much. It does not follow snow that falls and
/// melts: nobody moves it.
scene::Camera on_snow(const scene::Scene& scene, scene::Camera camera);

/// That of a frame (from 1): its shot's, or the scene's; over the snow that lies there at first.
landscape::Camera camera_of_frame(const scene::Scene& scene, const Heightfield& terrain, int frame);

/// Unit direction to the eye that highlights are baked for in a take: where the camera of its
/// middle frame is half-way, seen from what it looks at.
glm::dvec3 eye_direction(const scene::Scene& scene, const Heightfield& terrain,
                         const scene::Take& take);

/// Pixels that an angle of one radian covers in the middle of the scene's pictures; of a film of
/// shots, in those of the longest lens.
double pixels_per_radian(const scene::Scene& scene);

/// How far from the eye grass stands at the farthest, not painted on the ground (far_field.h);
/// infinite where none is.
inline constexpr double min_standing = 0.75;  ///< of grass.far_field_below_pixels
double farthest_standing_m(const scene::Scene& scene);

/// What the camera sees: a pyramid, and how large things look.
class View {
 public:
  View(const landscape::Camera& camera, int width_px, int height_px);

  /// Whether any of a sphere can be inside the picture. May say yes for a sphere just outside.
  bool may_see(const glm::dvec3& centre_m, double radius_m) const;

  /// The same of a camera over a terrain, which knows what ground is behind nearer ground. The
  /// terrain has to outlive it.
  View over(const Heightfield& terrain) const;

  /// The same of one that is not asked for the ground of a square: another view has that.
  View outside(const Square& square) const;

  /// The same with how far beside its place what stands on the ground may reach, > 0: 2 m unless
  /// set.
  View reaching(double reach_m) const;
  double reach_m() const { return reach_m_; }

  /// Whether any of the ground within `margin_m` of a place on it can be seen; also behind nearer
  /// ground where the view is not over() a terrain. Never inside the square that it is outside()
  /// of.
  bool may_see_ground(const glm::dvec3& at_m, double margin_m) const;

  /// Pixels that a length covers at a point, seen square on.
  double pixels(double length_m, const glm::dvec3& at_m) const;

  /// Unit direction from the eye to a point.
  glm::dvec3 line_of_sight(const glm::dvec3& at_m) const;

 private:
  glm::dvec3 eye_m_;
  std::array<glm::dvec3, 5> inwards_;  ///< unit normals of the sides and of the plane at the eye
  double pixels_per_radian_ = 0.0, reach_m_ = 2.0;
  std::shared_ptr<const GroundInSight> ground_;  ///< null where nothing is known of it
  std::optional<Square> left_out_;
};

}  // namespace wold::place
