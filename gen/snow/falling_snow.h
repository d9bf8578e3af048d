#pragma once

#include <cstdint>
#include <optional>

#include "core/ground_map.h"
#include "scene/parts.h"
#include "snow/crystal_picture.h"
#include "snow/flake_motion.h"
#include "snow/near_field.h"
#include "snow/seen_flakes.h"
#include "snow/snow_view.h"
#include "snow/tornado.h"
#include "snow/weather.h"

namespace wold::snow {

/// Flakes, or drops of rain, of physical sizes and speeds, as a view sees them; see FlakeMotion and
/// NearField.
///
/// The air within sqrt(2)^(j-1) to sqrt(2)^j m of the eye shows population j, which repeats itself
/// in the world after a cube that just holds what can be seen of it. So flakes stay where they are
/// while the camera moves or turns, and far air, where few flakes are drawn, has few.
class FallingSnow {
 public:
  /// `pictures` has to outlive this. `air`: see WindField.
  FallingSnow(const scene::PrecipitationPart& part, const Weather& weather,
              const FlakePictures& pictures, Falling what = Falling::snow,
              const std::shared_ptr<const wind::AirFlow>& air = nullptr);

  /// At `time_s` since the first frame, above the ground. Nothing where none falls: the weather's
  /// precipitation that is snow, or rain, at the eye's height counts.
  SeenFlakes at(double time_s, const SnowView& view, const Heightfield& ground) const;

 private:
  NearField field_of(double rate_mm_h, double solid_angle_sr) const;

  Falling what_;
  Weather weather_;
  const FlakePictures& pictures_;
  std::optional<FlakeMotion> motion_;  ///< none when nothing ever falls
  std::optional<Tornado> tornado_;
  std::uint64_t key_;
  double flakes_;
  double shutter_s_;
};

}  // namespace wold::snow
