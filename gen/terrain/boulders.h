#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "scene/scene.h"
#include "terrain/boulder.h"
#include "terrain/paths.h"
#include "terrain/scree.h"
#include "terrain/water.h"

namespace wold::terrain {

/// The boulders of a part of the ground, as a map with some step shows them; see
/// Boulders::nearby().
class NearbyBoulders {
 public:
  const std::vector<Boulder>& all() const { return boulders_; }

  /// What lies at a place.
  struct Rise {
    double height_m = 0.0;  ///< of the highest boulder, over the ground or the snow; 0 beside all
    glm::dvec2 gradient{0.0};  ///< its steepest ascent, as far as a map with the step shows it
    double cover = 0.0;        ///< share of a piece of ground, a step wide, that is boulder
  };
  /// `snow_m`: how deep the ground, and what is lower, lies under snow.
  Rise at(const glm::dvec2& at_m, double snow_m = 0.0) const;

  /// What all leave of the light beside them; on them it is all. See Boulder::light_beside().
  Boulder::Light light_beside(const glm::dvec2& at_m, const glm::dvec3& to_sun,
                              const glm::dvec2& ascent, double snow_m = 0.0) const;

 private:
  friend class Boulders;

  /// Cells of one size, row by row from the south-western one.
  struct Cells {
    double cell_m = 1.0;
    double shown = 1.0;  ///< how much of this size a map shows, in [0, 1]
    glm::ivec2 first{0};
    glm::ivec2 count{0};
    std::vector<std::int32_t> boulder;  ///< place in boulders_; -1: none

    std::size_t index(const glm::ivec2& cell) const {
      const glm::ivec2 place = cell - first;
      return static_cast<std::size_t>(place.y) * static_cast<std::size_t>(count.x) +
             static_cast<std::size_t>(place.x);
    }
  };
  const Boulder* in(const Cells& cells, const glm::ivec2& cell) const;
  /// boulder_of(boulder) of each in a square of cells.
  template <class Visit>
  void visit(const Cells& cells, const glm::ivec2& first, int along, const Visit& boulder_of) const;

  double step_m_ = 0.0;
  std::vector<Cells> cells_;
  std::vector<Boulder> boulders_;
};

/// Where boulders lie: terrain.boulders on a hectare of open ground, in loose groups, and up to 20
/// times as many where blocks come down from rock (Scree::likely()); none in water, on paths and on
/// ground where they would roll on, by its slope over a thousandth of the terrain or a step of its
/// heights.
///
/// Widths are from 0.47 to 4.6 m. As many are wider than a width as its inverse square says: rock
/// breaks into pieces with exponents of 1.4 to 3.5, mostly 2 to 2.6 [Turcotte1986]. How groups and
/// the foot of rock faces differ from open ground is a choice. A keyed function of the place.
class Boulders {
 public:
  /// Of the heights, and the scree, the water and the paths where there are some. Needs
  /// terrain.boulders > 0.
  Boulders(const Heightfield& heights_m, const scene::Terrain& terrain, std::uint64_t seed,
           const Scree* scree, std::shared_ptr<const Water> water,
           std::shared_ptr<const Paths> paths = {});

  /// Of a square and so far around it that their shadows are known, as a map with that step shows
  /// them: each size as far as shown_fraction() says. A step of 0 shows all.
  NearbyBoulders nearby(const Square& square, double step_m) const;

  /// Whether a boulder of a width about a place is wanted.
  using Wanted = std::function<bool(const glm::dvec2& middle_m, double width_m)>;
  /// Those that are wanted of each size, where they are no farther from a place, along an axis,
  /// than so many times the size's greatest width. `wanted` is called from several threads.
  std::vector<Boulder> about(const glm::dvec2& at_m, double widths, const Wanted& wanted) const;

  /// Share of the ground about a place that those cover which a map with that step does not show.
  double hidden_cover(const glm::dvec2& at_m, double step_m) const;

 private:
  static constexpr double spread = 2.15;
  /// Of one size, one in some of the cells of a grid.
  struct Size {
    double width_m;  ///< the narrowest; the widest is `spread` times as wide
    double most_m() const { return spread * width_m; }
    /// The middle of a boulder lies in its cell.
    double cell_m() const { return 5.0 * width_m; }
  };
  struct Placed {
    glm::ivec2 cell;
    Boulder boulder;
  };
  static constexpr std::array<Size, 3> sizes{{{2.15}, {1.0}, {1.0 / 2.15}}};

  /// Of the sizes that terrain.boulders counts.
  static double cells_on_a_hectare();
  /// Probability that a cell about a place has one.
  double probability(const glm::dvec2& at_m) const;
  /// Those of a row of cells; of cells from one to another one, row by row.
  std::vector<Placed> row_of(std::size_t size, const glm::ivec2& first, int count,
                             const Wanted& wanted) const;
  std::vector<std::vector<Placed>> rows_of(std::size_t size, const glm::ivec2& first,
                                           const glm::ivec2& last, const Wanted& wanted) const;
  NearbyBoulders::Cells cells_of(std::size_t size, const Square& square,
                                 std::vector<Boulder>& all) const;

  std::uint64_t key_;
  std::shared_ptr<const Water> water_;
  std::shared_ptr<const Paths> paths_;  ///< people have cleared them
  FactorMap likely_;  ///< that a cell has one, where groups are neither dense nor loose
  Fbm groups_;
};

}  // namespace wold::terrain
