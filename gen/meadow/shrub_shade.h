#pragma once

#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "grass/geometry/crown.h"
#include "meadow/cells.h"
#include "scene/scene.h"
#include "terrain/surface.h"

namespace wold::meadow {

/// The shade that shrubs cast on what is around them. Their crowns are the half-ellipsoids on which
/// their twigs end, filled evenly with leaves that face all ways: extinction is half of the leaves'
/// area per volume [Ross1981]. Each shrub's own ground is left out: the light on that is the
/// shrub's, which has its shade in itself. What of a shrub is not shown shades nothing.
class ShrubShade {
 public:
  /// Of the shrubs among a frame's choices that stand beside their cell. `to_sun`: unit vector.
  ShrubShade(const scene::Scene& scene, std::span<const CellChoice> choices,
             const glm::dvec3& to_sun);
  ShrubShade(const ShrubShade&) = delete;  // what is placed refers to patches
  ShrubShade& operator=(const ShrubShade&) = delete;

  /// Which part of the sun's light comes through half-way up the grass, or to the snow where that
  /// is deeper: 1 where there is no shade. Finer than a map shows it, it fades. Nothing where no
  /// shade is. `terrain`: without snow; `snow_m`: how deep that lies at a place; empty: none.
  std::optional<FactorMap> sunlit(const Heightfield& terrain, const GroundGrid& grid,
                                  const terrain::SnowDepth& snow_m = {}) const;

 private:
  /// Those of a patch, in cell space.
  struct Shrubs {
    Shrubs(const scene::Scene& scene, int patch);

    /// Along a ray, of which `along` is a metre; 0 where it starts above one of them.
    double optical_depth(const glm::dvec3& start_m, const glm::dvec3& along) const;

    std::vector<grass::Crown::Cushion> cushions;
    double height_m = 0.0;
    double extinction_per_m = 0.0;
  };
  struct Placed {
    /// Between which places to the east their shade lies, so far north.
    glm::dvec2 between_m(double y_m) const;

    const Shrubs* shrubs;
    glm::dmat4 cell_from_world;
    glm::dvec3 along;          ///< a metre towards the sun, in cell space
    double size_m;             ///< of their patch
    double cast;               ///< the fraction of their optical depth that counts
    glm::dvec2 low_m, high_m;  ///< of the ground under them
    glm::dvec2 falls_m;        ///< how far from it the shade of their tops may lie
  };

  void add(const Shrubs& shrubs, const BesideCell& beside);
  float passed(const Placed& placed, const glm::dvec3& at_m, double step_m) const;

  glm::dvec3 to_sun_;
  double patch_m_, grass_m_;
  std::map<int, Shrubs> patches_;  ///< by their number
  std::vector<Placed> placed_;
};

}  // namespace wold::meadow
