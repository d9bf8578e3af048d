#include "snow/snowfall_model.h"

namespace wold::snow {
namespace {

std::variant<FallingSnow, PaperSnow> snow_of(const scene::PrecipitationPart& part,
                                             const Weather& weather, const FlakePictures& pictures,
                                             const std::shared_ptr<const wind::AirFlow>& air) {
  if (part.snowfall.motion == scene::Law::paper) return PaperSnow(part, weather, pictures);
  return FallingSnow(part, weather, pictures, Falling::snow, air);
}

}  // namespace

SnowfallModel::SnowfallModel(const scene::PrecipitationPart& part, const Weather& weather,
                             const FlakePictures& pictures,
                             const std::shared_ptr<const wind::AirFlow>& air)
    : snow_(snow_of(part, weather, pictures, air)) {}

SeenFlakes SnowfallModel::at(double time_s, const SnowView& view, const Heightfield& ground) const {
  return std::visit([&](const auto& snow) { return snow.at(time_s, view, ground); }, snow_);
}

}  // namespace wold::snow
