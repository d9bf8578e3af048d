#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace wold::terrain {

/// Where the cells of a raster lie under a square of the ground: polynomials through what a map
/// projection says of a few places. What it says differs between systems in its last bits, and is
/// rounded to less than a thousandth of a cell; so nearly always the map is the same on each of
/// them.
class CellMap {
 public:
  /// The raster's cell, from its upper left corner, of a place in metres from the square's middle,
  /// if there is one.
  using Finder = std::function<std::optional<glm::dvec2>(const glm::dvec2& from_middle_m)>;

  /// Of `samples` x `samples` places on a square of this side.
  CellMap(Finder find, int samples, double size_m);

  /// The cell of the place (i, j) half steps between samples to the east and to the north, from 0,
  /// half a step before the first sample, to 2 * samples. NaN where there is none.
  glm::dvec2 at(int i, int j) const;

 private:
  static constexpr std::size_t nodes = 9;
  using Weights = std::array<double, nodes>;

  double from_middle_m(int half_steps) const;
  Weights weights_at(double place) const;
  glm::dvec2 found(const glm::dvec2& from_middle_m) const;
  void find_nodes();
  bool is_smooth() const;

  Finder find_;
  int samples_;
  double size_m_;
  Weights places_{};                                          ///< of the nodes, from -1 to 1
  std::array<std::array<glm::dvec2, nodes>, nodes> cells_{};  ///< [north][east]
  std::vector<Weights> weights_;                              ///< of each half step
  bool smooth_ = true;
};

}  // namespace wold::terrain
