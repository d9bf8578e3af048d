#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "scene/scene.h"
#include "terrain/water.h"

namespace wold::terrain {

/// What feet have made of a place.
struct Trodden {
  double bare = 0.0;  ///< share of a piece of ground, a step wide, that is worn bare, in [0, 1]
  glm::dvec2 gradient{0.0};  ///< steepest ascent of what they have worn off and levelled
};

/// The trodden places of a map: those in a row are few.
class TroddenPlaces {
 public:
  /// Of value (i, j) of the map.
  Trodden at(int i, int j) const;

 private:
  friend class Paths;
  struct Place {
    int i;
    Trodden trodden;
  };
  std::vector<std::vector<Place>> rows_;
};

/// The paths that people have worn through the meadow: from place to place as they walk
/// (walked_way()), not quite straight, their borders ragged and their wear uneven. The tread is
/// level across the slope and a few centimetres deep; how far it is so is a modelling choice. A
/// keyed function of the place.
class Paths {
 public:
  Paths(const Heightfield& heights_m, const std::vector<scene::Path>& paths, std::uint64_t seed,
        const Water* water);

  /// As a map on the grid shows them. `heights_m`: of the ground, as they were when it was made.
  TroddenPlaces on_grid(const Heightfield& heights_m, const GroundGrid& grid) const;

  /// Whether a place is on one, or so many metres beside it, up to 4.
  bool lead_past(const glm::dvec2& at_m, double beside_m) const;

  /// Points along each of them: east and north.
  std::vector<std::vector<glm::dvec2>> lines_m() const;

 private:
  struct Path {
    std::vector<glm::dvec2> line_m;
    double width_m;
  };
  /// From a point of a path to the next.
  struct Piece {
    std::size_t path, point;
  };
  glm::dvec2 from_middle_m(const Piece& piece, const glm::dvec2& at_m) const;
  void file_pieces();
  /// A sample near a piece.
  struct Near {
    int i;
    double far_m;  ///< from the middle of the path
    Piece piece;
  };
  /// Adds the samples near a piece, by their rows.
  void add_near(const Piece& piece, const GroundGrid& grid,
                std::vector<std::vector<Near>>& rows) const;
  Trodden trodden(const Near& near, const glm::dvec2& at_m, const glm::dvec2& ascent,
                  double step_m) const;

  std::vector<Path> paths_;
  /// Pieces by the square of near_m that they or what is as near to them reach into.
  std::unordered_map<std::uint64_t, std::vector<Piece>> near_;
  Fbm ragged_, wear_;
};

}  // namespace wold::terrain
