#pragma once

#include <variant>

#include "snow/falling_snow.h"
#include "snow/paper_flakes.h"

namespace wold::snow {

/// The snow in the air of a scene, by its snowfall.motion.
class SnowfallModel {
 public:
  /// `pictures` has to outlive this.
  SnowfallModel(const scene::PrecipitationPart& part, const Weather& weather,
                const FlakePictures& pictures);

  /// See FallingSnow::at() and PaperSnow::at().
  SeenFlakes at(double time_s, const SnowView& view, const Heightfield& ground) const;

 private:
  std::variant<FallingSnow, PaperSnow> snow_;
};

}  // namespace wold::snow
