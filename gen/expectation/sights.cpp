#include "expectation/sights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/parallel.h"
#include "expectation/blades_appearance.h"
#include "landscape/tiled_volume.h"

namespace wold::expectation {
namespace {

constexpr int nothing = -1;

glm::dvec3 ground_place_m(const landscape::Landscape& landscape, const Sight& sight) {
  return landscape.camera.eye_m + sight.bare.distance_m * sight.direction;
}

/// The lines of sight that meet the ground, by the patch-sized square in which they do.
class GroundPlaces {
 public:
  GroundPlaces(const landscape::Landscape& landscape, const std::vector<Sight>& sights)
      : side_m_(landscape.patch_m) {
    for (std::size_t i = 0; i < sights.size(); ++i) {
      if (!sights[i].meets_ground) continue;
      const glm::dvec2 at_m(ground_place_m(landscape, sights[i]));
      by_square_[square_of(at_m)].push_back({i, at_m});
    }
  }

  /// visit(number of the line of sight) for those that meet the ground in a rectangle.
  template <class Visit>
  void each_within(const glm::dvec2& low_m, const glm::dvec2& high_m, const Visit& visit) const {
    const double within_m = 1e-6 * side_m_;  // borders do not count for the next square
    const auto [west, south] = square_of(low_m + within_m);
    const auto [east, north] = square_of(high_m - within_m);
    for (int j = south; j <= north; ++j)
      for (int i = west; i <= east; ++i) {
        const auto square = by_square_.find({i, j});
        if (square == by_square_.end()) continue;
        for (const auto& [number, at_m] : square->second)
          if (glm::all(glm::greaterThanEqual(at_m, low_m)) && glm::all(glm::lessThan(at_m, high_m)))
            visit(number);
      }
  }

 private:
  struct Place {
    std::size_t number;
    glm::dvec2 at_m;
  };

  std::pair<int, int> square_of(const glm::dvec2& at_m) const {
    return {static_cast<int>(std::floor(at_m.x / side_m_)),
            static_cast<int>(std::floor(at_m.y / side_m_))};
  }

  double side_m_;
  std::map<std::pair<int, int>, std::vector<Place>> by_square_;
};

/// The number of the cell, or of the part of one, that stands where each line of sight meets the
/// ground; `nothing` where none does.
template <class Instance>
std::vector<int> cells_met(const landscape::Landscape& landscape,
                           const std::vector<Instance>& cells, const std::vector<Sight>& sights) {
  std::vector<int> met(sights.size(), nothing);
  if (cells.empty()) return met;
  const GroundPlaces places(landscape, sights);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto corner_m = [&](const glm::dvec2& fraction) {
      return glm::dvec2(cells[i].world_from_cell *
                        glm::dvec4(fraction * landscape.patch_m, 0.0, 1.0));
    };
    const glm::dvec2 one_m = corner_m(cells[i].part.low);
    const glm::dvec2 other_m = corner_m(cells[i].part.high);
    places.each_within(glm::min(one_m, other_m), glm::max(one_m, other_m),
                       [&](std::size_t sight) { met[sight] = static_cast<int>(i); });
  }
  return met;
}

/// A line of sight in cell space, from the top of what stands there, or the eye, to the ground.
landscape::PatchRay ray_into(const glm::dmat4& world_from_cell,
                             const landscape::Landscape& landscape, const Sight& sight) {
  constexpr double flattest = 0.03;  // it still goes down
  const glm::dmat4 cell_from_world = glm::inverse(world_from_cell);
  const glm::dvec3 way = glm::dmat3(cell_from_world) * sight.direction;
  const double stretch = glm::length(way);
  const auto height_m = [&](const glm::dvec3& at_m) {
    return (cell_from_world * glm::dvec4(at_m, 1.0)).z;
  };
  landscape::PatchRay ray;
  ray.direction = glm::normalize(glm::dvec3(way.x, way.y, std::min(way.z, -flattest * stretch)));
  ray.floor_m = std::max(0.0, height_m(ground_place_m(landscape, sight)));
  ray.top_m = height_m(landscape.camera.eye_m);
  ray.thickness = 1.0 / stretch;
  return ray;
}

/// The light there on what glows by itself.
glm::dvec3 light_at(const landscape::Landscape& landscape, const glm::dvec3& at_m) {
  return glm::dvec3(landscape.light.sample(at_m.x, at_m.y));
}

/// Points that fill the unit cube evenly, however many are taken (Roberts 2018).
glm::dvec3 spread(std::size_t number) {
  return glm::fract(glm::dvec3(0.8191725133961645, 0.6710436067037893, 0.5497004779019703) *
                    (static_cast<double>(number) + 1.0));
}

std::size_t voxels_of(const landscape::Volume& volume) {
  const glm::i64vec3 voxels(volume.voxels);
  return static_cast<std::size_t>(voxels.x * voxels.y * voxels.z);
}

/// Few volumes that can be read soon: the coarsest, so many that they do not have too many voxels
/// together. `used`: numbers of volumes, rising. Rising.
std::vector<int> spokesmen(const landscape::Landscape& landscape, const std::vector<int>& used) {
  constexpr std::size_t max = 32;
  constexpr std::size_t max_voxels = 2'000'000;
  const auto voxels = [&](int volume) {
    return voxels_of(landscape.volumes[static_cast<std::size_t>(volume)]);
  };
  std::vector<int> chosen = used;
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](int a, int b) { return voxels(a) < voxels(b); });
  std::size_t count = 0;
  for (std::size_t sum = 0; count < std::min(chosen.size(), max); ++count) {
    sum += voxels(chosen[count]);
    if (count > 0 && sum > max_voxels) break;
  }
  chosen.resize(count);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// Volumes are in order of what they are made from, so that the nearest is the most alike.
int nearest(const std::vector<int>& rising, int number) {
  return *std::min_element(rising.begin(), rising.end(), [&](int a, int b) {
    return std::abs(a - number) < std::abs(b - number);
  });
}

/// The lines of sight by the volume that speaks for what they meet.
std::map<int, std::vector<std::size_t>> by_volume(const landscape::Landscape& landscape,
                                                  const std::vector<int>& met) {
  std::map<int, std::vector<std::size_t>> sights;
  for (std::size_t i = 0; i < met.size(); ++i)
    if (met[i] != nothing)
      sights[landscape.cells[static_cast<std::size_t>(met[i])].volume].push_back(i);
  std::vector<int> used;
  for (const auto& [volume, numbers] : sights) used.push_back(volume);
  std::map<int, std::vector<std::size_t>> grouped;
  if (used.empty()) return grouped;
  const std::vector<int> chosen = spokesmen(landscape, used);
  for (const auto& [volume, numbers] : sights) {
    std::vector<std::size_t>& group = grouped[nearest(chosen, volume)];
    group.insert(group.end(), numbers.begin(), numbers.end());
  }
  return grouped;
}

BladesAppearance look_of(const landscape::Landscape& landscape, const landscape::BladeCell& cell) {
  const glm::dvec2 side_m = (cell.part.high - cell.part.low) * landscape.patch_m;
  return {*landscape.blade_meshes[static_cast<std::size_t>(cell.mesh)].tubes, side_m.x * side_m.y};
}

}  // namespace

std::size_t look_at_grass(const landscape::Landscape& landscape, std::vector<Sight>& sights) {
  const std::vector<int> met = cells_met(landscape, landscape.cells, sights);
  for (const auto& [number, group] : by_volume(landscape, met)) {
    const landscape::TiledVolume volume(landscape.volumes[static_cast<std::size_t>(number)]);
    const std::vector<std::size_t>& seen = group;
    parallel_for(seen.size(), [&](std::size_t i) {
      Sight& sight = sights[seen[i]];
      const landscape::Cell& cell = landscape.cells[static_cast<std::size_t>(met[seen[i]])];
      const glm::dvec3 at_m = ground_place_m(landscape, sight);
      landscape::PatchRay ray = ray_into(cell.world_from_cell, landscape, sight);
      ray.thickness *= double{landscape.extinction_factor.sample(at_m.x, at_m.y)};
      const glm::dvec3 anywhere = spread(seen[i]);  // as a whole meadow looks, not this place
      ray.start = glm::dvec2(anywhere);
      ray.begin = anywhere.z;
      sight.grass = volume.trace(ray);
      sight.grass->radiance *= light_at(landscape, at_m);
    });
  }
  std::set<int> cells(met.begin(), met.end());
  cells.erase(nothing);
  return cells.size();
}

void look_at_blades(const landscape::Landscape& landscape, std::vector<Sight>& sights) {
  const std::vector<int> met = cells_met(landscape, landscape.blade_cells, sights);
  std::map<int, BladesAppearance> looks;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (met[i] == nothing) continue;
    const landscape::BladeCell& cell = landscape.blade_cells[static_cast<std::size_t>(met[i])];
    if (!looks.contains(cell.mesh)) looks.emplace(cell.mesh, look_of(landscape, cell));
    const landscape::PatchRay ray = ray_into(cell.world_from_cell, landscape, sights[i]);
    sights[i].blades = looks.at(cell.mesh).trace(ray);
    sights[i].blades->radiance *= light_at(landscape, ground_place_m(landscape, sights[i]));
  }
}

}  // namespace wold::expectation
