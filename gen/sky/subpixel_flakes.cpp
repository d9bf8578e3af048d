#include "sky/subpixel_flakes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/random.h"

namespace wold::sky {
namespace {

/// The fraction of flakes of an opacity that is drawn when none is fainter than the least.
double drawn_fraction(float opacity, float min_opacity) {
  return opacity >= min_opacity ? 1.0 : static_cast<double>(opacity / min_opacity);
}

/// How many flakes a ray passes, in the part of the picture where most are: a ray of a part passes
/// a flake by the fraction of the part that the flake covers.
double flakes_on_a_ray(const std::vector<snow::SeenFlake>& flakes, const snow::Frustum& frustum,
                       float min_opacity) {
  constexpr int parts = 48;  // each way
  std::array<double, std::size_t{parts}* parts> passed = {};
  const double part_sr = frustum.solid_angle_sr() / (parts * parts);
  for (const snow::SeenFlake& flake : flakes) {
    const glm::dvec3 from_eye_m = glm::dvec3(flake.centre_m) - frustum.eye_m();
    const glm::dvec2 place = 0.5 * frustum.in_picture(from_eye_m) + 0.5;
    if (!(place.x >= 0.0 && place.x < 1.0 && place.y >= 0.0 && place.y < 1.0)) continue;
    const double area_m2 = 4.0 * glm::length(flake.right_m) * glm::length(flake.up_m);
    const double covered = area_m2 / (glm::dot(from_eye_m, from_eye_m) * part_sr);
    const glm::ivec2 part(place * static_cast<double>(parts));
    passed[static_cast<std::size_t>(part.y) * parts + part.x] +=
        std::min(1.0, covered) * drawn_fraction(flake.opacity, min_opacity);
  }
  return *std::max_element(passed.begin(), passed.end());
}

float min_opacity_of(const std::vector<snow::SeenFlake>& flakes, const snow::Frustum& frustum,
                     double max_on_a_ray) {
  if (flakes_on_a_ray(flakes, frustum, 0.0F) <= max_on_a_ray) return 0.0F;
  float min = 1.0F / 64.0F;
  while (min < 1.0F && flakes_on_a_ray(flakes, frustum, min) > max_on_a_ray)
    min *= std::numbers::sqrt2_v<float>;
  return std::min(min, 1.0F);
}

/// A number of the flake's own, uniform in [0, 1).
double chance_of(const snow::SeenFlake& flake, std::uint64_t seed) {
  const auto place = std::bit_cast<std::array<std::uint32_t, 3>>(flake.centre_m);
  const std::uint64_t index = mixed((std::uint64_t{place[0]} << 32) ^ place[1]) ^ place[2];
  return random_uniform({seed, key_of("flake"), index, key_of("faint")});
}

}  // namespace

std::vector<snow::SeenFlake> without_subpixel_flakes(std::vector<snow::SeenFlake> flakes,
                                                     const snow::Frustum& frustum,
                                                     std::uint64_t seed, double max_on_a_ray) {
  const float min_opacity = min_opacity_of(flakes, frustum, max_on_a_ray);
  std::erase_if(flakes, [&](const snow::SeenFlake& flake) {
    return flake.opacity < min_opacity &&
           chance_of(flake, seed) >= drawn_fraction(flake.opacity, min_opacity);
  });
  for (snow::SeenFlake& flake : flakes) flake.opacity = std::max(flake.opacity, min_opacity);
  return flakes;
}

}  // namespace wold::sky
