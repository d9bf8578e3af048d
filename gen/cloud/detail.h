#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "cloud/fibres.h"
#include "cloud/periodic_map.h"
#include "cloud/recipe.h"

namespace wold::cloud {

/// What a recipe's noise has below the pixels of a layer's map, for a line of sight that sees more
/// than the map holds: the octaves that the map leaves out. Each is looked up in one small tile of
/// noise, at its own scale and place.
class Detail {
 public:
  /// None.
  Detail() = default;

  /// Of a layer whose textures have `side_px` pixels on squares of cell_m; it repeats after
  /// period_m, as the layer does.
  Detail(const Recipe& recipe, int side_px, double cell_m, const glm::dvec2& period_m,
         std::uint64_t key);

  /// What to add to the field (procedural_field_at()) at a place of the layer; mean 0. Octaves
  /// finer than what a sample stands for, footprint_m, are faded out.
  double at(const glm::dvec2& place_m, double footprint_m) const;

  /// No more than this is ever added.
  double max() const { return max_; }

 private:
  struct Octave {
    std::shared_ptr<const PeriodicMap<float>> tile;
    glm::dvec2 tiles_per_m;
    glm::dvec2 shift;  ///< in tiles
    double feature_m;  ///< along its shorter side
    double height;
  };
  void add(const Octaves& octaves, const std::shared_ptr<const PeriodicMap<float>>& tile,
           int side_px, double cell_m, const glm::dvec2& period_m, std::uint64_t key);

  std::vector<Octave> octaves_;
  Fibres fibres_;
  double max_ = 0.0;
};

}  // namespace wold::cloud
