#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "scene/scene.h"
#include "terrain/water.h"

namespace wold::terrain {

/// What a raster of land cover says of the scene's ground.
class LandCover {
 public:
  /// `number`: by place, index into `kinds`; -1 where nothing is known.
  LandCover(GroundMap<int> number, std::vector<scene::CoverClass> kinds, std::uint64_t seed);

  /// Of a place, in shares of what its classes say. Borders run where cells end, but ragged, with
  /// bays of all sizes below a cell, and one class fades into the other over a cell.
  struct Shares {
    double grass = 1.0;      ///< on which grass may grow, as far as other limits let it
    double coloured = 0.0;   ///< that has a colour of its own where no grass grows
    glm::vec3 albedo{0.0F};  ///< that colour, times `coloured`
  };
  Shares at(const glm::dvec2& at_m) const;

  /// Cells of a class that is water.
  bool is_water(int i, int j) const;
  const GroundMap<int>& number() const { return number_; }

 private:
  GroundMap<int> number_;
  std::vector<scene::CoverClass> kinds_;
  Fbm bays_;
};

/// terrain.cover on the scene's square, a raster of numbers of classes in any coordinate system;
/// none where the scene has none. What its numbers mean scene::cover_classes_of() says; other
/// numbers, and what lies beyond the raster, say nothing. Throws InputError where it is no raster
/// that lies somewhere, has values that are no whole numbers, or where one of it and
/// terrain.elevation has a coordinate system and the other has none.
std::optional<LandCover> read_land_cover(const scene::Terrain& terrain,
                                         const std::vector<scene::CoverClass>& classes,
                                         std::uint64_t seed);

/// Lakes with the lakes and rivers that the cover knows, water of 36 cells or more that hangs
/// together: as level as a lake, or as river_levels_m() has it. `heights_m`: of the ground.
/// Unchanged where the cover adds nothing.
std::optional<Lakes> with_covered_water(std::optional<Lakes> lakes, const LandCover& cover,
                                        const Heightfield& heights_m);

}  // namespace wold::terrain
