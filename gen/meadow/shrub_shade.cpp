#include "meadow/shrub_shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/samples_between.h"
#include "place/view.h"
#include "scene/species.h"

namespace wold::meadow {
namespace {

/// How far a ray goes on in the upper half of a sphere of radius 1, which lies on the ground.
/// `start`: from its middle; `along`: what the ray makes of a metre.
double way_in_m(const glm::dvec3& start, const glm::dvec3& along) {
  const double a = glm::dot(along, along), b = glm::dot(start, along);
  const double discriminant = b * b - a * (glm::dot(start, start) - 1.0);
  if (discriminant <= 0.0) return 0.0;
  const double root = std::sqrt(discriminant);
  const double enters_m = std::max({0.0, (-root - b) / a, -start.z / along.z});
  return std::max(0.0, (root - b) / a - enters_m);
}

/// Suns lower over the ground than the first cast no shade of their own: it lies everywhere. Those
/// higher than the second cast all of it.
constexpr double low_sun = 0.04, high_sun = 0.1;

}  // namespace

ShrubShade::Shrubs::Shrubs(const scene::Scene& scene, int patch) {
  double leaves_m2 = 0.0, volume_m3 = 0.0;
  const std::vector<scene::Species> species = scene::species_of(scene);
  const scene::Mixture mixture = scene::mixture_of(scene, patch);
  const std::vector<int> leaves = scene::blades_of(scene, mixture);
  for (std::size_t k = 0; k < mixture.size(); ++k) {
    const scene::Species& one = species[static_cast<std::size_t>(mixture[k])];
    if (!scene::is_shrub(one)) continue;
    const grass::Crown crown = grass::crown_of(one.plant, scene.grass.patch_m, scene.seed, patch);
    for (const grass::Crown::Cushion& cushion : crown.cushions()) {
      cushions.push_back(cushion);
      height_m = std::max(height_m, cushion.height_m);
      volume_m3 +=
          2.0 / 3.0 * std::numbers::pi * cushion.radius_m * cushion.radius_m * cushion.height_m;
    }
    leaves_m2 += leaves[k] * scene::blade_area_m2(one);
  }
  extinction_per_m = 0.5 * leaves_m2 / volume_m3;
}

double ShrubShade::Shrubs::optical_depth(const glm::dvec3& start_m, const glm::dvec3& along) const {
  double way_m = 0.0;
  for (const grass::Crown::Cushion& cushion : cushions) {
    const glm::dvec3 radii_m(cushion.radius_m, cushion.radius_m, cushion.height_m);
    const glm::dvec3 start = (start_m - glm::dvec3(cushion.middle_m, 0.0)) / radii_m;
    if (glm::length(glm::dvec2(start)) < 1.0) return 0.0;
    way_m += way_in_m(start, along / radii_m);
  }
  return extinction_per_m * way_m;
}

ShrubShade::ShrubShade(const scene::Scene& scene, std::span<const CellChoice> choices,
                       const glm::dvec3& to_sun)
    : to_sun_(to_sun), patch_m_(scene.grass.patch_m), grass_m_(scene::mean_grass(scene).height_m) {
  for (const CellChoice& choice : choices) {
    if (!choice.beside_cell) continue;
    auto of_patch = patches_.find(choice.variant);
    if (of_patch == patches_.end())
      of_patch = patches_.emplace(choice.variant, Shrubs(scene, choice.variant)).first;
    add(of_patch->second, *choice.beside_cell);
  }
}

void ShrubShade::add(const Shrubs& shrubs, const BesideCell& beside) {
  constexpr double farther = 1.5;  // where the ground falls away from the plane under them
  const glm::dmat4& world_from_cell = beside.world_from_patch;
  const glm::dmat4 cell_from_world = glm::inverse(world_from_cell);
  const glm::dvec3 along = glm::dmat3(cell_from_world) * to_sun_;
  const double cast = beside.standing * glm::smoothstep(low_sun, high_sun, along.z);
  if (cast <= 0.0) return;
  const auto in_world = [&](const glm::dvec2& at_m, double w) {
    return glm::dvec2(world_from_cell * glm::dvec4(at_m, 0.0, w));
  };
  const glm::dvec2 corner_m = in_world({0.0, 0.0}, 1.0),
                   other_m = in_world(glm::dvec2(patch_m_), 1.0);
  const double size_m = patch_m_ * glm::length(glm::dvec3(world_from_cell[0]));
  placed_.push_back({&shrubs, cell_from_world, along, size_m, cast, glm::min(corner_m, other_m),
                     glm::max(corner_m, other_m),
                     in_world(-farther * shrubs.height_m / along.z * glm::dvec2(along), 0.0)});
}

glm::dvec2 ShrubShade::Placed::between_m(double y_m) const {
  double first = 0.0, last = 1.0;  // of the way that the shade falls
  if (falls_m.y != 0.0) {
    const double a = (y_m - high_m.y) / falls_m.y, b = (y_m - low_m.y) / falls_m.y;
    first = std::clamp(std::min(a, b), 0.0, 1.0);
    last = std::clamp(std::max(a, b), 0.0, 1.0);
  }
  return {low_m.x + std::min(first * falls_m.x, last * falls_m.x),
          high_m.x + std::max(first * falls_m.x, last * falls_m.x)};
}

std::optional<FactorMap> ShrubShade::sunlit(const Heightfield& terrain, const GroundGrid& grid,
                                            const terrain::SnowDepth& snow_m) const {
  const auto is_shown = [&](const Placed& placed) {
    return shown_fraction(placed.size_m, grid.step_m()) > 0.0;
  };
  if (std::ranges::none_of(placed_, is_shown)) return std::nullopt;
  std::vector<std::vector<const Placed*>> of_rows(static_cast<std::size_t>(grid.samples));
  for (const Placed& placed : placed_) {
    const glm::ivec2 rows = samples_between(placed.low_m.y + std::min(0.0, placed.falls_m.y),
                                            placed.high_m.y + std::max(0.0, placed.falls_m.y),
                                            grid.square.corner_m.y, grid);
    for (int row = rows[0]; row <= rows[1]; ++row)
      of_rows[static_cast<std::size_t>(row)].push_back(&placed);
  }
  const auto lit_m = [&](const glm::dvec2& at_m) {
    const double half_up_m = 0.5 * grass_m_;
    return place::above_ground(terrain, at_m,
                               snow_m ? std::max(half_up_m, snow_m(at_m)) : half_up_m);
  };
  FactorMap sunlit(grid.samples, grid.square, 1.0F);
  parallel_for(of_rows.size(), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (const Placed* placed : of_rows[row]) {
      const glm::dvec2 between_m = placed->between_m(sunlit.place_m(0, j).y);
      const glm::ivec2 columns =
          samples_between(between_m[0], between_m[1], grid.square.corner_m.x, grid);
      for (int i = columns[0]; i <= columns[1]; ++i)
        sunlit.at(i, j) *= passed(*placed, lit_m(sunlit.place_m(i, j)), grid.step_m());
    }
  });
  return sunlit;
}

float ShrubShade::passed(const Placed& placed, const glm::dvec3& at_m, double step_m) const {
  const glm::dvec3 start_m(placed.cell_from_world * glm::dvec4(at_m, 1.0));
  const double depth = placed.cast * placed.shrubs->optical_depth(start_m, placed.along);
  return static_cast<float>(math::exp(-shown_fraction(placed.size_m, step_m) * depth));
}

}  // namespace wold::meadow
