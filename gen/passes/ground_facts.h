#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "landscape/landscape.h"

namespace wold::passes {

/// Grass that is painted on the ground instead of standing on it.
struct PaintedGrass {
  int mixture = 0;       ///< index into GroundFacts::mixtures
  double opacity = 0.0;  ///< fraction of the ground that it hides from the eye
};

/// What a frame's model knows and its Landscape does not have. Functions of a place on the ground:
/// metres, x east, y north; they may be called by many threads at once.
struct GroundFacts {
  using Number = std::function<double(const glm::dvec2& at_m)>;
  using Colour = std::function<glm::vec3(const glm::dvec2& at_m)>;

  Number snow_m;          ///< depth
  Number white_fraction;  ///< of the ground, in [0, 1]
  Number weathering;      ///< degree, in [0, 1]
  Number wetness;         ///< of the bare ground, in [0, 1]
  Colour albedo;          ///< of the ground with its snow
  Colour irradiance;      ///< of the ground, as Daylight has it
  std::function<PaintedGrass(const glm::dvec3& at_m)> painted_grass;

  std::vector<std::string> species;           ///< names, each once
  std::vector<std::vector<double>> mixtures;  ///< fraction of each species in each mixture, sum 1
  std::vector<int> mixture_of_patch;          ///< by CellOrigin::patch

  landscape::Camera next_camera{};  ///< of the next frame

  /// Metres to the east and north per metre of height by which the grass of a cell
  /// (CellOrigin::cell) leans over more in the next frame; may be called by many threads at once.
  /// None where grass stands still.
  std::function<glm::dvec2(const glm::ivec2& cell)> more_lean{};
};

}  // namespace wold::passes
