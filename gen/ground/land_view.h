#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "place/view.h"
#include "terrain/surroundings.h"

namespace wold::ground {

/// How far an eye sees around, in azimuth.
struct Panorama {
  double middle_rad;  ///< clockwise from north
  double half_rad;    ///< to each side
  double step_rad;    ///< between lines of sight
};

/// That of a camera's picture and a little more, with two lines of sight a pixel in its middle: all
/// around where it sees what is straight above or below.
Panorama panorama(const landscape::Camera& camera, int width_px, int height_px);

/// The land around a scene's square as an eye in the square sees it: what is nearer hides what is
/// farther and lower.
///
/// Farther out than the square, where the land is flat, the earth is round and air bends the light,
/// by 0.13 of the earth's curvature (Gauss's mean).
class LandView {
 public:
  /// `ground`: of the square, which hides what is behind it.
  LandView(const terrain::Surroundings& land, const Heightfield& ground, const glm::dvec3& eye_m,
           const Panorama& panorama);

  /// The place on the land in a direction of any length; none where it is the sky, or more than a
  /// line of sight's width below the skyline of the square.
  std::optional<glm::dvec2> place(const glm::dvec3& direction) const;

  /// Size of what a pixel covers at a place, metres: the geometric mean of its width and of its
  /// depth, which is ten widths where land is seen at a slant of a tenth.
  double covered_m(const glm::dvec2& at_m) const;

  /// Where land is seen between the skyline of the square and that of the land: directions to the
  /// lower and to the upper one.
  struct Strip {
    glm::dvec3 lower, upper;
  };
  std::vector<Strip> strips() const;

 private:
  /// Where land is seen that rises above all before it.
  struct Seen {
    double distance_m;
    double rise;            ///< over distance, as it looks
    double nearer_m;        ///< the place before it on the way
    double rise_of_nearer;  ///< which may be hidden
  };
  struct Profile {
    double own_skyline;      ///< rise over distance of the square's
    std::vector<Seen> seen;  ///< outwards, ever higher; never empty
  };

  std::vector<Seen> seen(const terrain::Surroundings& land, double azimuth_rad) const;
  double azimuth_of(std::size_t profile) const;
  const Profile& towards(double azimuth_rad) const;

  glm::dvec3 eye_m_;
  Panorama panorama_;
  std::vector<Profile> profiles_;
};

/// Whether the camera sees any of the land around over the ground of the scene's square.
bool sees_land_around(const terrain::Surroundings& land, const Heightfield& ground,
                      const landscape::Camera& camera, int width_px, int height_px);

}  // namespace wold::ground
