#include "snow/flake_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simd_turns.h"

namespace wold::snow {
namespace {

/// Flakes tilt to either side of facing the eye by up to 60 degrees and turn about their middle: an
/// aggregate is no sheet, and is never seen edge on. Cosines of tilts 60 degrees sin(phase) have
/// the mean J0(pi / 3).
constexpr float max_tilt_turns = 1.0F / 6.0F;
constexpr float mean_tilt_cosine = 0.74407F;

constexpr float disc_area = 0.25F * std::numbers::pi_v<float>;  ///< of diameter 1

constexpr float min_length = 1e-12F;  ///< instead of none, where one divides by lengths

std::size_t individual_of(std::uint64_t bits) {
  static_assert(FlakePictures::individuals == 4);
  return static_cast<std::size_t>(bits >> 62);
}

/// The coarsest level whose pixels are no larger than the view's, for so many pixels of the finest
/// in one of the view's.
int level_of(float finest_in_one) {
  int level = 0;
  for (float pixels = 2.0F; level + 1 < FlakePictures::levels && finest_in_one >= pixels;
       pixels *= 2.0F)
    ++level;
  return level;
}

}  // namespace

FlakeLook::FlakeLook(const FlakePictures& pictures, const Frustum& frustum, double shutter_s,
                     Falling what)
    : pictures_(pictures),
      frustum_(frustum),
      pixel_angle_(static_cast<float>(frustum.pixel_angle())),
      shutter_s_(static_cast<float>(shutter_s)),
      what_(what),
      streak_area_(disc_area / pictures.mean_opacity(pictures.streak())),
      disc_side_(std::sqrt(disc_area / pictures.mean_opacity(pictures.disc()))) {
  for (std::size_t kind = 0; kind < crystal_kinds; ++kind)
    for (int individual = 0; individual < FlakePictures::individuals; ++individual) {
      const int finest = pictures.crystal(static_cast<Crystal>(kind), individual, 0);
      crystal_sides_[kind][static_cast<std::size_t>(individual)] =
          std::sqrt(disc_area / (pictures.mean_opacity(finest) * mean_tilt_cosine));
    }
}

WOLD_LANES_WIDE void FlakeLook::draw_far(const FlakeLanes& flakes, Rectangles& drawn) const {
  const float pixel_angle = pixel_angle_, disc_side = disc_side_;
  const float shutter_s = shutter_s_, streak_area = streak_area_;
  const int disc = pictures_.disc(), streak = pictures_.streak();
  const glm::dvec3 eye = frustum_.eye_m();
  for (std::size_t i = 0; i < lanes; ++i) {
    const float x = flakes.from_eye.x[i], y = flakes.from_eye.y[i], z = flakes.from_eye.z[i];
    const float diameter = flakes.diameter[i];
    const float level2 = x * x + y * y;
    const float distance = std::sqrt(level2 + z * z);
    const float pixel = distance * pixel_angle;
    const float ahead = 1.0F / greater(distance, min_length);
    const float ahead_x = ahead * x, ahead_y = ahead * y, ahead_z = ahead * z;

    // A disc's sides are those of facing().
    const float wanted = disc_side * diameter;
    const float side = greater(wanted, pixel);
    const float level = std::sqrt(level2);
    const bool upright = !(level > 1e-6F * distance);
    const float scale = 0.5F * side / greater(level, min_length);
    const float disc_x = upright ? 0.5F * side : y * scale;
    const float disc_y = upright ? 0.0F : -x * scale;
    const float disc_opacity = wanted * wanted / (side * side);

    // A streak's are along its way across the way to the eye, and across it.
    const float speed_x = flakes.velocity.x[i], speed_y = flakes.velocity.y[i],
                speed_z = flakes.velocity.z[i];
    const float off = speed_x * ahead_x + speed_y * ahead_y + speed_z * ahead_z;
    const float way_x = shutter_s * (speed_x - off * ahead_x);
    const float way_y = shutter_s * (speed_y - off * ahead_y);
    const float way_z = shutter_s * (speed_z - off * ahead_z);
    const float way_length = std::sqrt(way_x * way_x + way_y * way_y + way_z * way_z);
    const float width = greater(diameter, pixel);
    const float length = width + way_length;
    const float per_way = 0.5F / greater(way_length, min_length);
    const float across = width * per_way, along = length * per_way;
    const float streak_opacity =
        lesser(1.0F, streak_area * (diameter * diameter) / (width * length));

    const bool fast = way_length > width;
    drawn.centre.x[i] = static_cast<float>(eye.x + static_cast<double>(x));
    drawn.centre.y[i] = static_cast<float>(eye.y + static_cast<double>(y));
    drawn.centre.z[i] = static_cast<float>(eye.z + static_cast<double>(z));
    drawn.right.x[i] = fast ? across * (way_z * ahead_y - way_y * ahead_z) : disc_x;
    drawn.right.y[i] = fast ? across * (way_x * ahead_z - way_z * ahead_x) : disc_y;
    drawn.right.z[i] = fast ? across * (way_y * ahead_x - way_x * ahead_y) : 0.0F;
    drawn.up.x[i] = fast ? along * way_x : ahead_z * disc_y;
    drawn.up.y[i] = fast ? along * way_y : -ahead_z * disc_x;
    drawn.up.z[i] = fast ? along * way_z : ahead_y * disc_x - ahead_x * disc_y;
    drawn.picture[i] = fast ? streak : disc;
    drawn.opacity[i] = flakes.opacity[i] * (fast ? streak_opacity : disc_opacity);
    drawn.distance[i] = distance;
    drawn.way_length[i] = way_length;
  }
}

float FlakeLook::crystal_side(Crystal crystal, std::uint64_t bits, float diameter) const {
  return diameter * crystal_sides_[static_cast<std::size_t>(crystal)][individual_of(bits)];
}

void FlakeLook::draw_crystal(const FlakeLanes& flakes, std::size_t lane, float side, float distance,
                             SeenFlake& seen) const {
  const glm::vec3 towards_eye = flakes.from_eye.at(lane) * (-1.0F / distance);
  const float pixel = distance * pixel_angle_;
  const auto [right, up] = facing(towards_eye);
  const float tilt = max_tilt_turns * sine_of_turns(flakes.tilt_turns[lane]);
  const float sine = sine_of_turns(flakes.spin_turns[lane]);
  const float cosine = cosine_of_turns(flakes.spin_turns[lane]);
  const glm::vec3 axis = cosine * right + sine * up;
  const glm::vec3 across = cosine * up - sine * right;
  const glm::vec3 tilted = cosine_of_turns(tilt) * across + sine_of_turns(tilt) * towards_eye;
  const int level = level_of(static_cast<float>(FlakePictures::finest_px) * pixel / side);
  seen.right_m = 0.5F * side * axis;
  seen.up_m = 0.5F * side * tilted;
  seen.picture = pictures_.crystal(flakes.crystal[lane],
                                   static_cast<int>(individual_of(flakes.bits[lane])), level);
  seen.opacity = flakes.opacity[lane];
}

SeenFlake* FlakeLook::see(const FlakeLanes& flakes, const Chosen& chosen, SeenFlake* to) const {
  Rectangles drawn;
  draw_far(flakes, drawn);
  for (std::size_t n = 0; n < chosen.count; ++n) {
    const std::size_t i = chosen.lane[n];
    SeenFlake& seen = *to++;
    seen = {drawn.centre.at(i), drawn.right.at(i), drawn.up.at(i), drawn.picture[i],
            drawn.opacity[i]};
    if (what_ == Falling::rain || drawn.distance[i] > static_cast<float>(textured_within_m))
      continue;
    // Crystals span more than discs; what moves by less than that is no streak.
    const float side = crystal_side(flakes.crystal[i], flakes.bits[i], flakes.diameter[i]);
    if (drawn.way_length[i] <= greater(side, drawn.distance[i] * pixel_angle_))
      draw_crystal(flakes, i, side, drawn.distance[i], seen);
  }
  return to;
}

}  // namespace wold::snow
