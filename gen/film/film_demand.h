#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "film/request.h"
#include "grass/ageing/patch_state.h"
#include "place/growing_ground.h"

namespace wold::film {

/// A baked texel as scene files have it: of a variant in a state, at a level of grass.levels, for a
/// quarter-turn.
struct ShownVolume {
  int variant = 0;
  grass::PatchState state{0};
  int lod = 0;
  int turn = 0;

  auto operator<=>(const ShownVolume&) const = default;
};

/// A variant in a state.
using BladePatchState = std::pair<int, grass::PatchState>;

/// What a frame shows of the meadow.
struct FrameDemand {
  std::set<ShownVolume> volumes;
  std::set<BladePatchState> patches;  ///< that cells show as blades or points
  std::size_t parts = 0;              ///< of cells
  double across_m = 0.0;              ///< side of the square in which their grass is
  bool has_distance = false;          ///< some grass is painted on the ground
  bool has_snow = false;              ///< snow lies on the ground, or has
};

/// What a request's frames show, found by choosing their cells, without making any file. The bytes,
/// memory and time of a film grow with it.
///
/// Of long films some frames of each take are looked at, evenly spread. Between two of them each
/// variant passes through the states between theirs.
class FilmDemand {
 public:
  /// `land`: growing_ground() of the request's scene. Throws what choosing cells throws.
  FilmDemand(const Request& request, const place::GrowingGround& land);

  /// Of each frame that was looked at: all, where they are few.
  const std::map<int, FrameDemand>& frames() const { return frames_; }
  /// Of a frame of the request: its own, or that of the nearest that was looked at.
  const FrameDemand& at(int frame) const;

  /// Of all frames together.
  const std::set<ShownVolume>& volumes() const { return volumes_; }
  const std::set<BladePatchState>& patches() const { return patches_; }

  /// Numbers of the mixtures that stand on the terrain: MixtureField::present().
  const std::vector<int>& mixtures() const { return mixtures_; }

 private:
  void pass(const FrameDemand& from, const FrameDemand& to);

  std::map<int, FrameDemand> frames_;
  std::set<ShownVolume> volumes_;
  std::set<BladePatchState> patches_;
  std::vector<int> mixtures_;
};

}  // namespace wold::film
