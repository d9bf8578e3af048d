#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "cloud/clouds.h"

namespace wold::cloud {

/// Steps of a LayerMap's numbers that share one entry of a look-up table: clouds have steep edges,
/// but their light changes gently. The tables of four layers stay in near memory.
inline constexpr unsigned ranks_per_entry = 4;
inline constexpr unsigned lights_per_entry = 64;

/// A shape's maps and what is seen of them at one moment, from below: a pixel's premultiplied
/// colour and opacity are the product of its rank's and its light's entries. Sheets are laid over
/// each other.
struct Sheet {
  std::shared_ptr<const ShapeMaps> map;
  glm::dvec2 way_px = {};                  ///< how far the map has drifted
  std::vector<float> opacity_by_rank;      ///< in [0, 1]
  std::vector<glm::vec4> colour_by_light;  ///< linear colour for the fraction of the light, and 1
  double fraction = 1.0;                   ///< of the layer's optical depth
  double depth_left = 1.0;  ///< of the depth that the whole layer's clouds have towards the sun
};

/// Tops above the base at that moment, in steps of ranks_per_entry.
std::vector<float> top_m_by_rank(const LayerState& state);

/// What such tables have for a rank of 16 bits, of any size.
double by_rank(const std::vector<float>& table, double rank);

/// A layer's sheets, the further one first: one, or two while its shape changes. Two sheets whose
/// optical depths are fractions of the layer's let through together what the layer does;
/// [Wang2010]'s fade has fractions of alpha, and thins out half-way. Full light is moment.light.
std::vector<Sheet> sheets_of(const LayerState& state, double pixel_m);

}  // namespace wold::cloud
