#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "core/ground_map.h"
#include "scene/parts.h"
#include "snow/crystal_picture.h"
#include "snow/seen_flakes.h"
#include "snow/simd_lanes.h"
#include "snow/snow_view.h"
#include "snow/tornado.h"
#include "snow/weather.h"
#include "snow/wind_field.h"

namespace wold::snow {

/// [He2007]'s particle (2): its state at one time.
struct PaperFlake {
  double size_m = 0.0;
  glm::vec4 colour{1.0F};  ///< with alpha
  glm::dvec3 pos_m{0.0};
  glm::dvec3 v0_m_s{0.0};  ///< at first, constant
  glm::dvec3 vf_m_s{0.0};  ///< of the wind that it feels
  glm::dvec3 vr_m_s{0.0};  ///< its flutter: of fixed magnitude, of changing direction
  double rot_per_s = 0.0;  ///< turns
  double angle_turns = 0.0;
  std::int64_t start_assign = 0;  ///< how often a start at the top was assigned to it

  /// V = V0 + Vf + Vr + g dt, with [He2007]'s g dt as a speed that does not grow.
  glm::dvec3 velocity_m_s() const;
};

/// The box in which [He2007]'s flakes fall.
struct PaperBox {
  glm::dvec3 low_m{0.0};
  glm::dvec3 size_m{1.0};
};

/// Snow as [He2007] has it: flakes in a box by the eye, moved by S += V dt, born again at the top
/// at a random place when they have reached the bottom, wrapped round at the sides.
///
/// As velocities are constant, the wind's and the circle's of the flutter, the steps' sum is a
/// closed form: a flake's start_assign is how often it has fallen through the box, and keys where
/// it then began. The box is a window on a world that repeats itself after it, so flakes stay where
/// they are while the box follows the eye, and a wind that blows farther than the box in a frame is
/// as good as any other.
class PaperSnow {
 public:
  /// `pictures` has to outlive this.
  PaperSnow(const scene::PrecipitationPart& part, const Weather& weather,
            const FlakePictures& pictures);

  /// As FallingSnow::at(). About as many as asked for are in view, or [He2007]'s (figure 6): 500
  /// at 0.4 mm/h, 1000 at 1.2, 4000 at 4 and linear between. The fraction that is drawn falls with
  /// the distance (figure 3), to 1/e at the length of the box. All snow that falls is fog besides.
  ///
  /// The eye stands at the middle of the box's back side, and on its ground, unless it is higher
  /// than half the box: then at half its height.
  SeenFlakes at(double time_s, const SnowView& view, const Heightfield& ground) const;

  /// What all flakes share at a time.
  struct Moment {
    double time_s = 0.0;  ///< since the first frame
    Motion common = {};
    WindField::Moment gusts = {};
  };
  Moment moment(double time_s) const;
  /// Flake i at a time, in that window, wrapped at its sides but for its own gusts and flutter.
  PaperFlake flake(std::uint64_t i, const Moment& moment, const PaperBox& box) const;

 private:
  /// What carries all flakes through the box, in its sizes.
  struct Carried {
    glm::uvec2 way{0};     ///< from its low corner, units of 2^-32
    double per_m_s = 0.0;  ///< how far a speed has led by now
    double bottom = 0.0;   ///< its height above the scene's zero
  };
  static Carried carried(const Moment& moment, const PaperBox& box);
  /// Where flakes are but for their own gusts and flutter, which take them less than
  /// farthest_own_way_m() away.
  struct Drifting {
    Lanes<std::uint64_t> key;
    Lanes<std::int64_t> births;
    Lanes<double> v0_m_s;
    Lanes<double> x_m, y_m, z_m;  ///< from the box's low corner
  };
  /// Flakes first, first + 1, ...
  void drift(std::uint64_t first, const Carried& carried, const PaperBox& box,
             Drifting& flakes) const;
  PaperFlake flake(const Drifting& drifting, std::size_t lane, const Moment& moment,
                   const PaperBox& box) const;
  double farthest_own_way_m() const;
  Flake shown(const PaperFlake& flake, std::uint64_t bits) const;
  double flakes_in_view(double rate_mm_h) const;
  PaperBox box_of(const Frustum& frustum, const Heightfield& ground) const;

  Weather weather_;
  const FlakePictures& pictures_;
  WindField wind_;
  std::optional<Tornado> tornado_;
  std::uint64_t key_;
  glm::dvec3 box_m_;
  scene::CrystalChoice crystal_;
  double asked_for_;  ///< 0: [He2007]'s
  double shutter_s_;
};

}  // namespace wold::snow
