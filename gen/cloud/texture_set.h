#pragma once

#include <cstdint>
#include <vector>

#include "cloud/periodic_map.h"
#include "cloud/recipe.h"
#include "scene/scene.h"

namespace wold::cloud {

/// The textures of one layer, as ranks of one common distribution: what may be blended, moved and
/// thinned without changing what kind of cloud it is.
struct TextureSet {
  std::vector<PeriodicMap<float>> ranks;  ///< each texture; in (0, 1), 1 the densest
  /// Vertical optical depth over that of the densest place, by rank among the layer's clouds, on
  /// equal steps from 0 to 1; never falls.
  std::vector<float> profile;
  double cover = 1.0;            ///< fraction of the sky that is covered
  double densest_opacity = 0.0;  ///< in [0, 0.995]
  Patches patches = {};          ///< of the layer; pictures have none
  /// Of procedural textures: pixels along a side, and how much the rank rises per unit of the field
  /// (procedural_field()), by rank on equal steps from 0 to 1. Pictures have none.
  int field_px = 0;
  std::vector<float> rank_per_field = {};
};

/// Steps of TextureSet::profile.
inline constexpr int profile_steps = 4096;

/// Steps of TextureSet::rank_per_field.
inline constexpr int slope_steps = 128;

/// Textures that procedural clouds choose from, as many as [Wang2010] has.
inline constexpr int procedural_textures = 3;

/// The layer's textures: its pictures, or made by the recipe with at most 512 pixels a side, keyed
/// by `key`, without the octaves that are too fine for them (octaves_in_map()). side_px in [1,
/// 1024]: about as many pixels as a cell will be drawn with, so that none are drawn that nobody
/// sees; cover and opacity are the layer's, or else the recipe's or the pictures' own. Throws
/// FileError for a picture that is missing, damaged or too large.
TextureSet textures_of(const scene::CloudLayer& layer, const Recipe& recipe, int side_px,
                       std::uint64_t key);

/// The same clouds drawn out by wind that blows to `heading_rad` (clockwise from north): ranks are
/// averaged up the wind with weights that fall by e over shear times a tenth of the texture,
/// details over an eighth of that, and ranked anew, so that cover and opacity stay. shear in [0,
/// 1].
TextureSet sheared(const TextureSet& textures, double heading_rad, double shear);

}  // namespace wold::cloud
