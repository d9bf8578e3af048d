#include "snow/snowpack_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "terrain/relief.h"

namespace wold::snow {
namespace {

void require_numbers(const WeatherMoment& weather) {
  if (std::isfinite(weather.temperature_c) && std::isfinite(weather.precipitation_mm_h) &&
      weather.precipitation_mm_h >= 0.0)
    return;
  throw InputError(fmt::format(
      "weather: temperature {} deg C and precipitation {} mm/h; expected finite numbers, and "
      "precipitation of 0 or more; correct [weather] or its table",
      weather.temperature_c, weather.precipitation_mm_h));
}

}  // namespace

HeightClasses::HeightClasses(std::span<const float> heights_m) : of_place_(heights_m.size()) {
  constexpr double most_classes = 65535.0;
  const auto [low, high] = std::ranges::minmax(heights_m);
  low_m_ = std::floor(low);  // tiles of a ground have the same classes
  class_m_ = std::max(1.0, (static_cast<double>(high) - low_m_) / most_classes);
  count_ = static_cast<std::size_t>((high - low_m_) / class_m_ + 0.5) + 1;
  parallel_for_blocks(of_place_.size(), [&](std::size_t place) {
    of_place_[place] = static_cast<std::uint16_t>((heights_m[place] - low_m_) / class_m_ + 0.5);
  });
}

double HeightClasses::height_m(std::size_t place_class) const {
  return low_m_ + static_cast<double>(place_class) * class_m_;
}

ClassSteps HeightClasses::steps(const WeatherMoment& weather, double hours,
                                double melt_mm_per_day) const {
  require_numbers(weather);
  if (weather.sky) {
    std::vector<season::SnowStep> steps(count_);
    const double fallen_mm = weather.precipitation_mm_h * hours;
    for (std::size_t i = 0; i < count_; ++i)
      steps[i] = season::snow_step(season::snow_air(weather.temperature_c, fallen_mm, *weather.sky,
                                                    lapse_k_per_m * height_m(i)),
                                   hours);
    return steps;
  }
  std::vector<PackStep> steps(count_);
  for (std::size_t i = 0; i < count_; ++i)
    steps[i] = pack_step(weather, height_m(i), hours, melt_mm_per_day);
  return steps;
}

GroundRise::GroundRise(const Heightfield& terrain)
    : east(terrain.values().size()), north(terrain.values().size()) {
  const auto side = static_cast<std::size_t>(terrain.samples());
  parallel_for_blocks(east.size(), [&](std::size_t place) {
    const glm::dvec2 at_m =
        terrain.place_m(static_cast<int>(place % side), static_cast<int>(place / side));
    const glm::vec2 rise = terrain::gradient(terrain, at_m.x, at_m.y);
    east[place] = rise.x;
    north[place] = rise.y;
  });
}

bool is_bare(const SnowpackField& packs) {
  return std::ranges::all_of(packs.water_mm, [](double water_mm) { return water_mm == 0.0; });
}

bool snows(const ClassSteps& steps) {
  return std::visit(
      [](const auto& all) {
        return std::ranges::any_of(all, [](const auto& step) { return step.snow_mm > 0.0; });
      },
      steps);
}

namespace {

void advance_all(SnowpackField& packs, const HeightClasses& classes,
                 const std::vector<PackStep>& steps, std::span<const float> drift,
                 const GroundRise&) {
  parallel_for_blocks(packs.water_mm.size(), [&](std::size_t i) {
    const Snowpack pack = advanced({packs.water_mm[i], packs.depth_m[i], packs.age[i]},
                                   steps[classes.of_place()[i]], drift[i]);
    packs.water_mm[i] = pack.water_mm;
    packs.depth_m[i] = pack.depth_m;
    packs.age[i] = pack.age;
  });
}

void advance_all(SnowpackField& packs, const HeightClasses& classes,
                 const std::vector<season::SnowStep>& steps, std::span<const float> drift,
                 const GroundRise& rise) {
  static const season::SnowParameters parameters;
  packs.liquid_mm.resize(packs.water_mm.size(), 0.0);
  packs.lacking_mm.resize(packs.water_mm.size(), 0.0);
  parallel_for_blocks(packs.water_mm.size(), [&](std::size_t i) {
    const season::SnowStep& step = steps[classes.of_place()[i]];
    const double sun_mm = season::sun_mm(step, {rise.east[i], rise.north[i]});
    season::SnowState snow = {packs.water_mm[i], packs.depth_m[i], packs.age[i], packs.liquid_mm[i],
                              packs.lacking_mm[i]};
    season::advance(snow, step, drift[i], sun_mm, parameters);
    packs.water_mm[i] = snow.water_mm;
    packs.depth_m[i] = snow.depth_m;
    packs.age[i] = snow.age;
    packs.liquid_mm[i] = snow.liquid_mm;
    packs.lacking_mm[i] = snow.lacking_mm;
  });
}

}  // namespace

void advance(SnowpackField& packs, const HeightClasses& classes, const ClassSteps& steps,
             std::span<const float> drift, const GroundRise& rise) {
  std::visit([&](const auto& of_class) { advance_all(packs, classes, of_class, drift, rise); },
             steps);
}

}  // namespace wold::snow
