#pragma once

#include <optional>
#include <vector>

#include "core/ground_map.h"
#include "ground/lying_snow.h"
#include "place/site.h"
#include "scene/scene.h"
#include "snow/bedforms.h"
#include "snow/snow_line.h"

namespace wold::ground {

/// The ground of one frame with the snow that lies on it.
class SnowyGround {
 public:
  /// Frame from 1. `scene` and `site` have to outlive it. On a large terrain snow is known finely
  /// about the frame's camera.
  SnowyGround(const scene::Scene& scene, const place::Site& site, int frame);

  /// Ground and snow, as high as they are: snow lies smooth over what is smaller than it is deep,
  /// heaped a little where tufts stand.
  const Heightfield& surface() const { return surface_; }

  /// Sun and sky on that surface.
  const terrain::GroundLight& light() const;
  /// The same without what wind has carved; none where that is light().
  std::optional<terrain::GroundLight> uncarved_light() const;

  /// What the surface makes of the light that falls on it, radiance over irradiance: bare ground as
  /// Site has it, darker where rain has wetted it, and snow, darker where grass still stands over
  /// it.
  /// `under_grass`: fraction of the light that reaches the ground where grass grows.
  ColourMap reflectance(const glm::vec3& under_grass) const;

  /// Of reflectance() in the shade of no grass, what is bare ground's: nothing where it is white.
  ColourMap bare() const;

  /// Its albedo, in the shade of no grass.
  ColourMap albedo() const;

  /// Where grass grows, less by what of it is under snow.
  FactorMap growth() const;

  /// The fraction of grass that stands, under the snow: snow that has a depth buries it from below,
  /// while [He2007]'s, which has none, takes its place where it is white.
  FactorMap extinction_factor(FactorMap extinction_factor) const;

  /// A part of a large terrain's ground under the snow.
  struct CoveredPart {
    place::GroundPart part;  ///< less growth, and the reflectance() under that
    ColourMap bare;          ///< as bare() of all of the ground
  };
  /// Of one that is as ground_part() has it. Its light stays: snow changes no slope as long as the
  /// terrain's steps.
  CoveredPart covered(place::GroundPart part, const glm::vec3& under_grass) const;

  /// Depth of the snow at a place, metres.
  float depth_m(const glm::dvec2& at_m) const;
  /// The snow by place, which this has to outlive; none where all is bare.
  terrain::SnowSurface layer() const;
  /// Fraction of the ground there that is white.
  float white_fraction(const glm::dvec2& at_m) const;
  /// Fraction of water at a place that ice covers: all of it from 5 cm of ice on.
  double frozen(const glm::dvec2& at_m) const;
  /// How far rain has darkened bare ground, in [0, 1).
  double wetness() const { return wetness_; }

  /// Mean fraction of the ground that is white.
  double white_fraction() const;

  /// Mean albedo of ground and snow, of which a fraction of what stands is white.
  double mean_albedo() const;

 private:
  bool is_bare() const { return !white_; }
  void lay_everywhere(int frame);
  void lay_about_the_camera(int frame);
  void carve(int frame);
  glm::dvec2 carved(const glm::dvec2& at_m, double step_m) const;
  /// How much of what falls there stays, in [0, 1]: none of it in water.
  float holds_snow(const glm::dvec2& at_m, double step_m) const;
  void keep_from_water(FactorMap& snow) const;
  /// Takes snow off the steep sides of boulders, on ground that is not large.
  void clear_steep_sides(FactorMap& white) const;
  void freeze_water(int frame);
  /// Ice where water is frozen, in place of what comes out of the water.
  ColourMap iced(ColourMap bare) const;
  float grass_above(const glm::dvec2& at_m) const;
  FactorMap above_snow(FactorMap growth) const;
  FactorMap white(const GroundGrid& grid, const std::optional<FactorMap>& ledges) const;
  /// white_fraction() of a large terrain, if its walls held snow as level ground does.
  float white_without_walls(const glm::dvec2& at_m) const;
  /// Bare ground with its growth, under that snow and in the shade of that grass.
  ColourMap reflectance(ColourMap bare, const FactorMap& growth, const FactorMap& white,
                        const glm::vec3& under_grass) const;
  /// Bare ground after rain.
  ColourMap wetted(ColourMap bare) const;

  const scene::Scene& scene_;
  const place::Site& site_;
  scene::Grass grass_;  ///< scene::mean_grass()
  Heightfield surface_;
  std::optional<terrain::GroundLight> light_;  ///< where it is not the site's
  std::optional<FactorMap> white_;             ///< fraction of the ground that is white
  FactorMap depth_m_;                          ///< where `lying_` is none
  std::optional<LyingSnow> lying_;             ///< on a large terrain
  std::optional<snow::SnowLine> snow_line_;    ///< with it
  std::optional<snow::Bedforms> bedforms_;     ///< where wind has carved the snow
  double carved_ = 0.0;                        ///< how far, over what bedforms_ have
  float albedo_ = 0.9F;
  std::vector<double> ice_m_;  ///< of lakes, from the lowest height of the terrain to the highest
  double lowest_m_ = 0.0, highest_m_ = 0.0;  ///< these heights
  double wetness_ = 0.0;                     ///< of the bare ground, in [0, 1)
};

}  // namespace wold::ground
