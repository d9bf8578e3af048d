#include "snow/snowpack_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"

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

std::vector<PackStep> HeightClasses::steps(const WeatherMoment& weather, double hours,
                                           double melt_mm_per_day) const {
  require_numbers(weather);
  std::vector<PackStep> steps(count_);
  for (std::size_t i = 0; i < count_; ++i)
    steps[i] =
        pack_step(weather, low_m_ + static_cast<double>(i) * class_m_, hours, melt_mm_per_day);
  return steps;
}

bool is_bare(const SnowpackField& packs) {
  return std::ranges::all_of(packs.water_mm, [](double water_mm) { return water_mm == 0.0; });
}

bool snows(const std::vector<PackStep>& steps) {
  return std::ranges::any_of(steps, [](const PackStep& step) { return step.snow_mm > 0.0; });
}

void advance(SnowpackField& packs, const HeightClasses& classes, const std::vector<PackStep>& steps,
             std::span<const float> drift) {
  parallel_for_blocks(packs.water_mm.size(), [&](std::size_t i) {
    const Snowpack pack = advanced({packs.water_mm[i], packs.depth_m[i], packs.age[i]},
                                   steps[classes.of_place()[i]], drift[i]);
    packs.water_mm[i] = pack.water_mm;
    packs.depth_m[i] = pack.depth_m;
    packs.age[i] = pack.age;
  });
}

}  // namespace wold::snow
