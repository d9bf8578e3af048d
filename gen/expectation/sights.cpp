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

/// Which cell, or part of one, stands where.
template <class Instance>
class CellFinder {
 public:
  CellFinder(const std::vector<Instance>& cells, double side_m) : side_m_(side_m) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto corner_m = [&](const glm::dvec2& fraction) {
        return glm::dvec2(cells[i].world_from_cell * glm::dvec4(fraction * side_m, 0.0, 1.0));
      };
      const glm::dvec2 one_m = corner_m(cells[i].part.low), other_m = corner_m(cells[i].part.high);
      add({{}, glm::min(one_m, other_m), glm::max(one_m, other_m), static_cast<int>(i)});
    }
    std::ranges::sort(places_, {}, &Place::square);
  }

  /// Its number; `nothing` where none stands.
  int at(const glm::dvec2& at_m) const {
    for (const Place& place :
         std::ranges::equal_range(places_, square_of(at_m), {}, &Place::square))
      if (glm::all(glm::greaterThanEqual(at_m, place.low_m)) &&
          glm::all(glm::lessThan(at_m, place.high_m)))
        return place.cell;
    return nothing;
  }

 private:
  using Square = std::pair<int, int>;  ///< as large as a patch
  struct Place {
    Square square;
    glm::dvec2 low_m, high_m;
    int cell;
  };

  Square square_of(const glm::dvec2& at_m) const {
    return {static_cast<int>(std::floor(at_m.x / side_m_)),
            static_cast<int>(std::floor(at_m.y / side_m_))};
  }

  /// To each square that it reaches into.
  void add(Place place) {
    const double within_m = 1e-6 * side_m_;  // borders do not count for the next square
    const auto [west, south] = square_of(place.low_m + within_m);
    const auto [east, north] = square_of(place.high_m - within_m);
    for (int j = south; j <= north; ++j)
      for (int i = west; i <= east; ++i) {
        place.square = {i, j};
        places_.push_back(place);
      }
  }

  double side_m_;
  std::vector<Place> places_;
};

/// What a line of sight goes through on the way down to the ground: a piece of it above one cell.
struct Passage {
  int cell = nothing;
  glm::dvec2 at_m{0.0};
  landscape::PatchRay ray;  ///< in cell space
};

/// A piece of a line of sight in cell space, from one of its ends to the other, metres.
landscape::PatchRay ray_through(const glm::dmat4& world_from_cell, const glm::dvec3& from_m,
                                const glm::dvec3& to_m) {
  constexpr double flattest = 0.03;  // it still goes down
  const glm::dmat4 cell_from_world = glm::inverse(world_from_cell);
  const glm::dvec3 from(cell_from_world * glm::dvec4(from_m, 1.0));
  const glm::dvec3 to(cell_from_world * glm::dvec4(to_m, 1.0));
  const double length = glm::length(to - from);
  const double drop = std::max(std::abs(to.z - from.z), flattest * length);
  landscape::PatchRay ray;
  ray.direction = glm::normalize(glm::dvec3(to.x - from.x, to.y - from.y, -drop));
  ray.top_m = std::max(from.z, to.z);
  ray.floor_m = std::max(0.0, ray.top_m - drop);
  ray.thickness = glm::distance(from_m, to_m) / length;
  return ray;
}

/// From the nearest to the farthest, the last one down to the ground. `canopy_m`: nothing stands
/// higher above it.
template <class Instance>
std::vector<Passage> passages(const landscape::Landscape& landscape,
                              const std::vector<Instance>& cells,
                              const CellFinder<Instance>& finder, double canopy_m,
                              const Sight& sight) {
  constexpr int longest = 256;  // pieces of a quarter of a patch
  std::vector<Passage> found;
  const auto place_m = [&](double distance_m) {
    return landscape.camera.eye_m + distance_m * sight.direction;
  };
  const double piece_m =
      std::min(0.25 * landscape.patch_m / std::max(glm::length(glm::dvec2(sight.direction)), 1e-9),
               canopy_m / std::max(std::abs(sight.direction.z), 1e-9));
  double end_m = sight.bare.distance_m;
  for (int i = 0; i < longest && end_m > 0.0; ++i) {
    const double begin_m = std::max(0.0, end_m - piece_m);
    const glm::dvec2 at_m(place_m(0.5 * (begin_m + end_m)));
    if (const int cell = finder.at(at_m); cell != nothing)
      found.push_back({cell, at_m,
                       ray_through(cells[static_cast<std::size_t>(cell)].world_from_cell,
                                   place_m(begin_m), place_m(end_m))});
    end_m = begin_m;
    const glm::dvec3 top_m = place_m(begin_m);
    if (top_m.z - double{landscape.terrain.sample(top_m.x, top_m.y)} > canopy_m) break;
  }
  std::ranges::reverse(found);
  return found;
}

/// The passages of each line of sight.
using Ways = std::vector<std::vector<Passage>>;

template <class Instance>
Ways ways_through(const landscape::Landscape& landscape, const std::vector<Instance>& cells,
                  double canopy_m, const std::vector<Sight>& sights) {
  Ways ways(sights.size());
  if (cells.empty()) return ways;
  const CellFinder finder(cells, landscape.patch_m);
  parallel_for(sights.size(), [&](std::size_t i) {
    if (sights[i].meets_ground) ways[i] = passages(landscape, cells, finder, canopy_m, sights[i]);
  });
  return ways;
}

std::set<int> cells_of(const Ways& ways) {
  std::set<int> cells;
  for (const std::vector<Passage>& way : ways)
    for (const Passage& passage : way) cells.insert(passage.cell);
  return cells;
}

/// The light there on what glows by itself.
glm::dvec3 light_at(const landscape::Landscape& landscape, const glm::dvec2& at_m) {
  return glm::dvec3(landscape.light.sample(at_m.x, at_m.y));
}

/// What stands in the way, one thing behind the other; look(passage): how each looks in a light
/// of 1.
template <class Look>
std::optional<landscape::AggregateAppearance> seen_through(const landscape::Landscape& landscape,
                                                           const std::vector<Passage>& way,
                                                           const Look& look) {
  if (way.empty()) return {};
  landscape::AggregateAppearance seen;
  for (const Passage& passage : way) {
    const landscape::AggregateAppearance next = look(passage);
    seen.radiance += seen.transmittance * next.radiance * light_at(landscape, passage.at_m);
    seen.transmittance *= next.transmittance;
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
/// together; of those that are as coarse as the last, every so manieth, since neighbours look alike
/// and one end may be of one plant, the other of another. `used`: numbers of volumes, rising.
/// Rising.
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
  const auto alike = std::ranges::equal_range(coarsest, voxels(coarsest[count - 1]), {}, voxels);
  const auto first = static_cast<std::size_t>(alike.begin() - coarsest.begin());
  std::vector<int> chosen(coarsest.begin(), alike.begin());
  for (std::size_t i = 0; first + i < count; ++i)
    chosen.push_back(alike[(2 * i + 1) * alike.size() / (2 * (count - first))]);
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

  const landscape::TiledVolume& of(int volume) const { return volumes_.at(speaker_.at(volume)); }

 private:
  std::map<int, landscape::TiledVolume> volumes_;
  std::map<int, int> speaker_;
};

BladesAppearance look_of(const landscape::Landscape& landscape, const landscape::BladeCell& cell) {
  const glm::dvec2 side_m = (cell.part.high - cell.part.low) * landscape.patch_m;
  return {*landscape.blade_meshes[static_cast<std::size_t>(cell.mesh)].tubes, side_m.x * side_m.y};
}

}  // namespace

std::size_t look_at_grass(const landscape::Landscape& landscape, std::vector<Sight>& sights) {
  double canopy_m = 1e-3;
  for (const landscape::Volume& volume : landscape.volumes)
    canopy_m = std::max(canopy_m, volume.voxels.z * volume.voxel_m);
  const Ways ways = ways_through(landscape, landscape.cells, canopy_m, sights);
  const std::set<int> cells = cells_of(ways);
  const auto volume_of = [&](int cell) {
    return landscape.cells[static_cast<std::size_t>(cell)].volume;
  };
  std::set<int> used;
  for (const int cell : cells) used.insert(volume_of(cell));
  const Speakers speakers(landscape, used);
  parallel_for(sights.size(), [&](std::size_t i) {
    std::size_t number = i;
    sights[i].grass = seen_through(landscape, ways[i], [&](const Passage& passage) {
      landscape::PatchRay ray = passage.ray;
      ray.thickness *= double{landscape.extinction_factor.sample(passage.at_m.x, passage.at_m.y)};
      const glm::dvec3 anywhere = spread(number++);  // as a whole meadow looks, not this place
      ray.start = glm::dvec2(anywhere);
      ray.begin = anywhere.z;
      return speakers.of(volume_of(passage.cell)).trace(ray);
    });
  });
  return cells.size();
}

void look_at_blades(const landscape::Landscape& landscape, std::vector<Sight>& sights) {
  double canopy_m = 1e-3;
  for (const landscape::BladeMesh& mesh : landscape.blade_meshes)
    for (const glm::vec3& vertex_m : mesh.tubes->vertices_m)
      canopy_m = std::max(canopy_m, double{vertex_m.z});
  const Ways ways = ways_through(landscape, landscape.blade_cells, canopy_m, sights);
  const auto cell_of = [&](int number) -> const landscape::BladeCell& {
    return landscape.blade_cells[static_cast<std::size_t>(number)];
  };
  std::map<int, BladesAppearance> looks;
  for (const int number : cells_of(ways)) {
    const landscape::BladeCell& cell = cell_of(number);
    if (!looks.contains(cell.mesh)) looks.emplace(cell.mesh, look_of(landscape, cell));
  }
  for (std::size_t i = 0; i < sights.size(); ++i)
    sights[i].blades = seen_through(landscape, ways[i], [&](const Passage& passage) {
      return looks.at(cell_of(passage.cell).mesh).trace(passage.ray);
    });
}

}  // namespace wold::expectation
