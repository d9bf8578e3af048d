#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "core/row_parts.h"
#include "scene/scene.h"
#include "terrain/trodden.h"
#include "terrain/water.h"

namespace wold::terrain {

/// The trodden places of a map: those in a row are few.
class TroddenPlaces {
 public:
  /// Of value (i, j) of the map.
  Trodden at(int i, int j) const;
  bool empty() const;

 private:
  friend class Paths;
  struct Place {
    int i;
    Trodden trodden;
  };
  std::vector<std::vector<Place>> rows_;  ///< from the west
};

/// The paths that people have worn through the meadow: from place to place as they walk
/// (walked_way()), not quite straight, their borders ragged and their wear uneven. The tread is
/// level across the slope and a few centimetres deep; how far it is so is a modelling choice. A
/// keyed function of the place.
class Paths {
 public:
  /// Those whose way has two places or more.
  Paths(const Heightfield& heights_m, const std::vector<scene::Path>& paths, std::uint64_t seed,
        const Water* water);

  /// As a map on the grid shows them, of what counts of its rows. `heights_m`: those of the
  /// constructor.
  TroddenPlaces on_grid(const Heightfield& heights_m, const GroundGrid& grid,
                        const RowParts& parts) const;

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
  const glm::dvec2& begin_m(const Piece& piece) const {
    return paths_[piece.path].line_m[piece.point];
  }
  const glm::dvec2& end_m(const Piece& piece) const {
    return paths_[piece.path].line_m[piece.point + 1];
  }
  /// From the nearest place of the middle of a piece.
  glm::dvec2 from_middle_m(const Piece& piece, const glm::dvec2& at_m) const;
  void file_pieces();
  glm::ivec2 square_at(const glm::dvec2& at_m) const;
  /// The pieces of each path that a map shows, path by path.
  std::vector<Piece> pieces_on(const GroundGrid& grid) const;
  /// From the south-western corner to the north-eastern one of what is so near to a piece.
  std::pair<glm::dvec2, glm::dvec2> box_m(const Piece& piece, double around_m) const;
  /// Of a path, by the samples of a row of a map; none where none of it is near to the row.
  std::vector<const Piece*> nearest_pieces(std::span<const Piece> of_path, int j,
                                           const GroundGrid& grid) const;
  std::vector<TroddenPlaces::Place> row(int j, std::span<const Piece> pieces,
                                        const Heightfield& heights_m, const GroundGrid& grid,
                                        const RowPart& part) const;
  Trodden trodden(const Piece& piece, const glm::dvec2& at_m, const glm::dvec2& ascent,
                  double step_m) const;

  std::vector<Path> paths_;
  double square_m_ = 1.0;  ///< as wide as the longest piece and what is near to it
  std::unordered_map<std::uint64_t, std::vector<Piece>> near_;  ///< by the square that they reach
  Fbm ragged_, wear_;
};

}  // namespace wold::terrain
