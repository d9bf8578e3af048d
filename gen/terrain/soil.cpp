#include "terrain/soil.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// Of dry soil that was trampled or washed: clods of a hand's width down to crumbs of a centimetre.
constexpr std::array<BlockSize, 4> clod_sizes{{{0.3, 0.05, 0.06, 0.06, 0.08},
                                               {0.09, 0.08, 0.12, 0.08, 0.16},
                                               {0.03, 0.12, 0.2, 0.1, 0.24},
                                               {0.011, 0.14, 0.2, 0.12, 0.24}}};

/// Stones that lie on it, apart from each other: some of the cells of a plane full of blocks.
struct StoneSize {
  double block_m;
  double share;  ///< of the cells that are stones, where soil is as stony as on the mean
};
constexpr std::array<StoneSize, 2> stone_sizes{{{0.08, 0.03}, {0.035, 0.06}}};
/// Where in its cell a stone ends: distance to the next joint, in blocks.
constexpr double stone_edge = 0.16, stone_soft = 0.05;
/// Share of its cell that a stone covers, and of the light there that its hollow takes.
constexpr double stone_cover = 0.484, stone_hollow = 0.105;
/// Of a stone, over rock's albedo.
constexpr float mean_brightness = 0.85F;

double unit_of(std::uint64_t bits) { return static_cast<double>(mixed(bits) >> 11) * 0x1.0p-53; }

/// A stone at a place, or the hollow about it, which it shades.
struct Stone {
  double covered = 0.0;  ///< share of the place that is stone
  double hollow = 0.0;   ///< share of the light beside it that is missing
  double bright = 1.0;   ///< over rock's albedo
};

/// `is_stone`: share of the cells that are stones.
Stone stone_at(const glm::dvec2& at, std::uint64_t key, double is_stone, const glm::dvec3& up,
               const glm::dvec3& to_sun) {
  constexpr double dome = 0.8, least = 0.35, most = 1.4, most_hollow = 0.45;
  const Block<2> block = block_at<2>(at, key);
  if (unit_of(block.bits) >= is_stone) return {};
  const double covered =
      glm::smoothstep(stone_edge - stone_soft, stone_edge + stone_soft, block.joint);
  const double near = glm::smoothstep(0.0, stone_edge, block.joint);
  const glm::dvec3 faced = up - glm::dvec3(dome * block.middle_away, 0.0);
  const double lit = std::clamp(light_on(faced, to_sun) / light_on(up, to_sun), least, most);
  return {covered, most_hollow * near * (1.0 - covered),
          (0.6 + 0.5 * unit_of(block.bits + 1)) * lit};
}

/// A number in [0, 1) of one of the dead blades of a cell.
double of_blade(const glm::ivec2& cell, std::uint64_t number, std::uint64_t key,
                std::uint64_t purpose) {
  return random_uniform({key, static_cast<std::uint64_t>(cell.x),
                         static_cast<std::uint64_t>(cell.y), 16 * number + purpose});
}

/// How a dead blade lies.
struct LyingBlade {
  glm::dvec2 middle, along;  ///< in cells
  double half_length, half_width;
};

LyingBlade blade_of(const glm::ivec2& cell, std::uint64_t number, std::uint64_t key) {
  const double turn = std::numbers::pi * of_blade(cell, number, key, 0);
  return {
      glm::dvec2(cell) + glm::dvec2(of_blade(cell, number, key, 1), of_blade(cell, number, key, 2)),
      {math::cos(turn), math::sin(turn)},
      std::lerp(0.15, 0.75, of_blade(cell, number, key, 3)),
      std::lerp(0.015, 0.035, of_blade(cell, number, key, 4))};
}

bool lies_there(const glm::ivec2& cell, std::uint64_t number, std::uint64_t key, double dense) {
  return of_blade(cell, number, key, 5) < dense;
}

/// Share of a map's step that a blade covers at a place; lengths are in cells.
double covered_by(const LyingBlade& blade, const glm::dvec2& at, double step) {
  const glm::dvec2 way = at - blade.middle;
  const double along = glm::dot(way, blade.along);
  const double beside =
      glm::length(way - std::clamp(along, -blade.half_length, blade.half_length) * blade.along);
  const double soft = 0.5 * step;
  const double shown_half_width = std::max(blade.half_width, soft);
  return (1.0 - glm::smoothstep(-soft, soft, beside - shown_half_width)) * blade.half_width /
         shown_half_width;
}

constexpr std::uint64_t blades_a_cell = 3;
/// Share of the ground that they cover where litter is as dense as on the mean.
constexpr double mean_blades = 0.069;

}  // namespace

Soil::Soil(const scene::Terrain& terrain, std::uint64_t seed, double step_m)
    : albedo_(terrain.ground_albedo[0], terrain.ground_albedo[1], terrain.ground_albedo[2]),
      rock_albedo_(terrain.rock_albedo[0], terrain.rock_albedo[1], terrain.rock_albedo[2]),
      step_m_(step_m),
      wide_(random_bits({seed, key_of("ground"), 0, key_of("soil")}),
            {0.1 * terrain.size_m, 2.0 * moisture_m}, /*hurst=*/0.1, step_m),
      moisture_{random_bits({seed, key_of("ground"), 0, key_of("moisture")}), 2, 0.8},
      litter_{random_bits({seed, key_of("ground"), 0, key_of("litter")}), 3, 0.3},
      stony_{random_bits({seed, key_of("ground"), 0, key_of("stony")}), 3, 0.3},
      wet_shown_(shown_fraction(moisture_m, step_m)),
      litter_shown_(shown_fraction(litter_m, step_m)),
      blades_shown_(shown_fraction(0.2 * blade_m, step_m)),
      clods_(clod_sizes, random_bits({seed, key_of("ground"), 0, key_of("clods")}), step_m),
      blades_key_(random_bits({seed, key_of("ground"), 0, key_of("lying blades")})),
      stones_key_(random_bits({seed, key_of("ground"), 0, key_of("lying stones")})) {}

/// How much more litter lies than on the mean, in (-1, 1).
double Soil::litter_at(const glm::dvec2& at_m) const {
  return math::tanh(0.8 * litter_.at(at_m / litter_m));
}

/// Soil, darker where moist, with pale dry litter on it.
glm::vec3 Soil::earth_at(const glm::dvec2& at_m) const {
  const auto wet =
      static_cast<float>(wet_shown_ * std::clamp(moisture_.at(at_m / moisture_m), -2.0, 2.0));
  const auto straw = static_cast<float>(litter_shown_ * litter_at(at_m));
  const auto kind = static_cast<float>(std::clamp(wide_.at(at_m), -2.0, 2.0));
  return albedo_ * (1.0F + kind * glm::vec3(0.16F, 0.18F, 0.2F)) * (1.0F - 0.12F * wet) *
         (1.0F + straw * glm::vec3(0.30F, 0.30F, 0.24F));
}

/// More of them where litter lies.
glm::vec3 Soil::with_blades(const glm::vec3& earth, const glm::dvec2& at_m) const {
  if (blades_shown_ <= 0.0) return earth;
  const double dense = 0.5 + 0.35 * litter_at(at_m);
  const glm::dvec2 at = at_m / blade_m;
  const glm::ivec2 low(glm::floor(at));
  double covered = 0.0;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
      for (std::uint64_t n = 0; n < blades_a_cell; ++n) {
        const glm::ivec2 cell = low + glm::ivec2(i, j);
        if (!lies_there(cell, n, blades_key_, dense)) continue;
        const LyingBlade blade = blade_of(cell, n, blades_key_);
        covered = std::max(covered, covered_by(blade, at, step_m_ / blade_m));
      }
  const auto over_mean = static_cast<float>(blades_shown_ * (covered - mean_blades));
  return earth * (1.0F + over_mean * glm::vec3(1.2F, 1.2F, 0.95F));
}

/// The mean stays that of soil without stones.
glm::vec3 Soil::with_stones(glm::vec3 earth, const glm::dvec2& at_m, const glm::dvec3& up,
                            const glm::dvec3& to_sun) const {
  constexpr double stony_m = 2.5;
  if (shown_fraction(stone_sizes.front().block_m, step_m_) <= 0.0) return earth;
  const double stony = std::clamp(1.0 + 0.8 * stony_.at(at_m / stony_m), 0.0, 2.0);
  for (std::size_t i = 0; i < stone_sizes.size(); ++i) {
    const StoneSize& size = stone_sizes[i];
    const double shown = shown_fraction(size.block_m, step_m_);
    if (shown <= 0.0) break;
    const Stone stone =
        stone_at(at_m / size.block_m, stones_key_ + i, size.share * stony, up, to_sun);
    const auto hollow = static_cast<float>(shown * (stone.hollow - size.share * stone_hollow));
    const auto covered = static_cast<float>(shown * stone.covered);
    const auto mean = static_cast<float>(shown * size.share * stone_cover);
    earth *= 1.0F - hollow;
    earth += covered * (static_cast<float>(stone.bright) * rock_albedo_ - earth) -
             mean * (mean_brightness * rock_albedo_ - albedo_);
  }
  return glm::max(earth, glm::vec3(0.0F));
}

glm::vec3 Soil::at(const glm::dvec2& at_m, const glm::dvec3& up, const glm::dvec3& to_sun) const {
  const glm::vec3 earth = earth_at(at_m);
  if (!clods_.is_shown()) return earth;
  const glm::vec3 broken = earth * static_cast<float>(clods_.shade(at_m, up, to_sun));
  return with_stones(with_blades(broken, at_m), at_m, up, to_sun);
}

}  // namespace wold::terrain
