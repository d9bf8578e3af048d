#include "expectation/sights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/parallel.h"
#include "expectation/blades_appearance.h"
#include "expectation/passages.h"
#include "landscape/cell_parts.h"
#include "landscape/light_on_grass.h"
#include "landscape/tiled_volume.h"

namespace wold::expectation {
namespace {

/// A piece of a line of sight in cell space, from one of its ends to the other, metres. It starts
/// as far from the cell's corner as it is there, in patches.
landscape::PatchRay ray_through(const glm::dmat4& world_from_cell, const glm::dvec3& from_m,
                                const glm::dvec3& to_m, double patch_m) {
  constexpr double flattest = 0.03;  // it still goes down
  const glm::dmat4 cell_from_world = glm::inverse(world_from_cell);
  const glm::dvec3 from(cell_from_world * glm::dvec4(from_m, 1.0));
  const glm::dvec3 to(cell_from_world * glm::dvec4(to_m, 1.0));
  const double length = glm::length(to - from);
  const double drop = std::max(std::abs(to.z - from.z), flattest * length);
  landscape::PatchRay ray;
  ray.start = glm::dvec2(from) / patch_m;
  ray.direction = glm::normalize(glm::dvec3(to.x - from.x, to.y - from.y, -drop));
  ray.top_m = std::max(from.z, to.z);
  ray.floor_m = std::max(0.0, ray.top_m - drop);
  ray.thickness = glm::distance(from_m, to_m) / length;
  return ray;
}

/// The same ray from where it comes down to `top_m`.
landscape::PatchRay from_top(landscape::PatchRay ray, double top_m, double patch_m) {
  const double above_m = std::max(0.0, ray.top_m - top_m);
  ray.start += above_m / -ray.direction.z / patch_m * glm::dvec2(ray.direction);
  ray.top_m -= above_m;
  return ray;
}

/// The light there on what glows by itself.
glm::dvec3 light_at(const landscape::Landscape& landscape, const glm::dvec2& at_m) {
  return glm::dvec3(landscape::light_on_grass(landscape, at_m));
}

/// What stands in the way, one thing behind the other; look(cell, ray, place): how each looks in a
/// light of 1.
template <class Instance, class Look>
std::optional<landscape::AggregateAppearance> seen_through(const landscape::Landscape& landscape,
                                                           const std::vector<Instance>& cells,
                                                           const Sight& sight,
                                                           const std::vector<Passage>& way,
                                                           const Look& look) {
  constexpr double opaque = 1e-3;
  if (way.empty()) return {};
  landscape::AggregateAppearance seen;
  for (const Passage& passage : way) {
    const Instance& cell = cells[static_cast<std::size_t>(passage.cell)];
    const glm::dvec3 from_m = place_m(landscape, sight, passage.begin_m);
    const glm::dvec3 to_m = place_m(landscape, sight, passage.end_m);
    const glm::dvec2 at_m(0.5 * (from_m + to_m));
    const landscape::AggregateAppearance next =
        look(cell, ray_through(cell.world_from_cell, from_m, to_m, landscape.patch_m), at_m);
    seen.radiance += seen.transmittance * next.radiance * light_at(landscape, at_m);
    seen.transmittance *= next.transmittance;
    if (seen.transmittance < opaque) break;
  }
  return seen;
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
/// together. Of those that are as coarse as the last they are evenly spread ones: neighbours look
/// alike, while one end may be of one plant, the other of another. `used`: numbers of volumes,
/// rising. Rising.
std::vector<int> spokesmen(const landscape::Landscape& landscape, const std::vector<int>& used) {
  constexpr std::size_t max = 32;
  constexpr std::size_t max_voxels = 2'000'000;
  const auto voxels = [&](int volume) {
    return voxels_of(landscape.volumes[static_cast<std::size_t>(volume)]);
  };
  std::vector<int> coarsest = used;
  std::ranges::stable_sort(coarsest, {}, voxels);
  std::size_t count = 0;
  for (std::size_t sum = 0; count < std::min(coarsest.size(), max); ++count) {
    sum += voxels(coarsest[count]);
    if (count > 0 && sum > max_voxels) break;
  }
  const std::size_t size = voxels(coarsest[count - 1]);
  std::vector<int> chosen, alike;
  for (const int volume : coarsest) {
    if (voxels(volume) < size) chosen.push_back(volume);
    if (voxels(volume) == size) alike.push_back(volume);
  }
  const std::size_t wanted = count - chosen.size();
  for (std::size_t i = 0; i < wanted; ++i)
    chosen.push_back(alike[(2 * i + 1) * alike.size() / (2 * wanted)]);
  std::ranges::sort(chosen);
  return chosen;
}

/// Volumes are in order of what they are made from, so that the nearest is the most alike.
int nearest(const std::vector<int>& rising, int number) {
  return *std::min_element(rising.begin(), rising.end(), [&](int a, int b) {
    return std::abs(a - number) < std::abs(b - number);
  });
}

/// Volumes in memory, of which one speaks for each volume that is used.
class Speakers {
 public:
  Speakers(const landscape::Landscape& landscape, const std::set<int>& used) {
    if (used.empty()) return;
    const std::vector<int> chosen = spokesmen(landscape, {used.begin(), used.end()});
    for (const int number : chosen)
      volumes_.try_emplace(number, landscape.volumes[static_cast<std::size_t>(number)]);
    for (const int number : used) speaker_.emplace(number, nearest(chosen, number));
  }

  const landscape::TiledVolume& of(int volume) const { return volumes_.at(number(volume)); }
  /// Of the one that speaks for a volume.
  int number(int volume) const { return speaker_.at(volume); }

 private:
  std::map<int, landscape::TiledVolume> volumes_;
  std::map<int, int> speaker_;
};

/// How many patch-sized squares of the ground the farthest passages lie in.
std::size_t patches_met(const landscape::Landscape& landscape, const std::vector<Sight>& sights,
                        const Ways& ways) {
  std::set<std::pair<int, int>> squares;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (ways[i].empty()) continue;
    const Passage& last = ways[i].back();
    const glm::dvec3 at_m = place_m(landscape, sights[i], 0.5 * (last.begin_m + last.end_m));
    squares.emplace(static_cast<int>(std::floor(at_m.x / landscape.patch_m)),
                    static_cast<int>(std::floor(at_m.y / landscape.patch_m)));
  }
  return squares.size();
}

/// The fraction of all passages through volumes for which one of the same patch speaks.
double own_fraction(const landscape::Landscape& landscape, const Ways& ways,
                    const Speakers& speakers) {
  std::map<int, int> patch_of_volume;
  for (const landscape::Cell& cell : landscape.cells)
    patch_of_volume.try_emplace(cell.volume, cell.origin.patch);
  std::size_t all = 0, own = 0;
  for (const std::vector<Passage>& way : ways)
    for (const Passage& passage : way) {
      const int volume = landscape.cells[static_cast<std::size_t>(passage.cell)].volume;
      ++all;
      own += patch_of_volume.at(volume) == patch_of_volume.at(speakers.number(volume)) ? 1 : 0;
    }
  return all == 0 ? 1.0 : static_cast<double>(own) / static_cast<double>(all);
}

BladesAppearance look_of(const landscape::Landscape& landscape, const landscape::BladeCell& cell) {
  const glm::dvec2 side_m = (cell.part.high - cell.part.low) * landscape.patch_m;
  return {*landscape.blade_meshes[static_cast<std::size_t>(cell.mesh)].tubes, side_m.x * side_m.y};
}

/// The largest size of a cell over its patch's own.
template <class Instance>
double largest_size(const std::vector<Instance>& cells) {
  double largest = 1.0;
  for (const Instance& cell : cells)
    largest = std::max(largest, landscape::size_of(cell.world_from_cell));
  return largest;
}

}  // namespace

GrassKnowledge look_at_grass(const landscape::Landscape& landscape, std::vector<Sight>& sights) {
  double canopy_m = 1e-3;
  const auto height_m = [](const landscape::Volume& volume) {
    return volume.voxels.z * volume.voxel_m;
  };
  for (const landscape::Volume& volume : landscape.volumes)
    canopy_m = std::max(canopy_m, height_m(volume));
  canopy_m *= largest_size(landscape.cells);
  const Ways ways = ways_through(landscape, landscape.cells, canopy_m, sights);
  std::set<int> used;
  for (const int cell : cells_met(landscape.cells, ways))
    used.insert(landscape.cells[static_cast<std::size_t>(cell)].volume);
  const Speakers speakers(landscape, used);
  parallel_for(sights.size(), [&](std::size_t i) {
    const glm::dvec3 anywhere = spread(i);  // as a whole meadow looks, not this place
    const auto look = [&](const landscape::Cell& cell, const landscape::PatchRay& piece,
                          const glm::dvec2& at_m) {
      const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
      landscape::PatchRay ray = from_top(piece, height_m(volume), landscape.patch_m);
      ray.thickness *= double{landscape.extinction_factor.sample(at_m.x, at_m.y)};
      ray.start = glm::fract(ray.start + glm::dvec2(anywhere));
      ray.begin = anywhere.z;
      return speakers.of(cell.volume).trace(ray);
    };
    sights[i].grass = seen_through(landscape, landscape.cells, sights[i], ways[i], look);
  });
  return {patches_met(landscape, sights, ways), own_fraction(landscape, ways, speakers)};
}

void look_at_blades(const landscape::Landscape& landscape, std::vector<Sight>& sights) {
  double canopy_m = 1e-3;
  for (const landscape::BladeMesh& mesh : landscape.blade_meshes)
    for (const glm::vec3& vertex_m : mesh.tubes->vertices_m)
      canopy_m = std::max(canopy_m, double{vertex_m.z});
  canopy_m *= largest_size(landscape.blade_cells);
  const Ways ways = ways_through(landscape, landscape.blade_cells, canopy_m, sights);
  std::map<int, BladesAppearance> looks;
  for (const int number : cells_met(landscape.blade_cells, ways)) {
    const landscape::BladeCell& cell = landscape.blade_cells[static_cast<std::size_t>(number)];
    if (!looks.contains(cell.mesh)) looks.emplace(cell.mesh, look_of(landscape, cell));
  }
  parallel_for(sights.size(), [&](std::size_t i) {
    const auto look = [&](const landscape::BladeCell& cell, const landscape::PatchRay& ray,
                          const glm::dvec2&) { return looks.at(cell.mesh).trace(ray); };
    sights[i].blades = seen_through(landscape, landscape.blade_cells, sights[i], ways[i], look);
  });
}

}  // namespace wold::expectation
