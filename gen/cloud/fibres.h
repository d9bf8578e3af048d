#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloud/periodic_map.h"
#include "cloud/recipe.h"

namespace wold::cloud {

/// What trails (trails.h) have below the pixels of a layer's map: the trails of heads that are
/// finer than these. They are looked up in one tile of some kilometres, and in its halves where a
/// line of sight sees less.
class Fibres {
 public:
  /// None.
  Fibres() = default;

  /// Of a layer whose textures, squares of cell_m, hold the first `held` octaves of the recipe's
  /// masses; it repeats after period_m, as the layer does.
  Fibres(const Recipe& recipe, int held, double cell_m, const glm::dvec2& period_m,
         std::uint64_t key);

  /// What to add to the field (procedural_field()) at a place of the layer; mean 0. What is finer
  /// than what a sample stands for, footprint_m, is not among it.
  double at(const glm::dvec2& place_m, double footprint_m) const;

  /// No more than this is ever added.
  double max() const { return max_; }

 private:
  std::vector<PeriodicMap<float>> tiles_;
  glm::dvec2 tiles_per_m_ = {};
  double pixel_m_ = 0.0;  ///< of the first tile
  double max_ = 0.0;
};

}  // namespace wold::cloud
