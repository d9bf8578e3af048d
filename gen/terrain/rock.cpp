#include "terrain/rock.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// A block's face.
struct Face {
  glm::dvec3 tilt{0.0};  ///< of its normal, in [-1, 1] along each axis
  double shade = 0.0;    ///< of its own, in [-1, 1]
  double joint = 0.0;    ///< distance to the next joint, in blocks
};

/// Three numbers in [0, 1).
glm::dvec3 place_of(std::uint64_t bits) {
  constexpr std::uint64_t part_bits = 21, mask = (1ULL << part_bits) - 1;
  return glm::dvec3(bits & mask, bits >> part_bits & mask, bits >> 2 * part_bits & mask) /
         static_cast<double>(mask + 1);
}

/// Of the block about a place, in blocks.
Face face_at(const glm::dvec3& at, std::uint64_t key) {
  const glm::ivec3 low(glm::floor(at));
  double nearest2 = 1e9, next2 = 1e9;
  glm::dvec3 nearest{}, next{};
  std::uint64_t block = 0;
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const glm::ivec3 cell = low + glm::ivec3(i, j, k);
        const std::uint64_t bits =
            random_bits({key, static_cast<std::uint64_t>(cell.x),
                         static_cast<std::uint64_t>(cell.y), static_cast<std::uint64_t>(cell.z)});
        const glm::dvec3 away = glm::dvec3(cell) + place_of(bits) - at;
        const double away2 = glm::dot(away, away);
        if (away2 < nearest2) {
          next2 = nearest2, next = nearest;
          nearest2 = away2, nearest = away, block = bits;
        } else if (away2 < next2) {
          next2 = away2, next = away;
        }
      }
  return {2.0 * place_of(mixed(block)) - 1.0, 2.0 * place_of(mixed(block + 1)).x - 1.0,
          0.5 * (next2 - nearest2) / std::max(glm::distance(next, nearest), 1e-9)};
}

/// The largest bend of beds.
constexpr double bend_feature_m = 500.0;

/// How much of a joint a place is, 0 to 1, and the mean over all places.
double joint_at(const Face& face) { return 1.0 - glm::smoothstep(0.0, 0.08, face.joint); }
constexpr double mean_joint = 0.207;

/// Of what a block sends back, over the mean.
constexpr float darkest = 0.08F, brightest = 2.69F;

/// What a rough surface that faces `up` sends back of sun and sky: in clear air four fifths of the
/// light are the sun's, of a low sun less, of one that has set nothing.
double light_on(const glm::dvec3& up, const glm::dvec3& to_sun) {
  constexpr double low_sine = 0.1;
  const double sunlight = 0.8 * std::clamp(to_sun.z / low_sine, 0.0, 1.0);
  return sunlight * std::max(0.0, glm::dot(up, to_sun)) + (1.0 - sunlight) * (0.5 + 0.5 * up.z);
}

/// Beds that dip by 20 degrees, in a keyed direction.
glm::dmat3 beds(std::uint64_t key) {
  constexpr double dip = radians(20.0);
  const double heading = 2.0 * std::numbers::pi * random_uniform({key, key_of("dip"), 0, 0});
  const glm::dvec3 across(math::cos(heading), math::sin(heading), 0.0);
  const glm::dvec3 up = math::cos(dip) * glm::dvec3(0.0, 0.0, 1.0) +
                        math::sin(dip) * glm::dvec3(-across.y, across.x, 0.0);
  return glm::transpose(glm::dmat3(across, glm::cross(up, across), up));
}

}  // namespace

template <std::size_t count>
void Rock::Sizes<count>::show(double step_m, std::uint64_t with_key) {
  key = with_key;
  for (std::size_t i = 0; i < count; ++i) shown[i] = shown_fraction(sizes[i].block_m, step_m);
}

Rock::Rock(const glm::vec3& albedo, std::uint64_t seed, double step_m)
    : albedo_(albedo),
      key_(random_bits({seed, key_of("ground"), 0, key_of("rock")})),
      bend_(random_bits({key_, key_of("bend"), 0, 0}), {bend_feature_m, 0.2}, /*hurst=*/1.0,
            step_m),
      beds_(random_bits({key_, key_of("beds"), 0, 0}), {200.0, 0.1}, /*hurst=*/0.15, step_m),
      stain_{random_bits({key_, key_of("stain"), 0, 0}), 5, 0.5},
      stain_shown_(shown_fraction(1.2, step_m)),
      to_beds_(beds(key_)) {
  blocks_.show(step_m, key_);
  stones_.show(step_m, random_bits({key_, key_of("stones"), 0, 0}));
}

/// Bent, so that no joint is a straight line; a bed is half as thick as a block is wide.
glm::dvec3 Rock::bedded(const glm::dvec3& place_m) const {
  constexpr double bend = 0.08 * bend_feature_m, flatness = 2.0;
  const glm::dvec3 bent(bend_.at({place_m.y, place_m.z}), bend_.at({place_m.z, place_m.x}),
                        bend_.at({place_m.x, place_m.y}));
  return to_beds_ * (place_m + bend * bent) * glm::dvec3(1.0, 1.0, flatness);
}

/// Colour of the beds, over the mean: thick and thin ones, each long.
glm::vec3 Rock::bed_at(const glm::dvec3& bedded_m) const {
  constexpr double length = 30.0;  // over thickness
  const auto bed = static_cast<float>(
      std::clamp(beds_.at({bedded_m.z, (bedded_m.x + 0.7 * bedded_m.y) / length}), -2.5, 2.5));
  return 1.0F + bed * glm::vec3(0.19F, 0.17F, 0.14F);
}

template <std::size_t count>
float Rock::shade(const Sizes<count>& broken, const glm::dvec3& place_m, const glm::dvec3& up,
                  const glm::dvec3& to_sun) const {
  glm::dvec3 faced = up;  // of no unit length, so that faces have the light of `up` on the mean
  double open = 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Size& size = broken.sizes[i];
    const double shown = broken.shown[i];
    if (shown <= 0.0) continue;
    const Face face = face_at(place_m / size.block_m, broken.key + i);
    faced += shown * size.tilt * face.tilt;
    open *= 1.0 + shown * size.dark * (mean_joint - joint_at(face));
    open *= 1.0 + shown * size.own_shade * face.shade;
  }
  const double lit = light_on(faced, to_sun) / light_on(up, to_sun);
  return static_cast<float>(open * std::clamp(lit, 0.3, 1.8));
}

glm::vec3 Rock::at(const glm::dvec3& place_m, const glm::dvec3& up,
                   const glm::dvec3& to_sun) const {
  if (blocks_.shown.front() <= 0.0) return albedo_;
  const glm::dvec3 place = bedded(place_m);
  return albedo_ * glm::clamp(shade(blocks_, place, up, to_sun) * bed_at(place) * stain_at(place_m),
                              darkest, brightest);
}

glm::vec3 Rock::debris_at(const glm::dvec3& place_m, const glm::dvec3& up,
                          const glm::dvec3& to_sun) const {
  if (stones_.shown.front() <= 0.0) return albedo_;
  return albedo_ * std::clamp(shade(stones_, place_m, up, to_sun), darkest, brightest);
}

/// Damp and lichens.
glm::vec3 Rock::stain_at(const glm::dvec3& place_m) const {
  constexpr double feature_m = 1.2;
  const glm::dvec3 at = place_m / feature_m;
  const double stain =
      stain_shown_ * math::tanh(fbm({at.x + 0.7 * at.z, at.y - 0.7 * at.z}, stain_));
  return 1.0F + static_cast<float>(stain) * glm::vec3(0.16F, 0.13F, 0.06F);
}

}  // namespace wold::terrain
