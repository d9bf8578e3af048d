#include "cloud/tiling.h"

#include <algorithm>
#include <cmath>

#include "cloud/ranks.h"
#include "cloud/texture_noise.h"
#include "core/elementary.h"
#include "core/normal_distribution.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

/// Patches across a cell: enough that no texture is seen whole twice, few enough that clouds are.
constexpr double vertices_per_cell = 2.0;

std::uint16_t stored(double rank) {
  return static_cast<std::uint16_t>(std::clamp(rank * 65536.0, 0.0, 65535.0));
}

/// body(place in cells) -> rank, for every pixel.
template <class Rank>
LayerMap each_pixel(const glm::ivec2& cells, const glm::ivec2& size_px, const Rank& rank) {
  LayerMap map(size_px.x, size_px.y);
  parallel_for(static_cast<std::size_t>(size_px.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < size_px.x; ++x)
      map.at(x, y) = stored(
          rank(glm::dvec2((x + 0.5) * cells.x / size_px.x, (y + 0.5) * cells.y / size_px.y)));
  });
  return map;
}

std::uint64_t number_of(const glm::ivec2& place) {
  return static_cast<std::uint64_t>(place.x) << 32 | static_cast<std::uint32_t>(place.y);
}

std::uint32_t texture_at(const glm::ivec2& place, std::size_t textures, std::uint64_t key) {
  return random_below({key, key_of("cell"), number_of(place), key_of("texture")},
                      static_cast<std::uint32_t>(textures));
}

/// What the patch about a vertex shows: which texture, and from where in it.
struct Sample {
  std::uint32_t texture = 0;
  glm::dvec2 shift = {};
};

Sample sample_at(const glm::ivec2& vertex, std::size_t textures, std::uint64_t key) {
  const std::uint64_t number = number_of(vertex);
  return {texture_at(vertex, textures, key),
          {random_uniform({key, key_of("patch"), number, key_of("x")}),
           random_uniform({key, key_of("patch"), number, key_of("y")})}};
}

/// Of all vertices of a period, row after row.
std::vector<Sample> all_samples(const glm::ivec2& vertices, std::size_t textures,
                                std::uint64_t key) {
  std::vector<Sample> samples;
  for (int y = 0; y < vertices.y; ++y)
    for (int x = 0; x < vertices.x; ++x) samples.push_back(sample_at({x, y}, textures, key));
  return samples;
}

std::vector<PeriodicMap<float>> gaussianised(const std::vector<PeriodicMap<float>>& ranks) {
  std::vector<PeriodicMap<float>> result = ranks;
  for (PeriodicMap<float>& map : result)
    for (float& value : map.values()) value = static_cast<float>(normal_quantile(value));
  return result;
}

/// Noise over the whole layer, normally distributed with the patches' weight as its deviation.
PeriodicMap<float> patches_of(const Patches& patches, const glm::ivec2& cells, std::uint64_t key) {
  constexpr int px_per_cell = 16, octaves = 3;
  const glm::ivec2 features =
      glm::max(glm::ivec2(glm::round(glm::dvec2(cells) / patches.cells)), glm::ivec2(1));
  PeriodicMap<float> noise(px_per_cell * cells.x, px_per_cell * cells.y);
  for (int y = 0; y < noise.height(); ++y)
    for (int x = 0; x < noise.width(); ++x) {
      const glm::dvec2 place((x + 0.5) / noise.width(), (y + 0.5) / noise.height());
      double sum = 0.0;
      for (int octave = 0; octave < octaves; ++octave)
        sum += math::exp2(-1.0 * octave) *
               perlin(place * glm::dvec2(features << octave),
                      random_bits({key, static_cast<std::uint64_t>(octave)}), features << octave);
      noise.at(x, y) = static_cast<float>(sum);
    }
  noise = gaussianised(ranked({noise})).front();
  for (float& value : noise.values()) value *= static_cast<float>(patches.weight);
  return noise;
}

double cubed(double x) { return x * x * x; }

}  // namespace

TriangleGrid::TriangleGrid(const glm::ivec2& cells) {
  // Rows of equilateral triangles lie sqrt(3)/2 of an edge apart; every second row is shifted.
  const double rows = cells.y * vertices_per_cell * 2.0 / std::sqrt(3.0);
  vertices_.x = std::max(2, static_cast<int>(std::lround(cells.x * vertices_per_cell)));
  vertices_.y = 2 * std::max(1, static_cast<int>(std::lround(0.5 * rows)));
  per_cell_ = glm::dvec2(vertices_) / glm::dvec2(cells);
}

std::array<Patch, 3> TriangleGrid::around(const glm::dvec2& place) const {
  // Skewed axes: along a row, and from row to row, half an edge to the east.
  const double b = place.y * per_cell_.y;
  const double a = place.x * per_cell_.x - 0.5 * b;
  const glm::ivec2 low(static_cast<int>(std::floor(a)), static_cast<int>(std::floor(b)));
  const double u = a - low.x, v = b - low.y;
  const bool upper = u + v > 1.0;
  const std::array<glm::ivec2, 3> corners = {low + glm::ivec2(upper), low + glm::ivec2(1, 0),
                                             low + glm::ivec2(0, 1)};
  const std::array<double, 3> weights = {cubed(upper ? u + v - 1.0 : 1.0 - u - v),
                                         cubed(upper ? 1.0 - v : u), cubed(upper ? 1.0 - u : v)};
  const double sum = weights[0] + weights[1] + weights[2];
  std::array<Patch, 3> patches;
  for (std::size_t i = 0; i < 3; ++i) {
    const int row = wrapped_index(corners[i].y, vertices_.y);
    // After a period to the north the skewed axes have gone half as many vertices to the east.
    const int along = corners[i].x + (corners[i].y - row) / 2;
    patches[i] = {{wrapped_index(along, vertices_.x), row}, weights[i] / sum};
  }
  return patches;
}

LayerMap repeated_as_paper(const TextureSet& textures, const glm::ivec2& cells,
                           const glm::ivec2& size_px, std::uint64_t key) {
  return each_pixel(cells, size_px, [&](const glm::dvec2& place) {
    const glm::ivec2 cell(place);
    const auto texture = texture_at(cell, textures.ranks.size(), key);
    return textures.ranks[texture].sample(place.x, place.y);
  });
}

LayerMap repeated_by_blending(const TextureSet& textures, const glm::ivec2& cells,
                              const glm::ivec2& size_px, std::uint64_t key) {
  const TriangleGrid grid(cells);
  const std::vector<PeriodicMap<float>> gaussian = gaussianised(textures.ranks);
  const std::vector<Sample> samples = all_samples(grid.vertices(), gaussian.size(), key);
  const double weight = textures.patches.weight;
  const PeriodicMap<float> patches =
      weight > 0.0 ? patches_of(textures.patches, cells, key ^ key_of("patches"))
                   : PeriodicMap<float>(1, 1);
  return each_pixel(cells, size_px, [&](const glm::dvec2& place) {
    double sum = 0.0, squares = 0.0;
    for (const Patch& patch : grid.around(place)) {
      constexpr double unseen = 1e-6;
      if (patch.weight < unseen) continue;
      const Sample& sample =
          samples[static_cast<std::size_t>(patch.vertex.y) * grid.vertices().x + patch.vertex.x];
      const glm::dvec2 at = place + sample.shift;
      sum += patch.weight * gaussian[sample.texture].sample(at.x, at.y);
      squares += patch.weight * patch.weight;
    }
    const glm::dvec2 in_layer = place / glm::dvec2(cells);
    const double gaussian_sum = sum / std::sqrt(squares) + patches.sample(in_layer.x, in_layer.y);
    return normal_cdf(gaussian_sum / std::sqrt(1.0 + weight * weight));
  });
}

}  // namespace wold::cloud
