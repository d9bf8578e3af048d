#include "passes/standing_grass.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/vdb_dense.h"

namespace wold::passes {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double nothing_left = 7.0;  ///< optical depth, of which a thousandth comes through

/// Narrows a part of a ray's way, given the distances at which it passes two planes.
void clip(double a_m, double b_m, double& from_m, double& to_m) {
  from_m = std::max(from_m, std::min(a_m, b_m));
  to_m = std::min(to_m, std::max(a_m, b_m));
}

/// The same for planes at `low` and `high` of an axis.
void clip(double low, double high, double start, double along, double& from_m, double& to_m) {
  if (along == 0.0) {
    if (start < low || start > high) to_m = -infinite;
    return;
  }
  clip((low - start) / along, (high - start) / along, from_m, to_m);
}

/// The same for the sides of a footprint.
void clip(const landscape::Footprint& footprint, const glm::dvec3& eye_m,
          const glm::dvec3& direction, double& from_m, double& to_m) {
  const glm::dvec2 start_m = footprint.unsheared(glm::dvec2(eye_m));
  const glm::dvec2 along = footprint.unsheared(glm::dvec2(direction));
  for (int axis = 0; axis < 2; ++axis)
    clip(footprint.low_m()[axis], footprint.high_m()[axis], start_m[axis], along[axis], from_m,
         to_m);
}

/// Goes along a ray from voxel to voxel ([Amanatides1987]) of a volume that repeats itself
/// along x and y.
class VoxelWalk {
 public:
  /// The ray is at start + m * along after m metres, in voxels; it begins at `from_m`.
  VoxelWalk(const glm::ivec3& voxels, const glm::dvec3& start, const glm::dvec3& along,
            double from_m)
      : voxels_(voxels) {
    for (int axis = 0; axis < 3; ++axis) {
      const double place = start[axis] + from_m * along[axis];
      double low = std::floor(place);
      if (axis == 2) low = std::clamp(low, 0.0, voxels.z - 1.0);
      at_[axis] = wrapped(static_cast<int>(low), voxels[axis]);
      step_[axis] = along[axis] < 0.0 ? -1 : 1;
      each_m_[axis] = along[axis] == 0.0 ? infinite : std::abs(1.0 / along[axis]);
      const double border = low + (step_[axis] > 0 ? 1.0 : 0.0);
      next_m_[axis] =
          along[axis] == 0.0 ? infinite : std::max(from_m, (border - start[axis]) / along[axis]);
    }
  }

  std::size_t voxel() const {
    const glm::i64vec3 at(at_), count(voxels_);
    return static_cast<std::size_t>((at.z * count.y + at.y) * count.x + at.x);
  }
  double leaves_m() const { return next_m_[axis()]; }
  void go_on() {
    const int along = axis();
    next_m_[along] += each_m_[along];
    at_[along] += step_[along];
    // Beyond the top and the bottom nothing is asked for.
    at_[along] =
        along == 2 ? std::clamp(at_.z, 0, voxels_.z - 1) : wrapped(at_[along], voxels_[along]);
  }

 private:
  static int wrapped(int i, int count) { return (i % count + count) % count; }
  int axis() const {
    const int flat = next_m_.x < next_m_.y ? 0 : 1;
    return next_m_[flat] < next_m_.z ? flat : 2;
  }

  glm::ivec3 voxels_, at_{0}, step_{1};
  glm::dvec3 each_m_{0.0}, next_m_{0.0};  ///< metres along the ray, by axis
};

/// A stand that a ray meets, by its number; from where to where.
struct Met {
  double first_m, last_m;
  std::size_t stand;
};

/// Whether some share a place; `met` rises by where they begin.
bool overlap(std::span<const Met> met) {
  constexpr double rounding_m = 1e-6;
  return std::ranges::adjacent_find(met, [](const Met& one, const Met& next) {
           return next.first_m < one.last_m - rounding_m;
         }) != met.end();
}

/// Makes one veil of those from `first` on that are of the same cell, where the first of them is.
void unite_veils(std::ptrdiff_t first, std::vector<Veil>& veils) {
  auto end = veils.begin() + first;
  for (auto veil = end; veil != veils.end(); ++veil) {
    const auto same = std::find_if(veils.begin() + first, end,
                                   [&](const Veil& other) { return other.cell == veil->cell; });
    if (same == end)
      *end++ = *veil;
    else
      same->opacity += veil->opacity;
  }
  veils.erase(end, veils.end());
}

}  // namespace

/// A ray and how much has been hidden along it.
struct StandingGrass::Way {
  glm::dvec3 eye_m;
  glm::dvec3 direction;
  double depth = 0.0;
};

StandingGrass::StandingGrass(const landscape::Landscape& landscape) : landscape_(landscape) {
  if (landscape.cells.empty()) return;
  add_volumes();
  add_stands();
  lay_out();
}

/// Volumes that differ in their light alone share a density.
void StandingGrass::add_volumes() {
  std::map<std::filesystem::path, std::size_t> known;
  std::vector<const landscape::Volume*> read;
  for (const landscape::Volume& volume : landscape_.volumes) {
    const auto [entry, is_new] = known.try_emplace(volume.vdb, read.size());
    if (is_new) read.push_back(&volume);
    density_of_volume_.push_back(entry->second);
  }
  densities_.resize(read.size());
  parallel_for(read.size(), [&](std::size_t i) {
    densities_[i] = {read[i]->voxels, read[i]->voxel_m,
                     read_dense_floats(read[i]->vdb, "density", glm::ivec3(1), read[i]->voxels)};
  });
}

void StandingGrass::add_stands() {
  for (std::size_t i = 0; i < landscape_.cells.size(); ++i) {
    const landscape::Cell& cell = landscape_.cells[i];
    const landscape::Volume& volume = landscape_.volumes[static_cast<std::size_t>(cell.volume)];
    const auto number = static_cast<int>(i);
    stands_.push_back({number,
                       glm::inverse(cell.world_from_cell),
                       {cell.world_from_cell, cell.part, landscape_.patch_m},
                       volume.voxels.z * volume.voxel_m,
                       density_of_volume_[static_cast<std::size_t>(cell.volume)]});
    stands_.back().footprint.each_square(landscape_.patch_m, [&](const glm::ivec2& square) {
      on_squares_.push_back({square, number});
    });
  }
}

/// Sorts what stands into the squares of a grid.
void StandingGrass::lay_out() {
  glm::ivec2 last = first_square_ = on_squares_.front().square;
  for (const OnSquare& one : on_squares_) {
    first_square_ = glm::min(first_square_, one.square);
    last = glm::max(last, one.square);
  }
  squares_ = last - first_square_ + 1;
  grid_.resize(static_cast<std::size_t>(squares_.x) * static_cast<std::size_t>(squares_.y));
  const auto number = [&](const OnSquare& one) {
    const glm::ivec2 at = one.square - first_square_;
    return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(squares_.x) +
           static_cast<std::size_t>(at.x);
  };
  std::ranges::stable_sort(on_squares_, {}, number);
  for (std::size_t i = 0; i < on_squares_.size(); ++i) {
    const Stand& stand = stands_[static_cast<std::size_t>(on_squares_[i].stand)];
    Square& square = grid_[number(on_squares_[i])];
    if (square.end == 0) square = {i, i, infinite, -infinite};
    square.end = i + 1;
    // In world space the lower and the upper side of what stands over a footprint are planes.
    const glm::dmat4& from_world = stand.cell_from_world;
    const auto [low_m, high_m] = stand.footprint.bounds_m();
    for (const double height_m : {0.0, stand.height_m})
      for (const double x_m : {low_m.x, high_m.x})
        for (const double y_m : {low_m.y, high_m.y}) {
          const double above = (from_world * glm::dvec4(x_m, y_m, 0.0, 1.0)).z;
          const double z_m = (height_m - above) / from_world[2].z;
          square.low_m = std::min(square.low_m, z_m);
          square.high_m = std::max(square.high_m, z_m);
        }
  }
}

void StandingGrass::look(const glm::dvec3& eye_m, const glm::dvec3& direction, double end_m,
                         GrassSight& sight) const {
  sight.veils.clear();
  sight.half_m = infinite;
  sight.optical_depth = 0.0;
  if (grid_.empty()) return;
  double from_m = 0.0, to_m = end_m;
  const double side_m = landscape_.patch_m;
  for (int axis = 0; axis < 2; ++axis)
    clip(first_square_[axis] * side_m, (first_square_[axis] + squares_[axis]) * side_m, eye_m[axis],
         direction[axis], from_m, to_m);
  if (!(from_m < to_m)) return;
  Way way{eye_m, direction};
  const glm::dvec2 start = glm::dvec2(eye_m + from_m * direction) / side_m;
  glm::ivec2 at =
      glm::clamp(glm::ivec2(glm::floor(start)) - first_square_, glm::ivec2(0), squares_ - 1);
  const glm::ivec2 step(direction.x < 0.0 ? -1 : 1, direction.y < 0.0 ? -1 : 1);
  const auto border_m = [&](int axis) {
    if (direction[axis] == 0.0) return infinite;
    const int line = first_square_[axis] + at[axis] + (step[axis] > 0 ? 1 : 0);
    return (line * side_m - eye_m[axis]) / direction[axis];
  };
  for (bool goes_on = true; goes_on && from_m < to_m;) {
    const glm::dvec2 next_m(border_m(0), border_m(1));
    const int axis = next_m.x < next_m.y ? 0 : 1;
    const double until_m = std::clamp(next_m[axis], from_m, to_m);
    const Square& square =
        grid_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(squares_.x) +
              static_cast<std::size_t>(at.x)];
    goes_on = cross_square(square, way, from_m, until_m, sight);
    from_m = until_m;
    at[axis] += step[axis];
    if (at[axis] < 0 || at[axis] >= squares_[axis]) break;
  }
  sight.optical_depth = way.depth;
}

bool StandingGrass::cross_square(const Square& square, Way& way, double from_m, double to_m,
                                 GrassSight& sight) const {
  if (square.first == square.end) return true;
  clip(square.low_m, square.high_m, way.eye_m.z, way.direction.z, from_m, to_m);
  if (!(from_m < to_m)) return true;
  // The nearest first. A cell has 64 parts at most; six cells and shrubs of nine reach into it.
  std::array<Met, 15 * 64> all_met;
  std::size_t count = 0;
  for (std::size_t i = square.first; i < square.end && count < all_met.size(); ++i) {
    const auto stand = static_cast<std::size_t>(on_squares_[i].stand);
    double first_m = from_m, last_m = to_m;
    clip(stands_[stand].footprint, way.eye_m, way.direction, first_m, last_m);
    if (first_m < last_m) all_met[count++] = {first_m, last_m, stand};
  }
  const std::span met(all_met.data(), count);
  std::ranges::sort(met, std::less(),
                    [](const Met& one) { return std::pair(one.first_m, one.stand); });
  const auto cross_all = [&](double first_m, double last_m) {
    return std::ranges::all_of(met, [&](const Met& one) {
      return cross(stands_[one.stand], way, first_m, last_m, sight);
    });
  };
  if (!overlap(met)) return cross_all(from_m, to_m);
  // What stands in one place is crossed together, slice by slice.
  const auto first = static_cast<std::size_t>(on_squares_[square.first].stand);
  const double slice_m = densities_[stands_[first].density].voxel_m;
  const auto slices = static_cast<int>(std::ceil((to_m - from_m) / slice_m));
  const auto first_veil = static_cast<std::ptrdiff_t>(sight.veils.size());
  bool goes_on = true;
  for (int slice = 0; slice < slices && goes_on; ++slice)
    goes_on = cross_all(std::lerp(from_m, to_m, 1.0 * slice / slices),
                        std::lerp(from_m, to_m, (slice + 1.0) / slices));
  unite_veils(first_veil, sight.veils);
  return goes_on;
}

bool StandingGrass::cross(const Stand& stand, Way& way, double from_m, double to_m,
                          GrassSight& sight) const {
  clip(stand.footprint, way.eye_m, way.direction, from_m, to_m);
  const glm::dvec3 start_m = glm::dvec3(stand.cell_from_world * glm::dvec4(way.eye_m, 1.0));
  const glm::dvec3 along = glm::dmat3(stand.cell_from_world) * way.direction;
  clip(0.0, stand.height_m, start_m.z, along.z, from_m, to_m);
  if (!(from_m < to_m)) return true;

  const Density& density = densities_[stand.density];
  const glm::dvec2 middle_m =
      glm::dvec2(way.eye_m) + 0.5 * (from_m + to_m) * glm::dvec2(way.direction);
  const double factor{landscape_.extinction_factor.sample(middle_m.x, middle_m.y)};
  const double before = way.depth;
  VoxelWalk walk(density.voxels, start_m / density.voxel_m, along / density.voxel_m, from_m);
  while (from_m < to_m && way.depth < nothing_left) {
    const double until_m = std::min(walk.leaves_m(), to_m);
    const double extinction_per_m = factor * double{density.extinction_per_m[walk.voxel()]};
    const double depth = way.depth + extinction_per_m * (until_m - from_m);
    if (sight.half_m == infinite && depth >= std::numbers::ln2) {
      sight.half_m = from_m + (std::numbers::ln2 - way.depth) / extinction_per_m;
      sight.half_cell = stand.cell;
    }
    way.depth = depth;
    from_m = until_m;
    walk.go_on();
  }
  if (way.depth > before)
    sight.veils.push_back({stand.cell, math::exp(-before) - math::exp(-way.depth)});
  return way.depth < nothing_left;
}

}  // namespace wold::passes
