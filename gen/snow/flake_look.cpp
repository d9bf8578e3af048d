#include "snow/flake_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "snow/turns.h"

namespace wold::snow {
namespace {

/// Flakes tilt to either side of facing the eye by up to 60 degrees and turn about their middle: an
/// aggregate is no sheet, and is never seen edge on. Cosines of tilts 60 degrees sin(phase) have
/// the mean J0(pi / 3).
constexpr float most_tilt_turns = 1.0F / 6.0F;
constexpr float mean_tilt_cosine = 0.74407F;

constexpr float disc_area = 0.25F * std::numbers::pi_v<float>;  ///< of diameter 1

constexpr float least_length = 1e-12F;  ///< instead of none, where one divides by lengths

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

FlakeLook::FlakeLook(const FlakePictures& pictures, const Frustum& frustum, double shutter_s)
    : pictures_(pictures),
      frustum_(frustum),
      pixel_angle_(static_cast<float>(frustum.pixel_angle())),
      shutter_s_(static_cast<float>(shutter_s)),
      streak_area_(disc_area / pictures.mean_opacity(pictures.streak())),
      disc_side_(std::sqrt(disc_area / pictures.mean_opacity(pictures.disc()))) {
  for (std::size_t kind = 0; kind < crystal_kinds; ++kind)
    for (int individual = 0; individual < FlakePictures::individuals; ++individual) {
      const int finest = pictures.crystal(static_cast<Crystal>(kind), individual, 0);
      crystal_sides_[kind][static_cast<std::size_t>(individual)] =
          std::sqrt(disc_area / (pictures.mean_opacity(finest) * mean_tilt_cosine));
    }
}

WOLD_LANES_WIDE void FlakeLook::draw_discs(const FlakeLanes& flakes, Sights& sights) const {
  const float pixel_angle = pixel_angle_, disc_side = disc_side_;  // not what is written below
  Rectangles& discs = sights.discs;
  const VectorLanes& from_eye = flakes.from_eye;
  for (std::size_t i = 0; i < lanes; ++i) {
    const float x = from_eye.x[i], y = from_eye.y[i], z = from_eye.z[i];
    const float level2 = x * x + y * y;
    const float distance = std::sqrt(level2 + z * z);
    const float pixel = distance * pixel_angle;
    const float wanted = disc_side * flakes.diameter[i];
    const float side = greater(wanted, pixel);
    // As facing(), for the length of half a side.
    const float level = std::sqrt(level2);
    const bool upright = !(level > 1e-6F * distance);
    const float scale = 0.5F * side / greater(level, least_length);
    const float right_x = upright ? 0.5F * side : y * scale;
    const float right_y = upright ? 0.0F : -x * scale;
    const float to_eye = -1.0F / greater(distance, least_length);
    discs.right.x[i] = right_x;
    discs.right.y[i] = right_y;
    discs.right.z[i] = 0.0F;
    discs.up.x[i] = -to_eye * z * right_y;
    discs.up.y[i] = to_eye * z * right_x;
    discs.up.z[i] = to_eye * (x * right_y - y * right_x);
    discs.opacity[i] = flakes.opacity[i] * (wanted * wanted) / (side * side);
    sights.distance[i] = distance;
  }
}

WOLD_LANES_WIDE void FlakeLook::draw_streaks(const FlakeLanes& flakes, Sights& sights) const {
  const float pixel_angle = pixel_angle_, shutter_s = shutter_s_, streak_area = streak_area_;
  Rectangles& streaks = sights.streaks;
  const VectorLanes& from_eye = flakes.from_eye;
  const VectorLanes& velocity = flakes.velocity;
  for (std::size_t i = 0; i < lanes; ++i) {
    const float distance = sights.distance[i];
    const float to_eye = -1.0F / greater(distance, least_length);
    const float x = to_eye * from_eye.x[i];
    const float y = to_eye * from_eye.y[i];
    const float z = to_eye * from_eye.z[i];
    const float towards = velocity.x[i] * x + velocity.y[i] * y + velocity.z[i] * z;
    const float way_x = shutter_s * (velocity.x[i] - towards * x);
    const float way_y = shutter_s * (velocity.y[i] - towards * y);
    const float way_z = shutter_s * (velocity.z[i] - towards * z);
    const float way_length = std::sqrt(way_x * way_x + way_y * way_y + way_z * way_z);
    const float diameter = flakes.diameter[i];
    const float pixel = distance * pixel_angle;
    const float width = greater(diameter, pixel);
    const float length = width + way_length;
    const float per_way = 1.0F / greater(way_length, least_length);
    const float across = 0.5F * width * per_way;
    const float along = 0.5F * length * per_way;
    const float opacity = lesser(1.0F, streak_area * (diameter * diameter) / (width * length));
    streaks.right.x[i] = across * (way_y * z - way_z * y);
    streaks.right.y[i] = across * (way_z * x - way_x * z);
    streaks.right.z[i] = across * (way_x * y - way_y * x);
    streaks.up.x[i] = along * way_x;
    streaks.up.y[i] = along * way_y;
    streaks.up.z[i] = along * way_z;
    streaks.opacity[i] = flakes.opacity[i] * opacity;
    sights.way_length[i] = way_length;
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
  const float tilt = most_tilt_turns * sine_of_turns(flakes.tilt_turns[lane]);
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
  Sights sights;
  draw_discs(flakes, sights);
  draw_streaks(flakes, sights);
  for (std::size_t n = 0; n < chosen.count; ++n) {
    const std::size_t i = chosen.lane[n];
    const bool near = sights.distance[i] <= static_cast<float>(textured_within_m);
    const float crystal =
        near ? crystal_side(flakes.crystal[i], flakes.bits[i], flakes.diameter[i]) : 0.0F;
    const float size = std::max({flakes.diameter[i], sights.distance[i] * pixel_angle_, crystal});
    const bool streak = sights.way_length[i] > size;
    const Rectangles& drawn = streak ? sights.streaks : sights.discs;
    SeenFlake& seen = *to++;
    seen = {glm::vec3(frustum_.eye_m() + glm::dvec3(flakes.from_eye.at(i))), drawn.right.at(i),
            drawn.up.at(i), streak ? pictures_.streak() : pictures_.disc(), drawn.opacity[i]};
    if (near && !streak) draw_crystal(flakes, i, crystal, sights.distance[i], seen);
  }
  return to;
}

}  // namespace wold::snow
