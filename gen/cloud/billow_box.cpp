#include "cloud/billow_box.h"

#include <algorithm>
#include <cmath>

#include "cloud/periodic_map.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

/// The points of one octave, one in each cell.
std::vector<glm::vec3> points_of(int cells, std::uint64_t key) {
  std::vector<glm::vec3> points;
  const auto number = static_cast<std::uint64_t>(cells) * cells * cells;
  const auto part = [&](std::uint64_t cell, const char* axis) {
    return static_cast<float>(random_uniform({key, key_of("billow"), cell, key_of(axis)}));
  };
  for (std::uint64_t cell = 0; cell < number; ++cell)
    points.emplace_back(part(cell, "x"), part(cell, "y"), part(cell, "z"));
  return points;
}

/// Squared distance, in cells, from a place to the nearest point.
float nearest2(const std::vector<glm::vec3>& points, int cells, const glm::vec3& place) {
  const glm::ivec3 low(glm::floor(place));
  float nearest = 8.0F;
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const glm::ivec3 cell = low + glm::ivec3(i, j, k);
        const int number =
            (wrapped_index(cell.z, cells) * cells + wrapped_index(cell.y, cells)) * cells +
            wrapped_index(cell.x, cells);
        const glm::vec3 away = glm::vec3(cell) + points[static_cast<std::size_t>(number)] - place;
        nearest = std::min(nearest, glm::dot(away, away));
      }
  return nearest;
}

}  // namespace

BillowBox::BillowBox(std::uint64_t key) : values_(std::size_t{side} * side * side) {
  constexpr float coarse_fraction = 0.65F;
  const std::vector<glm::vec3> coarse = points_of(billow_cells, key);
  const std::vector<glm::vec3> fine = points_of(2 * billow_cells, key ^ key_of("fine"));
  parallel_for(side, [&](std::size_t z) {
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const glm::vec3 place = (glm::vec3(x, y, z) + 0.5F) * (1.0F * billow_cells / side);
        const float billow_cell =
            coarse_fraction * (1.0F - nearest2(coarse, billow_cells, place)) +
            (1.0F - coarse_fraction) * (1.0F - nearest2(fine, 2 * billow_cells, 2.0F * place));
        values_[(z * side + static_cast<std::size_t>(y)) * side + static_cast<std::size_t>(x)] =
            std::clamp(billow_cell, 0.0F, 1.0F);
      }
  });
}

float BillowBox::at(const glm::vec3& place) const {
  const glm::vec3 voxel = (place - glm::floor(place)) * static_cast<float>(side) - 0.5F;
  const glm::ivec3 low(glm::floor(voxel));
  const glm::vec3 part = voxel - glm::vec3(low);
  const glm::vec3 weights[2] = {1.0F - part, part};
  // Of the lower and the higher voxels, which lie one outside the cube at most.
  const glm::ivec3 at[2] = {
      glm::mix(low, glm::ivec3(side - 1), glm::lessThan(low, glm::ivec3(0))),
      glm::mix(low + 1, glm::ivec3(0), glm::equal(low + 1, glm::ivec3(side)))};
  float sum = 0.0F;
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 2; ++y) {
      const float* row = &values_[static_cast<std::size_t>((at[z].z * side + at[y].y) * side)];
      for (int x = 0; x < 2; ++x) sum += weights[x].x * weights[y].y * weights[z].z * row[at[x].x];
    }
  return sum;
}

}  // namespace wold::cloud
