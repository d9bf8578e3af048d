#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "snow/crystal_picture.h"
#include "snow/flake_sizes.h"
#include "snow/simd_lanes.h"
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

/// Farther away flakes are white discs that do not turn ([He2007], 2).
inline constexpr double textured_within_m = 3.5;

/// How flakes look to a view.
///
/// Whatever a flake is drawn as, the opacity over its rectangle as the eye sees it sums up to its
/// cross-section pi / 4 D^2, so that the drawn flakes dim what lies behind them as much as the size
/// distribution says.
class FlakeLook {
 public:
  /// `shutter_s`: how long a picture is exposed. Pictures and frustum have to outlive this.
  /// Drops are never crystals.
  FlakeLook(const FlakePictures& pictures, const Frustum& frustum, double shutter_s,
            Falling what = Falling::snow);

  /// Writes how the chosen flakes look, in their order; returns the end of what it wrote.
  ///
  /// A streak when the flake moves by more than its size while it is exposed, a crystal when it is
  /// near, else a disc. None is thinner than a pixel: it would be fainter instead.
  SeenFlake* see(const FlakeLanes& flakes, const Chosen& chosen, SeenFlake* to) const;

 private:
  /// Flakes as rectangles, and what decides whether they are drawn as crystals.
  struct Rectangles {
    VectorLanes centre, right, up;
    Lanes<std::int32_t> picture;
    Lanes<float> opacity;
    Lanes<float> distance, way_length;  ///< way across the way to the eye
  };
  /// As if all were far away: discs or streaks.
  void draw_far(const FlakeLanes& flakes, Rectangles& drawn) const;
  float crystal_side(Crystal crystal, std::uint64_t bits, float diameter) const;
  void draw_crystal(const FlakeLanes& flakes, std::size_t lane, float side, float distance,
                    SeenFlake& seen) const;

  const FlakePictures& pictures_;
  const Frustum& frustum_;
  float pixel_angle_;
  float shutter_s_;
  Falling what_;
  float streak_area_;  ///< cross-section over mean opacity, of a flake of diameter 1
  float disc_side_;    ///< of the square whose picture has such a flake's cross-section
  /// The same of crystals' pictures, by crystal and individual.
  std::array<std::array<float, FlakePictures::individuals>, crystal_kinds> crystal_sides_;
};

}  // namespace wold::snow
