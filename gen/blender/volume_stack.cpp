#include "blender/volume_stack.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "blender/shown_volumes.h"
#include "core/parallel.h"
#include "landscape/cell_parts.h"
#include "landscape/perspective.h"

namespace wold::blender {
namespace {

using landscape::Landscape;

/// A box that is turned, sheared and moved: its own coordinates from low to high.
struct Box {
  glm::dmat4 world_from_box{1.0};
  glm::dvec3 low_m{0.0};
  glm::dvec3 high_m{0.0};
};

/// What Cycles takes for the hull of what a cell shows; see ShownVolume.
Box box_of(const Landscape& landscape, const landscape::Cell& cell, const ShownVolume& shown) {
  const landscape::Volume& volume = landscape.volumes[shown.volume];
  landscape::Part part;
  if (shown.quarter)
    part = landscape::quarters_of_patch(volume.voxels.x)[static_cast<std::size_t>(*shown.quarter)];
  return {cell.world_from_cell * cell.reach,
          {part.low * landscape.patch_m, 0.0},
          {part.high * landscape.patch_m, volume.voxels.z * volume.voxel_m}};
}

std::vector<Box> boxes_of(const Landscape& landscape) {
  const ShownInstances<ShownVolume> shown = shown_volumes(landscape);
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < landscape.cells.size(); ++i)
    boxes.push_back(box_of(landscape, landscape.cells[i],
                           shown.all()[static_cast<std::size_t>(shown.picks()[i])]));
  for (const landscape::CloudBox& cloud : landscape.clouds)
    boxes.push_back({glm::dmat4(1.0), cloud.corner_m,
                     cloud.corner_m + cloud.voxel_m * glm::dvec3(cloud.voxels)});
  return boxes;
}

/// Boxes that share no more along a ray only touch.
constexpr double touching_m = 1e-6;

/// Where a ray from the eye, which is at 0, enters a box and where it leaves it.
std::optional<glm::dvec2> way_through(const Box& box, const glm::dmat4& box_from_world,
                                      const glm::dvec3& eye_m, const glm::dvec3& direction) {
  const glm::dvec3 origin(box_from_world * glm::dvec4(eye_m, 1.0));
  const glm::dvec3 along(box_from_world * glm::dvec4(direction, 0.0));
  glm::dvec2 way(0.0, std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.low_m[axis] - origin[axis]) / along[axis];
    const double b = (box.high_m[axis] - origin[axis]) / along[axis];
    // Along a side both are infinite: from one end to the other if it is inside, else nowhere.
    way = {std::max(way[0], std::min(a, b)), std::min(way[1], std::max(a, b))};
  }
  way[1] -= touching_m;
  if (!(way[0] < way[1])) return std::nullopt;
  return way;
}

/// Rays through a picture of the landscape's shape, row by row, and what they meet.
class Rays {
 public:
  explicit Rays(const Landscape& landscape)
      : size_(columns, std::max(1, columns * landscape.height_px / landscape.width_px)),
        perspective_(landscape.camera, size_),
        steps_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y)) {}

  void meet(const Box& box) {
    const glm::dmat4 box_from_world = glm::inverse(box.world_from_box);
    const auto [first, last] = pixels_of(box);
    for (int row = first.y; row <= last.y; ++row)
      for (int column = first.x; column <= last.x; ++column) {
        const glm::dvec3 direction = perspective_.direction(glm::dvec2(column, row) + 0.5);
        const auto way = way_through(box, box_from_world, perspective_.eye_m(), direction);
        if (!way) continue;
        auto& steps = steps_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x) +
                             static_cast<std::size_t>(column)];
        steps.push_back({(*way)[0], 1});
        steps.push_back({(*way)[1], -1});
      }
  }

  /// Boxes over one place of a ray at most. What begins where something else ends is not over it.
  int deepest() {
    std::vector<int> deepest(steps_.size(), 0);
    parallel_for_blocks(steps_.size(), [&](std::size_t ray) {
      std::ranges::sort(steps_[ray]);
      int depth = 0;
      for (const auto& [distance_m, change] : steps_[ray])
        deepest[ray] = std::max(deepest[ray], depth += change);
    });
    return std::ranges::max(deepest);
  }

 private:
  static constexpr int columns = 96;

  struct Pixels {
    glm::ivec2 first, last;
  };

  /// Those that may see it: all where part of it is beside or behind the eye.
  Pixels pixels_of(const Box& box) const {
    constexpr double nearest_m = 0.01;
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high = -low;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::bvec3 is_high((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
      const glm::dvec3 at_m(box.world_from_box *
                            glm::dvec4(glm::mix(box.low_m, box.high_m, is_high), 1.0));
      const glm::dvec3 seen = perspective_.seen(at_m);
      if (seen.z < nearest_m) return {glm::ivec2(0), size_ - 1};
      low = glm::min(low, glm::dvec2(seen));
      high = glm::max(high, glm::dvec2(seen));
    }
    const glm::dvec2 all(size_);
    return {glm::ivec2(glm::clamp(glm::floor(low), glm::dvec2(0.0), all)),
            glm::min(glm::ivec2(glm::clamp(glm::floor(high), glm::dvec2(-1.0), all)), size_ - 1)};
  }

  glm::ivec2 size_;
  landscape::Perspective perspective_;
  std::vector<std::vector<std::pair<double, int>>> steps_;
};

}  // namespace

int deepest_volume_stack(const Landscape& landscape) {
  Rays rays(landscape);
  for (const Box& box : boxes_of(landscape)) rays.meet(box);
  return rays.deepest() + (landscape.fog ? 1 : 0);
}

}  // namespace wold::blender
