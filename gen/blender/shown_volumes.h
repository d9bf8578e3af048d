#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "landscape/landscape.h"

namespace wold::blender {

/// What a cell shows: a volume, or a quarter of one or part of the quarter, in the light of a map.
struct ShownVolume {
  std::size_t volume = 0;      ///< index into Landscape::volumes
  std::optional<int> quarter;  ///< of landscape::quarters_of_patch(); none: the whole
  int light_map = 0;           ///< see landscape::light_map_of()

  auto operator<=>(const ShownVolume&) const = default;
};

/// What a cell of blades shows: a mesh in the light of a map.
struct ShownBlades {
  std::size_t mesh = 0;  ///< index into Landscape::blade_meshes
  int light_map = 0;     ///< see landscape::light_map_of()

  auto operator<=>(const ShownBlades&) const = default;
};

/// All that cells of a frame show, each once, numbered in ascending order.
template <class Shown>
class ShownInstances {
 public:
  explicit ShownInstances(const std::vector<Shown>& of_cells) : all_(of_cells) {
    std::ranges::sort(all_);
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
    picks_.reserve(of_cells.size());
    for (const Shown& each : of_cells)
      picks_.push_back(static_cast<int>(std::ranges::lower_bound(all_, each) - all_.begin()));
  }

  const std::vector<Shown>& all() const { return all_; }

  /// The number of what each cell shows.
  const std::vector<int>& picks() const { return picks_; }

 private:
  std::vector<Shown> all_;
  std::vector<int> picks_;
};

/// Of Landscape::cells, and of Landscape::blade_cells.
ShownInstances<ShownVolume> shown_volumes(const landscape::Landscape& landscape);
ShownInstances<ShownBlades> shown_blades(const landscape::Landscape& landscape);

}  // namespace wold::blender
