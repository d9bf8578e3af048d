#include "terrain/horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/elementary.h"

namespace wold::terrain {
namespace {

constexpr int blocks = 32;  // along the terrain's side
constexpr float lower_than_all_m = std::numeric_limits<float>::lowest();

std::size_t index_of(const glm::ivec2& block) {
  return static_cast<std::size_t>(block.y) * blocks + static_cast<std::size_t>(block.x);
}

bool is_inside(const glm::ivec2& block) {
  return std::min(block.x, block.y) >= 0 && std::max(block.x, block.y) < blocks;
}

/// Of all samples that bilinear values in a block are made of.
float highest_in(const Heightfield& terrain, const glm::ivec2& block) {
  const int last = terrain.samples() - 1;
  const auto from = [&](int k) { return std::max(k * last / blocks - 1, 0); };
  const auto to = [&](int k) { return std::min((k + 1) * last / blocks + 2, last); };
  float highest_m = lower_than_all_m;
  for (int j = from(block.y); j <= to(block.y); ++j)
    for (int i = from(block.x); i <= to(block.x); ++i)
      highest_m = std::max(highest_m, terrain.at(i, j));
  return highest_m;
}

/// A value of each block, row by row.
template <class Value>
std::vector<float> of_blocks(const Value& value) {
  std::vector<float> values;
  values.reserve(std::size_t{blocks} * blocks);
  for (int row = 0; row < blocks; ++row)
    for (int column = 0; column < blocks; ++column) values.push_back(value({column, row}));
  return values;
}

/// The highest of a block and the eight about it.
float highest_about(const std::vector<float>& highest_m, const glm::ivec2& block) {
  float highest = lower_than_all_m;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (const glm::ivec2 near = block + glm::ivec2(dx, dy); is_inside(near))
        highest = std::max(highest, highest_m[index_of(near)]);
  return highest;
}

/// No ground is higher on the way from anywhere in a block to the border. Along each axis that way
/// is off the way from the block's middle by half a block at most, and from the nearest step on
/// this by another quarter: less than a block in all, so the blocks about the steps hold it.
float highest_ahead(const std::vector<float>& highest_about_m, const glm::ivec2& block,
                    const glm::dvec2& direction) {
  constexpr double step = 0.5;
  float highest = lower_than_all_m;
  for (glm::dvec2 at = glm::dvec2(block) + 0.5;; at += step * direction) {
    const glm::ivec2 here(glm::floor(at));
    if (std::min(here.x, here.y) < -1 || std::max(here.x, here.y) > blocks) return highest;
    highest = std::max(
        highest,
        highest_about_m[index_of(glm::clamp(here, glm::ivec2(0), glm::ivec2(blocks - 1)))]);
  }
}

}  // namespace

Horizons::Horizons(const Heightfield& terrain, std::vector<glm::dvec2> directions, double spacing)
    : terrain_(&terrain), directions_(std::move(directions)), spacing_(spacing) {
  const std::vector<float> highest_m =
      of_blocks([&](const glm::ivec2& block) { return highest_in(terrain, block); });
  const std::vector<float> about_m =
      of_blocks([&](const glm::ivec2& block) { return highest_about(highest_m, block); });
  for (const glm::dvec2& direction : directions_)
    ahead_m_.push_back(of_blocks(
        [&](const glm::ivec2& block) { return highest_ahead(about_m, block, direction); }));
}

double Horizons::elevation_rad(std::size_t direction, const glm::dvec2& from_m,
                               double lowest) const {
  const Heightfield& terrain = *terrain_;
  const double height_m = terrain.sample(from_m.x, from_m.y);
  const glm::ivec2 block = glm::clamp(glm::ivec2(from_m * (blocks / terrain.size_m())),
                                      glm::ivec2(0), glm::ivec2(blocks - 1));
  const double rise_m = std::max(0.0, ahead_m_[direction][index_of(block)] - height_m);
  double steepest = lowest;
  for (double distance_m = terrain.step_m(); rise_m > steepest * distance_m;
       distance_m += std::max(terrain.step_m(), distance_m * spacing_)) {
    const glm::dvec2 at_m = from_m + directions_[direction] * distance_m;
    if (std::min(at_m.x, at_m.y) < 0.0 || std::max(at_m.x, at_m.y) > terrain.size_m()) break;
    steepest = std::max(steepest, (terrain.sample(at_m.x, at_m.y) - height_m) / distance_m);
  }
  return math::atan(steepest);
}

bool is_hidden(const Heightfield& terrain, const glm::dvec3& from_m, const glm::dvec3& to_m) {
  const glm::dvec3 way_m = to_m - from_m;
  const double steps = std::ceil(glm::length(glm::dvec2(way_m)) / terrain.step_m());
  for (long step = 1; step < steps; ++step) {
    const glm::dvec3 at_m = from_m + way_m * (static_cast<double>(step) / steps);
    if (double{terrain.sample(at_m.x, at_m.y)} > at_m.z) return true;
  }
  return false;
}

}  // namespace wold::terrain
