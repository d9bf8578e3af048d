#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/modes.h"

namespace wold::cloud {

/// Noise of several octaves: each has twice the frequency and `gain` times the height of the one
/// before. Not used when its weight is 0.
struct Octaves {
  double weight = 0.0;
  glm::ivec2 period = {1, 1};  ///< features across the texture, east and north, of the first octave
  int count = 1;
  double gain = 0.5;
};

/// Where air rises: domes of different sizes, so that clouds have round outlines. Not used when its
/// weight is 0.
struct Thermals {
  double weight = 0.0;
  glm::ivec2 period = {1, 1};  ///< domes across the texture, east and north
  double spread = 0.0;         ///< of their sizes, as in dome_noise()
};

/// Ice that falls from heads and trails behind them in slower wind. Not used when its length is 0.
struct Trails {
  double length = 0.0;  ///< over which they fade by e, in textures
  double bend = 0.0;    ///< how far aside they are after that length, as a fraction of it
  double contrast =
      1.0;  ///< logarithm of how much more ice falls where the heads' field is 1 higher
  /// Where to, clockwise from north, the wind blows heads: not in the file, a layer's own.
  double heading_rad = 0.0;
};

/// Noise beyond a texture's size: where in the layer there are more clouds, where fewer. Not used
/// when its weight is 0.
struct Patches {
  double weight = 0.0;  ///< its standard deviation over that of the textures' Gaussianised ranks
  double cells = 1.0;   ///< size of its features
};

/// What clouds of a kind are like: a file of models/cloud, where the numbers have their sources.
struct Recipe {
  // The layer.
  double base_m = 0.0;
  double thickness_m = 0.0;  ///< of the thickest place
  double cell_m = 0.0;       ///< side of the square that a texture covers
  double cover = 0.0;        ///< fraction of the sky; above 1 it has no thin places
  double opacity = 0.0;      ///< of the densest place
  // The droplets.
  double extinction_per_km = 0.0;
  double asymmetry = 0.0;  ///< mean cosine of the scattering angle
  // The texture: a sum of noises, of which the highest share `cover` is cloud.
  Thermals thermals;  ///< where heaps stand
  Octaves masses;     ///< gradient noise: where other clouds stand
  Octaves billows;    ///< cellular noise, upside down: round heads on heads
  double warp = 0.0;  ///< how far noise displaces all of it, in textures
  glm::ivec2 warp_period = {1, 1};
  Trails trails;    ///< of the sum, whose high places are heads
  Patches patches;  ///< of the layer
  /// Optical depth over that of the densest place, from the edge, 0, to the densest, 1, by rank.
  std::vector<glm::dvec2> profile;

  /// Vertical optical depth, at the droplets' extinction, of the thickest place.
  double optical_depth() const { return extinction_per_km * 1e-3 * thickness_m; }
};

/// The recipe of a kind of clouds. Throws FileError when its file is missing or damaged.
Recipe recipe_of(scene::CloudKind kind);

}  // namespace wold::cloud
