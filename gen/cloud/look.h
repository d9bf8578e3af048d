#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "cloud/clouds.h"

namespace wold::cloud {

/// What is seen of a rank: premultiplied linear colour and opacity, and how many ranks of a
/// LayerMap share one entry.
inline constexpr int ranks_per_entry = 8;
inline constexpr int look_entries = 65536 / ranks_per_entry;

/// A map and what is seen of its ranks at one moment, from below. Sheets are laid over each other.
struct Sheet {
  std::shared_ptr<const LayerMap> map;
  glm::dvec2 way_px = {};       ///< how far the map has drifted
  std::vector<glm::vec4> look;  ///< look_entries of them, by rank
};

/// A layer's sheets, the further one first: one, or two while its shape changes. Two sheets whose
/// optical depths are shares of the layer's let through together what the layer does; the paper's
/// fade has shares of alpha, and thins out half-way.
///
/// Light is that of moment.light. Unless lit as in the paper, a thick cloud's base has the light
/// that two-stream diffusion lets through without absorption, T = 1 / (1 + 3/4 (1 - g) tau), g the
/// asymmetry, tau the droplets' optical depth (Bohren 1987, Multiple scattering of light and some
/// of its observable consequences).
std::vector<Sheet> sheets_of(const LayerState& state, double pixel_m);

}  // namespace wold::cloud
