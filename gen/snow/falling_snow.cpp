#include "snow/falling_snow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random.h"
#include "snow/near_field.h"

namespace wold::snow {
namespace {

constexpr int usual_flakes = 30000;

/// The air between two distances from the eye and the flakes that it shows.
struct Shell {
  double from_m;
  double to_m;
  PeriodicCube cube;
  std::uint64_t flakes;  ///< in the cube
  std::uint64_t key;
};

/// The smallest ball about all that is seen between two distances, with its centre straight ahead:
/// about the corners of the view at the farther one, or at both.
struct Ball {
  glm::dvec3 centre_m;
  double radius_m;
};

Ball ball_about(const Frustum& frustum, double from_m, double to_m) {
  const double cosine = std::cos(frustum.half_angle());
  const double sine = std::sin(frustum.half_angle());
  const double ahead_m = std::min(to_m * cosine, 0.5 * (from_m + to_m) / cosine);
  const double to_corners_m = std::hypot(to_m * cosine - ahead_m, to_m * sine);
  return {frustum.eye_m() + ahead_m * frustum.ahead(), std::max(to_corners_m, to_m - ahead_m)};
}

double drawn_share(double distance_m, double reach_m) { return std::exp(-distance_m / reach_m); }

/// Flakes per steradian that are drawn beyond a distance: n times the integral of r^2 k(r).
double drawn_beyond(double distance_m, const NearField& field) {
  const double x = distance_m / field.reach_m;
  return field.number_per_m3 * std::pow(field.reach_m, 3) * (x * x + 2.0 * x + 2.0) * std::exp(-x);
}

std::vector<Shell> shells_of(const Frustum& frustum, const NearField& field,
                             double farthest_own_way_m, std::uint64_t key) {
  std::vector<Shell> shells;
  double from_m = 0.0;
  double to_m = 1.0;
  while (drawn_beyond(from_m, field) * frustum.solid_angle_sr() > 0.5) {
    const Ball ball = ball_about(frustum, from_m, to_m);
    const double side_m = 2.0 * (ball.radius_m + farthest_own_way_m);
    const double number =
        field.number_per_m3 * drawn_share(from_m, field.reach_m) * side_m * side_m * side_m;
    shells.push_back({from_m,
                      to_m,
                      {ball.centre_m, side_m},
                      static_cast<std::uint64_t>(std::llround(number)),
                      random_bits({key, key_of("shell"), shells.size(), 0})});
    from_m = to_m;
    to_m *= std::numbers::sqrt2;  // the least work
  }
  return shells;
}

/// Picks what is seen of a shell's flakes.
class Picker {
 public:
  Picker(const FlakeMotion& motion, const FlakeMotion::Moment& moment, const FlakeLook& look,
         const Frustum& frustum, const Heightfield& ground, double reach_m)
      : motion_(motion),
        moment_(moment),
        look_(look),
        frustum_(frustum),
        ground_(ground),
        reach_m_(reach_m),
        margin_m_(motion.farthest_own_way_m()) {}

  void pick(const Shell& shell, std::uint64_t index, std::vector<SeenFlake>& seen) const {
    const auto drifting = motion_.drifting(shell.key, index, moment_, shell.cube);
    if (!may_be_seen(drifting.place_m, shell)) return;
    const Flake flake = motion_.flake(drifting, moment_);
    if (is_shown(flake, shell) && is_in_view(flake, frustum_, ground_))
      seen.push_back(look_.seen(flake));
  }

 private:
  bool may_be_seen(const glm::dvec3& place_m, const Shell& shell) const {
    const glm::dvec3 away = place_m - frustum_.eye_m();
    const double distance2 = glm::dot(away, away);
    const double near_m = std::max(0.0, shell.from_m - margin_m_);
    const double far_m = shell.to_m + margin_m_;
    return distance2 > near_m * near_m && distance2 <= far_m * far_m &&
           frustum_.touches(place_m, margin_m_);
  }

  bool is_shown(const Flake& flake, const Shell& shell) const {
    const double distance_m = glm::distance(flake.centre_m, frustum_.eye_m());
    return distance_m > shell.from_m && distance_m <= shell.to_m &&
           random_uniform({flake.bits, key_of("drawn"), 0, 0}) <
               drawn_share(distance_m - shell.from_m, reach_m_);
  }

  const FlakeMotion& motion_;
  const FlakeMotion::Moment& moment_;
  const FlakeLook& look_;
  const Frustum& frustum_;
  const Heightfield& ground_;
  double reach_m_;
  double margin_m_;
};

std::optional<FlakeMotion> motion_of(const scene::Scene& scene, const Weather& weather) {
  const double heaviest = weather.heaviest_mm_h();
  if (heaviest <= 0.0) return std::nullopt;
  return FlakeMotion(scene, weather, heaviest);
}

}  // namespace

FallingSnow::FallingSnow(const scene::Scene& scene, const Weather& weather,
                         const FlakePictures& pictures)
    : weather_(weather),
      pictures_(pictures),
      motion_(motion_of(scene, weather)),
      key_(random_bits({scene.seed, key_of("snow"), 0, key_of("flakes")})),
      flakes_(scene.snowfall.flakes > 0 ? scene.snowfall.flakes : usual_flakes),
      shutter_s_(scene.snowfall.shutter_s) {
  if (scene.wind.field == "tornado")
    tornado_.emplace(scene, key_, static_cast<std::uint64_t>(flakes_));
}

SeenFlakes FallingSnow::at(double time_s, const SnowView& view, const Heightfield& ground) const {
  const double rate_mm_h = weather_.snow_mm_h(time_s, view.eye_m.z);
  constexpr double least_rate_mm_h = 1e-3;  // a flake in 2 m3, and none of them seen
  if (!motion_ || rate_mm_h < least_rate_mm_h) return {};
  const Frustum frustum(view);
  const NearField field = near_field(rate_mm_h, frustum.solid_angle_sr(), flakes_);
  const FlakeMotion::Moment moment = motion_->moment(time_s, rate_mm_h);
  const FlakeLook look(pictures_, frustum, shutter_s_);
  const Picker picker(*motion_, moment, look, frustum, ground, field.reach_m);
  Gathering gathering;
  for (const Shell& shell : shells_of(frustum, field, motion_->farthest_own_way_m(), key_))
    gathering.add(shell.flakes, [&](std::uint64_t i, std::vector<SeenFlake>& seen) {
      picker.pick(shell, i, seen);
    });
  const FlakeLook whirled(pictures_, frustum, std::max(shutter_s_, whirl_shutter_s));
  if (tornado_) gathering.add(*tornado_, time_s, whirled, frustum, ground);
  return {gathering.farthest_first(view.eye_m), field.fog_extinction_per_m};
}

}  // namespace wold::snow
