#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "snow/crystal_picture.h"
#include "snow/fall_speed.h"
#include "snow/snow_view.h"

namespace wold::snow {

/// A flake as a rectangle in world space, metres: as landscape::Flake.
struct SeenFlake {
  glm::vec3 centre_m{0.0F};
  glm::vec3 right_m{0.0F};  ///< from its centre to the middle of its right side
  glm::vec3 up_m{0.0F};     ///< to the middle of its upper side
  int picture = 0;          ///< index into FlakePictures::all()
  float opacity = 1.0F;     ///< multiplies the picture's
};

/// A flake in the air.
struct Flake {
  glm::dvec3 centre_m{0.0};
  glm::dvec3 velocity_m_s{0.0};
  double diameter_m = 0.0;  ///< see flake_diameter_mm()
  Crystal crystal = Crystal::aggregate;
  std::uint64_t bits = 0;   ///< 64 random ones of its own
  float spin_turns = 0.0F;  ///< about the way to the eye
  float tilt_turns = 0.0F;  ///< where it is in its tumbling to either side of facing the eye
};

/// Farther away flakes are white discs that do not turn (the paper, 2).
inline constexpr double textured_within_m = 3.5;

/// How flakes look to a view.
///
/// Whatever a flake is drawn as, the opacity over its rectangle as the eye sees it sums up to its
/// cross-section pi / 4 D^2, so that the drawn flakes dim what lies behind them as much as the size
/// distribution says.
class FlakeLook {
 public:
  /// `shutter_s`: how long a picture is exposed. Pictures and frustum have to outlive this.
  FlakeLook(const FlakePictures& pictures, const Frustum& frustum, double shutter_s);

  /// A streak when the flake moves by more than its size while it is exposed, a crystal when it is
  /// near, else a disc. None is thinner than a pixel: it would be fainter instead.
  SeenFlake seen(const Flake& flake) const;

 private:
  /// A flake as the eye sees it; lengths in metres.
  struct Sight {
    const Flake& flake;
    glm::vec3 centre;
    glm::vec3 towards_eye;
    float diameter;
    float pixel;
  };
  float crystal_side(const Sight& sight) const;
  SeenFlake streak(const Sight& sight, const glm::vec3& way, float way_length) const;
  SeenFlake disc(const Sight& sight) const;
  SeenFlake crystal(const Sight& sight) const;

  const FlakePictures& pictures_;
  const Frustum& frustum_;
  float shutter_s_;
  float streak_area_;  ///< cross-section over mean opacity, of a flake of diameter 1
  float disc_side_;    ///< of the square whose picture has such a flake's cross-section
};

}  // namespace wold::snow
