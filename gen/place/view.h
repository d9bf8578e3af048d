#pragma once

#include <array>
#include <glm/glm.hpp>

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "scene/scene.h"

namespace wold::place {

/// A place over the terrain's ground, in world space.
glm::dvec3 above_ground(const Heightfield& terrain, const glm::dvec2& at_m, double height_m);

/// The scene's camera with its heights above the ground resolved to world space. One that moves is
/// `time` of its way from the first frame to the last, in [0, 1].
landscape::Camera resolved_camera(const scene::Camera& camera, const Heightfield& terrain,
                                  double time);

/// How far a frame (from 1) is on the scene's way from the first to the last, in [0, 1].
double time_of_frame(const scene::Scene& scene, int frame);

/// Unit direction to the eye that highlights are baked for: where the camera is half-way through
/// the film, seen from what it looks at.
glm::dvec3 film_eye_direction(const scene::Scene& scene, const Heightfield& terrain);

/// Pixels that an angle of one radian covers in the middle of the scene's pictures.
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

  /// Pixels that a length covers at a point, seen square on.
  double pixels(double length_m, const glm::dvec3& at_m) const;

  /// Unit direction from the eye to a point.
  glm::dvec3 line_of_sight(const glm::dvec3& at_m) const;

 private:
  glm::dvec3 eye_m_;
  std::array<glm::dvec3, 5> inwards_;  ///< unit normals of the sides and of the plane at the eye
  double pixels_per_radian_ = 0.0;
};

}  // namespace wold::place
