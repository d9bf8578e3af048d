#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace wold::terrain {

/// Mountains that streams have worn, without end: a tile that repeats, taken apart into octaves,
/// features of one size, of half of it and so on. Lengths are in units of the largest ones.
///
/// Rock rises in belts between lowlands that stay; streams cut it and slopes creep until both keep
/// pace (the stream-power law, see carve()). So there are ridges, spurs, and valleys that join.
class WornLand {
 public:
  static constexpr int octaves = 6;
  /// After which the land repeats, eastwards and northwards.
  static constexpr int period = 4;

  /// Takes most of a second of work.
  explicit WornLand(std::uint64_t key);

  /// Height of features of size 2^-octave at a place: mean 0; all octaves together have
  /// deviation 1.
  double height(int octave, const glm::dvec2& at) const;

  /// A bound: height() of an octave is nowhere higher.
  double highest(int octave) const { return highest_.at(static_cast<std::size_t>(octave)); }

  /// How steep the land is about a place, over its mean.
  double steepness(const glm::dvec2& at) const;

 private:
  using Tile = std::vector<float>;  ///< row by row
  static double between(const Tile& tile, const glm::dvec2& at);

  std::vector<Tile> octaves_;
  std::vector<double> highest_;  ///< of octaves
  Tile steepness_;
};

}  // namespace wold::terrain
