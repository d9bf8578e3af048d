#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "core/ground_map.h"
#include "core/row_parts.h"
#include "light/daylight.h"
#include "terrain/boulders.h"
#include "terrain/finer_relief.h"
#include "terrain/grazing_steps.h"
#include "terrain/land_cover.h"
#include "terrain/lighting.h"
#include "terrain/paths.h"
#include "terrain/photo.h"
#include "terrain/scree.h"
#include "terrain/water.h"

namespace wold::terrain {

/// What is known of the ground beside its shape; null where nothing is.
struct KnownGround {
  const Water* water = nullptr;
  const LandCover* cover = nullptr;
  const Scree* scree = nullptr;
  const Photo* photo = nullptr;
  const Boulders* boulders = nullptr;
  const Paths* paths = nullptr;
  const GrazingSteps* grazing_steps = nullptr;
};

/// Snow that lies on the ground. Functions have to outlive what uses them.
struct SnowSurface {
  /// Empty where none lies.
  SnowDepth depth_m;
  /// Steepest ascent of what wind has carved into its surface, as a map with that step shows it;
  /// empty where it has carved nothing.
  std::function<glm::dvec2(const glm::dvec2& at_m, double step_m)> carved;

  explicit operator bool() const { return static_cast<bool>(depth_m); }
  /// At a place, 0 where none lies.
  double depth_at(const glm::dvec2& at_m) const { return depth_m ? depth_m(at_m) : 0.0; }
};

/// The ground's surface on a grid, as finely as its step shows it: heights, and the relief below
/// their samples where there is some.
class Surface {
 public:
  /// The heights and what is known have to outlive it. `parts`: of the grid's rows, what counts;
  /// empty: all. Nothing is known of other places.
  /// `snow`: buries boulders, evens out paths and grazing steps, and in light what is finer than
  /// the heights.
  Surface(const Heightfield& heights_m, const FinerRelief* finer, const GroundGrid& grid,
          const KnownGround& known = {}, RowParts parts = {}, const SnowSurface& snow = {});

  const GroundGrid& grid() const { return grid_; }
  /// What counts of row `j`.
  const RowPart& part(int j) const { return parts_[static_cast<std::size_t>(j)]; }
  const RowParts& parts() const { return parts_; }
  /// The heights, without what is finer than their samples.
  const Heightfield& heights_m() const { return heights_m_; }
  /// Of value (i, j) of a map on the grid.
  glm::dvec2 place_m(int i, int j) const;
  double height_m(int i, int j) const;
  /// Upward unit normal.
  glm::dvec3 up(int i, int j) const;
  /// Angle with the horizontal, degrees.
  double slope_deg(int i, int j) const;
  /// How much of the snow that lies about it stays on so steep a place, in [0, 1].
  double holds_snow(int i, int j) const;
  /// How far the place stands out of the ground that the heights show, in standard deviations:
  /// spurs are above 0, gullies below; of a normal distribution. 0 where there is no relief.
  double exposure(int i, int j) const;

  /// Share of it that is water, which is level, in [0, 1].
  double water(int i, int j) const;

  /// What a raster of land cover says of it, and a photo: grass grows where both let it, and
  /// where the photo shows ground its colour counts.
  LandCover::Shares cover(int i, int j) const;

  /// Share of it that debris of rock covers, in [0, 1].
  double scree(int i, int j) const;

  /// The boulder at a place, if any. Its cover counts those that are too small for the grid, too.
  NearbyBoulders::Rise boulder(int i, int j) const;

  /// Share of it that feet have worn, in [0, 1]; they leave no debris there.
  double worn(int i, int j) const;

  /// A light on the heights, as it falls on this surface: the sun by Lambert's law, the sky by how
  /// much of it the surface faces, with the shade of boulders. The light itself where nothing is
  /// finer than the heights and no snow is carved; none at places that do not count.
  GroundLight lit(GroundLight on_heights, const glm::dvec3& to_sun) const;

 private:
  struct Bump {
    glm::vec2 gradient{0.0F};
    float exposure = 0.0F;
  };

  /// What herds have made of a place: no other steep side, so that grass stays on it and rock
  /// below.
  struct Grazed {
    glm::vec2 gradient{0.0F};  ///< in light
    float bare = 0.0F;
  };

  void level_water();
  void add_relief();
  FinerRelief::Weights weights_of_finer() const;
  void add_boulders();
  void add_paths();
  void add_grazing_steps();
  Grazed grazed(int i, int j) const;
  /// How much of what feet have made is seen: snow evens it out, and water is level.
  double seen_of_feet(int i, int j) const;
  /// Steepest ascent of the snow's surface over that of the ground below; none where nothing is.
  std::optional<GroundMap<glm::vec2>> ascent_of_snow() const;
  glm::dvec3 lit_face(int i, int j, const glm::vec2& ascent_of_snow) const;
  /// Whether light falls on it as on the heights, without snow.
  bool is_even(int i, int j) const;
  NearbyBoulders::Rise rise_of_boulder(int i, int j) const;

  const Heightfield& heights_m_;
  const FinerRelief* finer_;  ///< null where the grid shows none
  GroundGrid grid_;
  KnownGround known_;
  RowParts parts_;
  std::optional<GroundMap<Bump>> bumps_;
  std::optional<GroundMap<Grazed>> grazed_;  ///< none where nothing is
  std::optional<Scree::Patches> scree_;
  std::optional<NearbyBoulders> boulders_;
  TroddenPlaces trodden_;
  SnowSurface snow_;
};

}  // namespace wold::terrain
