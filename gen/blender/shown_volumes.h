#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "landscape/landscape.h"

namespace wold::blender {

/// What a cell shows: a volume, or a quarter of one or part of the quarter.
struct ShownVolume {
  std::size_t volume = 0;      ///< index into Landscape::volumes
  std::optional<int> quarter;  ///< of landscape::quarters_of_patch(); none: the whole

  auto operator<=>(const ShownVolume&) const = default;
};

/// All that the cells of a frame show, each once, numbered in ascending order.
class ShownVolumes {
 public:
  explicit ShownVolumes(const landscape::Landscape& landscape);

  const std::vector<ShownVolume>& all() const { return all_; }

  /// The number of what each cell shows.
  const std::vector<int>& picks() const { return picks_; }

 private:
  std::vector<ShownVolume> all_;
  std::vector<int> picks_;
};

}  // namespace wold::blender
