#include "snow/facets.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace wold::snow {
namespace {

/// AB x BC; as long as twice the facet's area.
glm::dvec3 long_normal(const Facet& facet) {
  const auto& [a, b, c] = facet.corners_m;
  return glm::cross(b - a, c - b);
}

glm::dvec3 corner_m(const Heightfield& terrain, const glm::dvec2& at_m) {
  return {at_m.x, at_m.y, terrain.sample(at_m.x, at_m.y)};
}

/// 1 if a dot has hit the texel, when `dots` are expected: its own even number is below 1 -
/// exp(-dots).
float hit(std::uint64_t seed, std::uint64_t texel, double dots) {
  const double chance = -std::expm1(-dots);
  const RandomKey key{seed, key_of("snow cover"), texel, key_of("dot")};
  return random_uniform(key) < chance ? 1.0F : 0.0F;
}

}  // namespace

double angle_deg(const Facet& facet) {
  const glm::dvec3 normal = long_normal(facet);
  return glm::degrees(std::atan2(glm::length(glm::dvec2(normal)), normal.z));
}

double texture_per_m2(const Facet& facet) {
  const double area_m2 = 0.5 * glm::length(long_normal(facet));
  return area_m2 > 0.0 ? facet.texture_area / area_m2 : 0.0;
}

double noise_per_m2(const Facet& facet, double gamma) {
  return angle_deg(facet) > 90.0 ? 0.0 : gamma * texture_per_m2(facet);
}

Facets::Facets(const Heightfield& terrain, double facet_m2)
    : along_side_(std::clamp(static_cast<int>(std::lround(
                                 std::min(terrain.size_m() / std::sqrt(2.0 * facet_m2), 1e6))),
                             1, terrain.samples() - 1)),
      facets_(static_cast<std::size_t>(2 * along_side_ * along_side_)) {
  const double side_m = terrain.size_m() / along_side_;
  const double texture_area = 0.5 / (static_cast<double>(along_side_) * along_side_);
  for (int j = 0; j < along_side_; ++j)
    for (int i = 0; i < along_side_; ++i) {
      const auto corner = [&](int x, int y) {
        return corner_m(terrain, glm::dvec2(i + x, j + y) * side_m);
      };
      Facet* const square = &facets_[2 * (static_cast<std::size_t>(j) * along_side_ + i)];
      square[0] = {{corner(0, 0), corner(1, 0), corner(1, 1)}, texture_area};
      square[1] = {{corner(0, 0), corner(1, 1), corner(0, 1)}, texture_area};
    }
}

FactorMap paper_white(const Facets& facets, double size_m, double gamma, int samples,
                      std::uint64_t seed) {
  constexpr double most_dots = 4.0;  // in a texel, at gamma = 1
  FactorMap white(samples, size_m);
  const double squares_per_texel = static_cast<double>(facets.along_side()) / (samples - 1);
  parallel_for(static_cast<std::size_t>(samples), [&](std::size_t row) {
    const int texel_row = static_cast<int>(row);
    for (int texel = 0; texel < samples; ++texel) {
      const glm::dvec2 at = glm::dvec2(texel, texel_row) * squares_per_texel;
      const glm::ivec2 square = glm::min(glm::ivec2(at), glm::ivec2(facets.along_side() - 1));
      const glm::dvec2 in_square = at - glm::dvec2(square);
      const Facet& facet = facets.at(square.x, square.y, in_square.y > in_square.x ? 1 : 0);
      const double phi = texture_per_m2(facet);
      if (phi <= 0.0) continue;
      const double texel_m2_per_texel = 1.0 / phi;  // ground under a texel, in texels' own area
      const double dots = most_dots * noise_per_m2(facet, gamma) * texel_m2_per_texel;
      const auto index = row * static_cast<std::size_t>(samples) + static_cast<std::size_t>(texel);
      white.at(texel, texel_row) = hit(seed, index, dots);
    }
  });
  return white;
}

}  // namespace wold::snow
