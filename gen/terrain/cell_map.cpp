#include "terrain/cell_map.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/elementary.h"

namespace wold::terrain {
namespace {

constexpr double roundings_per_cell = 16384.0;

glm::dvec2 rounded(const glm::dvec2& cell) {
  return glm::dvec2(std::round(cell.x * roundings_per_cell),
                    std::round(cell.y * roundings_per_cell)) /
         roundings_per_cell;
}

}  // namespace

CellMap::CellMap(Finder find, int samples, double size_m)
    : find_(std::move(find)), samples_(samples), size_m_(size_m) {
  // Chebyshev's points, between which a polynomial does not swing.
  for (std::size_t a = 0; a < nodes; ++a)
    places_[a] = -math::cos(std::numbers::pi * static_cast<double>(a) / (nodes - 1));
  find_nodes();
  for (int k = 0; k <= 2 * samples; ++k) weights_.push_back(weights_at(1.0 * k / samples - 1.0));
  smooth_ = is_smooth();
}

double CellMap::from_middle_m(int half_steps) const {
  return (0.5 * (half_steps - 1) / (samples_ - 1) - 0.5) * size_m_;
}

/// Lagrange's.
CellMap::Weights CellMap::weights_at(double place) const {
  Weights weights{};
  for (std::size_t a = 0; a < nodes; ++a) {
    weights[a] = 1.0;
    for (std::size_t b = 0; b < nodes; ++b)
      if (b != a) weights[a] *= (place - places_[b]) / (places_[a] - places_[b]);
  }
  return weights;
}

glm::dvec2 CellMap::found(const glm::dvec2& from_middle_m) const {
  return find_(from_middle_m).value_or(glm::dvec2(std::numeric_limits<double>::quiet_NaN()));
}

void CellMap::find_nodes() {
  const double half_m = from_middle_m(2 * samples_);
  for (std::size_t north = 0; north < nodes; ++north)
    for (std::size_t east = 0; east < nodes; ++east)
      cells_[north][east] = rounded(found(half_m * glm::dvec2(places_[east], places_[north])));
}

/// Whether the polynomials are true to a hundredth of a cell. They are not around poles, and where
/// degrees start anew: there the projection is asked for every place.
bool CellMap::is_smooth() const {
  constexpr int checks = 16;
  constexpr double max_cells = 0.01;
  for (int north = 0; north <= checks; ++north)
    for (int east = 0; east <= checks; ++east) {
      const glm::ivec2 half_steps = glm::ivec2(east, north) * (2 * samples_) / checks;
      const glm::dvec2 off = at(half_steps.x, half_steps.y) -
                             found({from_middle_m(half_steps.x), from_middle_m(half_steps.y)});
      if (!(glm::length(off) < max_cells)) return false;
    }
  return true;
}

glm::dvec2 CellMap::at(int i, int j) const {
  if (!smooth_) return found({from_middle_m(i), from_middle_m(j)});
  const Weights& east = weights_[static_cast<std::size_t>(i)];
  const Weights& north = weights_[static_cast<std::size_t>(j)];
  glm::dvec2 cell(0.0);
  for (std::size_t b = 0; b < nodes; ++b) {
    glm::dvec2 row(0.0);
    for (std::size_t a = 0; a < nodes; ++a) row += east[a] * cells_[b][a];
    cell += north[b] * row;
  }
  return cell;
}

}  // namespace wold::terrain
