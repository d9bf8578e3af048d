#include "snow/snowfall_model.h"

namespace wold::snow {
namespace {

std::variant<FallingSnow, PaperSnow> snow_of(const scene::Scene& scene, const Weather& weather,
                                             const FlakePictures& pictures) {
  if (scene.snowfall.motion == scene::Law::paper) return PaperSnow(scene, weather, pictures);
  return FallingSnow(scene, weather, pictures);
}

}  // namespace

SnowfallModel::SnowfallModel(const scene::Scene& scene, const Weather& weather,
                             const FlakePictures& pictures)
    : snow_(snow_of(scene, weather, pictures)) {}

SeenFlakes SnowfallModel::at(double time_s, const SnowView& view, const Heightfield& ground) const {
  return std::visit([&](const auto& snow) { return snow.at(time_s, view, ground); }, snow_);
}

}  // namespace wold::snow
