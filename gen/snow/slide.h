#pragma once

#include <utility>
#include <vector>

#include "core/ground_map.h"
#include "snow/snowpack_field.h"

namespace wold::snow {

/// How deep snow can lie on a slope, m, vertically: 3178.4 slope^-1.998 from 10 degrees on
/// (Bernhardt and Schulz 2010, SnowSlide: A simple routine for calculating gravitational snow
/// transport), infinite on gentler ground.
double max_depth_m(double slope_deg);

/// max_depth_m() of every place of a terrain of finite heights.
FactorMap max_depths_m(const Heightfield& terrain);

/// Snow that slopes are too steep for slides to lower ground.
class SnowSlide {
 public:
  SnowSlide(Heightfield terrain, FactorMap max_depths_m)
      : terrain_(std::move(terrain)), max_m_(std::move(max_depths_m)) {}
  explicit SnowSlide(const Heightfield& terrain) : SnowSlide(terrain, max_depths_m(terrain)) {}

  /// Moves what is above max_depth_m() from the highest place to the lowest, with its fraction of
  /// the water: to those of the eight neighbours whose ground is lower, by how far the surface of
  /// snow drops to them; where it drops to none, by how far the ground does. After it no place is
  /// above its limit but pits of the ground and lowest places of the border, from where there is no
  /// way down; all water and depth is kept. `packs` has a place per sample of the terrain.
  void settle(SnowpackField& packs) const;

 private:
  /// Adds the places that are too deep only now to `overfed`.
  void shed(SnowpackField& packs, std::size_t from, std::vector<std::size_t>& overfed) const;

  Heightfield terrain_;
  FactorMap max_m_;
};

}  // namespace wold::snow
