#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "phenology/film_season.h"
#include "scene/scene.h"

namespace wold::place {

/// The weathering degree of a film's meadow, by place and frame.
///
/// Without a season it is the frame's plus ageing.age_spread times a smooth keyed field, which
/// fades to nothing for all-fresh and all-dry frames: the same spots wither first. On a terrain
/// of more than 120 m that field has places of all sizes, and dry ground withers before wet:
/// spurs before hollows, sunny slopes before shady ones.
///
/// In a season places go through the same days earlier or later. By Hopkins' bioclimatic law (1920,
/// Bioclimatics) autumn comes four days earlier for every 400 feet of height. What makes nights
/// colder does so by as much as height would whose air is as much colder all day, half of it at
/// night: hollows, by season.hollow_frost times how deep they are below their surroundings,
/// the deepest of the terrain counting as 1. Slopes that face the noon sun of the equinox dry
/// earlier, ten days for one that gets twice as much as level ground, other slopes later. The soil
/// adds season.spread times a smooth keyed field of standard deviation 1.
class Withering {
 public:
  /// `season`: phenology::film_season() of the scene, nullptr where that is none.
  Withering(const scene::Scene& scene, const Heightfield& terrain,
            std::shared_ptr<const phenology::FilmSeason> season);

  /// At a point of the ground in a frame (from 1), in [0, 1].
  double at(const glm::dvec2& at_m, int frame) const;

  /// The least and the largest that it can be in a frame.
  std::pair<double, double> range(int frame) const;

 private:
  double noise(const glm::dvec2& at_m) const;

  scene::Ageing ageing_;
  Fbm field_;
  std::optional<ScaleFreeNoise> scale_free_;  ///< in its place on a wide terrain
  FactorMap dryness_;                         ///< dryness_map() there
  // of a season:
  std::shared_ptr<const phenology::FilmSeason> season_;
  std::vector<double> frame_days_;  ///< after the first frame
  double spread_days_ = 0.0;
  FactorMap delay_days_;                   ///< of the place, without the soil's
  std::pair<double, double> delays_days_;  ///< least and largest, with the soil's
};

}  // namespace wold::place
