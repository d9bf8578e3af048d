#include "expectation/expectation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/colour.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "expectation/ground_march.h"
#include "expectation/sights.h"
#include "landscape/perspective.h"
#include "landscape/raised_cast.h"

namespace wold::expectation {
namespace {

enum class Kind { nothing, grass, blades, clouds };

constexpr std::array<std::pair<Kind, const char*>, 3> kinds = {
    {{Kind::grass, "grass"}, {Kind::blades, "blades"}, {Kind::clouds, "clouds"}}};

/// ExpectedThings::min_fraction: right pictures of the examples show 0.97 to 1.30 of their meadows
/// and 0.97 to 1.02 of their clouds, but 0.66 of points, which hide each other, and of a meadow
/// that is a few patches, of which each looks in its own way, 0.9 to 1.1. Straw in snow, for most
/// of which other plants' volumes spoke, showed 0.84.
double min_fraction(Kind kind, const GrassKnowledge& grass) {
  constexpr std::size_t many_patches = 50;
  constexpr double min_own_fraction = 0.5;
  if (kind == Kind::blades) return 0.4;
  if (kind == Kind::clouds) return 0.88;
  if (grass.patches < many_patches) return 0.5;
  return grass.own_fraction >= min_own_fraction ? 0.88 : 0.75;
}

/// Tiles of equal size that cover a picture, and rays through each.
struct Tiling {
  glm::ivec2 tiles;    ///< columns and rows
  glm::dvec2 tile_px;  ///< size of each
  int rays_per_side;

  int count() const { return tiles.x * tiles.y; }
  std::size_t rays_per_tile() const {
    return static_cast<std::size_t>(rays_per_side) * static_cast<std::size_t>(rays_per_side);
  }
  /// Where a ray goes through the picture, in pixels.
  glm::dvec2 place_px(int tile, int ray) const {
    const glm::dvec2 in_tile = (glm::dvec2(ray % rays_per_side, ray / rays_per_side) + 0.5) /
                               static_cast<double>(rays_per_side);
    return (glm::dvec2(tile % tiles.x, tile / tiles.x) + in_tile) * tile_px;
  }
};

/// No tile is smaller than 8 pixels, as far as there are so many. Few tiles get more rays each.
Tiling tiling_of(const landscape::Landscape& landscape) {
  constexpr double rays = 20000.0;
  const glm::ivec2 size_px(landscape.width_px, landscape.height_px);
  const glm::ivec2 tiles = glm::clamp(size_px / 8, glm::ivec2(1), glm::ivec2(32, 18));
  const auto side = static_cast<int>(std::lround(std::sqrt(rays / (tiles.x * tiles.y))));
  return {tiles, glm::dvec2(size_px) / glm::dvec2(tiles), std::clamp(side, 6, 32)};
}

landscape::Perspective perspective_of(const landscape::Landscape& landscape) {
  return {landscape.camera, {landscape.width_px, landscape.height_px}};
}

/// Tile by tile, without grass and blades.
std::vector<Sight> bare_sights(const landscape::Landscape& landscape, const Tiling& tiling) {
  const landscape::Perspective perspective = perspective_of(landscape);
  const glm::dvec3& eye_m = landscape.camera.eye_m;
  const GroundMarch march(landscape.terrain);
  const landscape::RaisedCast boulders(landscape.boulders);
  std::vector<Sight> sights(static_cast<std::size_t>(tiling.count()) * tiling.rays_per_tile());
  parallel_for(sights.size(), [&](std::size_t i) {
    const auto tile = static_cast<int>(i / tiling.rays_per_tile());
    const auto ray = static_cast<int>(i % tiling.rays_per_tile());
    Sight& sight = sights[i];
    sight.direction = perspective.direction(tiling.place_px(tile, ray));
    const double ground_m =
        boulders.distance_m(eye_m, sight.direction, march.distance_m(eye_m, sight.direction));
    sight.meets_ground = std::isfinite(ground_m);
    sight.bare = bare_view(landscape, eye_m, sight.direction, ground_m);
    sight.clouds = cloud_view(landscape.clouds, eye_m, sight.direction, sight.bare.distance_m);
  });
  return sights;
}

glm::dvec3 over(const landscape::AggregateAppearance& look, const glm::dvec3& behind) {
  return look.radiance + look.transmittance * behind;
}

glm::dvec3 in_fog(const std::optional<landscape::Fog>& fog, const glm::dvec3& radiance,
                  double length_m) {
  if (!fog) return radiance;
  return glm::mix(glm::dvec3(fog->radiance), radiance,
                  math::exp(-fog->extinction_per_m * length_m));
}

/// What is seen if all but one kind of things is there.
glm::dvec3 seen_without(Kind kind, const Sight& sight, const std::optional<landscape::Fog>& fog) {
  glm::dvec3 seen(sight.bare.radiance);
  if (sight.grass && kind != Kind::grass) seen = over(*sight.grass, seen);
  if (sight.blades && kind != Kind::blades) seen = over(*sight.blades, seen);
  if (kind == Kind::clouds) return in_fog(fog, seen, sight.bare.distance_m);
  seen = in_fog(fog, seen, sight.bare.distance_m - sight.clouds.distance_m);
  return in_fog(fog, over(sight.clouds.look, seen), sight.clouds.distance_m);
}

double mean_opacity(const landscape::FlakePicture& picture) {
  double sum = 0.0;
  for (const float opacity : picture.opacity.values) sum += double{opacity};
  return sum / static_cast<double>(picture.opacity.values.size());
}

/// The fraction of each tile that flakes let through. A flake counts where its middle is.
std::vector<double> through_flakes(const landscape::Landscape& landscape, const Tiling& tiling) {
  const landscape::Perspective perspective = perspective_of(landscape);
  std::vector<double> opacities;
  for (const landscape::FlakePicture& picture : landscape.flakes.pictures)
    opacities.push_back(mean_opacity(picture));
  std::vector<double> depth(static_cast<std::size_t>(tiling.count()), 0.0);
  for (const landscape::Flake& flake : landscape.flakes.flakes) {
    const glm::dvec3 seen = perspective.seen(glm::dvec3(flake.centre_m));
    const glm::dvec2 tile = glm::floor(glm::dvec2(seen) / tiling.tile_px);
    if (seen.z <= 0.0 || glm::any(glm::lessThan(tile, glm::dvec2(0.0))) ||
        glm::any(glm::greaterThanEqual(tile, glm::dvec2(tiling.tiles))))
      continue;
    const double pixels_per_m = perspective.pixels_per_m(seen.z);
    const double area_px = 4.0 * double{glm::length(flake.right_m)} *
                           double{glm::length(flake.up_m)} * pixels_per_m * pixels_per_m;
    depth[static_cast<std::size_t>(tile.y * tiling.tiles.x + tile.x)] +=
        area_px / (tiling.tile_px.x * tiling.tile_px.y) * double{flake.opacity} *
        opacities[static_cast<std::size_t>(flake.picture)];
  }
  for (double& tile : depth) tile = math::exp(-tile);
  return depth;
}

/// As a picture has it, linear, where `through` of it is seen between flakes.
glm::dvec3 exposed(const landscape::Landscape& landscape, const glm::dvec3& seen, double through) {
  const glm::dvec3 flakes(landscape.flakes.radiance);
  return glm::clamp(landscape.exposure_gain * glm::mix(flakes, seen, through), 0.0, 1.0);
}

/// Tiles that differ by less say nothing: a hundredth of the way from black to white.
bool differ(const glm::vec3& a, const glm::vec3& b) {
  constexpr double min = 0.01;
  const glm::dvec3 difference = glm::abs(srgb_encoded(glm::dvec3(a)) - srgb_encoded(glm::dvec3(b)));
  return std::max({difference.r, difference.g, difference.b}) >= min;
}

/// The sights through a tile, row by row.
std::span<const Sight> sights_through(const std::vector<Sight>& sights, const Tiling& tiling,
                                      int tile) {
  return std::span(sights).subspan(static_cast<std::size_t>(tile) * tiling.rays_per_tile(),
                                   tiling.rays_per_tile());
}

/// Those of the next row of rays above a tile, or below it; none beyond the picture.
std::span<const Sight> next_row(const std::vector<Sight>& sights, const Tiling& tiling, int tile,
                                bool above) {
  const int next = above ? tile - tiling.tiles.x : tile + tiling.tiles.x;
  if (next < 0 || next >= tiling.count()) return {};
  const auto side = static_cast<std::size_t>(tiling.rays_per_side);
  const std::span<const Sight> rays = sights_through(sights, tiling, next);
  return above ? rays.last(side) : rays.first(side);
}

/// Grass that rises before the sky is not reckoned with, so nothing is known of tiles at the
/// horizon.
bool is_certain(Kind kind, const std::vector<Sight>& sights, const Tiling& tiling, int tile) {
  const bool on_ground = kind != Kind::clouds;
  const auto fits = [&](const Sight& sight) { return sight.meets_ground == on_ground; };
  return std::ranges::all_of(sights_through(sights, tiling, tile), fits) &&
         std::ranges::all_of(next_row(sights, tiling, tile, on_ground), fits);
}

}  // namespace

ExpectedPicture expected_picture(const landscape::Landscape& landscape) {
  const Tiling tiling = tiling_of(landscape);
  std::vector<Sight> sights = bare_sights(landscape, tiling);
  const GrassKnowledge grass = look_at_grass(landscape, sights);
  look_at_blades(landscape, sights);
  const std::vector<double> through = through_flakes(landscape, tiling);
  const auto mean_without = [&](Kind kind, int tile) {
    glm::dvec3 sum(0.0);
    for (const Sight& sight : sights_through(sights, tiling, tile))
      sum += exposed(landscape, seen_without(kind, sight, landscape.fog),
                     through[static_cast<std::size_t>(tile)]);
    return glm::vec3(sum / static_cast<double>(tiling.rays_per_tile()));
  };
  ExpectedPicture expected{tiling.tiles, {}};
  for (const auto& [kind, name] : kinds) {
    ExpectedThings things{name, min_fraction(kind, grass), {}};
    for (int tile = 0; tile < tiling.count(); ++tile) {
      if (!is_certain(kind, sights, tiling, tile)) continue;
      const ExpectedTile seen{tile, mean_without(Kind::nothing, tile), mean_without(kind, tile)};
      if (differ(seen.with, seen.without)) things.tiles.push_back(seen);
    }
    if (!things.tiles.empty()) expected.things.push_back(std::move(things));
  }
  return expected;
}

}  // namespace wold::expectation
