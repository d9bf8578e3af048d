#pragma once

#include <variant>

#include "snow/falling_snow.h"
#include "snow/paper_flakes.h"

namespace wold::snow {

/// The snow in the air of a scene, by its snowfall.motion.
class SnowfallModel {
 public:
  /// `pictures` has to outlive this. `air`: see WindField; flakes that move as "paper" has it do
  /// without.
  SnowfallModel(const scene::PrecipitationPart& part, const Weather& weather,
                const FlakePictures& pictures,
                const std::shared_ptr<const wind::AirFlow>& air = nullptr);

  /// See FallingSnow::at() and PaperSnow::at().
  SeenFlakes at(double time_s, const SnowView& view, const Heightfield& ground) const;

 private:
  std::variant<FallingSnow, PaperSnow> snow_;
};

}  // namespace wold::snow
