#pragma once

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "landscape/footprint.h"
#include "landscape/landscape.h"

namespace wold::passes {

/// How much of what is behind it the grass of one cell, or part of a cell, hides along a ray.
struct Veil {
  int cell = 0;          ///< index into Landscape::cells
  double opacity = 0.0;  ///< of the whole ray's: what grass before it has hidden is not in it
};

/// What a ray meets in the grass.
struct GrassSight {
  std::vector<Veil> veils;  ///< from the nearest to the farthest
  /// Where half of what is behind is hidden; infinite where it never is.
  double half_m = std::numeric_limits<double>::infinity();
  int half_cell = 0;           ///< index into Landscape::cells; means something with half_m
  double optical_depth = 0.0;  ///< of all the way
};

/// The grass that stands as volumes, as renderers show it: over the footprint of each cell, or part
/// of a cell, the volume that repeats itself, voxel by voxel.
class StandingGrass {
 public:
  /// Reads the volumes' density, 4 bytes a voxel. `landscape` has to outlive it. Throws FileError.
  explicit StandingGrass(const landscape::Landscape& landscape);

  /// Follows a ray along a unit direction as far as `end_m`, or until it lets a thousandth through.
  /// `sight` is made anew; it is the caller's to spare memory.
  void look(const glm::dvec3& eye_m, const glm::dvec3& direction, double end_m,
            GrassSight& sight) const;

 private:
  /// A part of a cell where it stands.
  struct Stand {
    int cell = 0;
    glm::dmat4 cell_from_world{1.0};
    landscape::Footprint footprint;
    double height_m = 0.0;    ///< in cell space
    std::size_t density = 0;  ///< index into densities_
  };
  /// A stand on one of the squares that it reaches into.
  struct OnSquare {
    glm::ivec2 square{0};
    int stand = 0;  ///< index into stands_
  };
  struct Density {
    glm::ivec3 voxels{0};
    double voxel_m = 0.0;
    std::vector<float> extinction_per_m;
  };
  /// What stands on a square, as large as a patch, of a grid.
  struct Square {
    std::size_t first = 0, end = 0;    ///< indices into on_squares_
    double low_m = 0.0, high_m = 0.0;  ///< heights in the world
  };
  struct Way;

  void add_volumes();
  void add_stands();
  void lay_out();
  /// Whether the ray goes on.
  bool cross_square(const Square& square, Way& way, double from_m, double to_m,
                    GrassSight& sight) const;
  bool cross(const Stand& stand, Way& way, double from_m, double to_m, GrassSight& sight) const;

  const landscape::Landscape& landscape_;
  std::vector<Density> densities_;
  std::vector<std::size_t> density_of_volume_;
  std::vector<Stand> stands_;         ///< cell by cell
  std::vector<OnSquare> on_squares_;  ///< square by square
  glm::ivec2 first_square_{0}, squares_{0};
  std::vector<Square> grid_;  ///< row by row
};

}  // namespace wold::passes
