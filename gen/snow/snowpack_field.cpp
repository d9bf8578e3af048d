#include "snow/snowpack_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "snow/simd_lanes.h"
#include "snowpack/snow_forcing.h"
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
  constexpr double max_classes = 65535.0;
  const auto [low, high] = std::ranges::minmax(heights_m);
  low_m_ = std::floor(low);  // tiles of a ground have the same classes
  class_m_ = std::max(1.0, (static_cast<double>(high) - low_m_) / max_classes);
  count_ = static_cast<std::size_t>(std::lround((high - low_m_) / class_m_)) + 1;
  parallel_for_blocks(of_place_.size(), [&](std::size_t place) {
    of_place_[place] =
        static_cast<std::uint16_t>(std::lround((heights_m[place] - low_m_) / class_m_));
  });
}

FieldStep HeightClasses::step(const WeatherMoment& weather, double hours,
                              double melt_mm_per_day) const {
  require_numbers(weather);
  if (weather.sky) return SeasonStep{weather, hours};
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

bool snows(const FieldStep& step, const HeightClasses& classes) {
  if (const auto* season = std::get_if<SeasonStep>(&step))
    return snow_mm_h(season->weather, classes.highest_m()) > 0.0;
  return std::ranges::any_of(std::get<std::vector<PackStep>>(step),
                             [](const PackStep& of_class) { return of_class.snow_mm > 0.0; });
}

namespace {

void advance_by(const std::vector<PackStep>& steps, SnowpackField& packs,
                const HeightClasses& classes, std::span<const float> drift) {
  parallel_for_blocks(packs.water_mm.size(), [&](std::size_t i) {
    const Snowpack pack = advanced({packs.water_mm[i], packs.depth_m[i], packs.age[i]},
                                   steps[classes.of_place()[i]], drift[i]);
    packs.water_mm[i] = pack.water_mm;
    packs.depth_m[i] = pack.depth_m;
    packs.age[i] = pack.age;
  });
}

/// For loops over places.
inline snowpack::SnowStep step_at(const WeatherMoment& weather, const snowpack::SkyForcing& sky,
                                  double hours, double height_m) {
  const snowpack::SnowForcing air = snowpack::snow_forcing(
      weather.temperature_c, weather.precipitation_mm_h * hours, sky, lapse_k_per_m * height_m);
  return snowpack::snow_step(air, hours);
}

/// Places that are advanced at once.
struct PlaceLanes {
  Lanes<double> height_m, drift, rise_east, rise_north;
  Lanes<double> water_mm, depth_m, age, liquid_mm, lacking_mm;
};

WOLD_LANES_WIDE void advance_lanes(PlaceLanes& at, const WeatherMoment& weather,
                                   const snowpack::SkyForcing& sky, double hours) {
  constexpr snowpack::SnowParameters parameters;
  for (std::size_t i = 0; i < lanes; ++i) {
    const snowpack::SnowStep step = step_at(weather, sky, hours, at.height_m[i]);
    const double sun_mm = snowpack::sun_mm(step, at.rise_east[i], at.rise_north[i]);
    snowpack::SnowState snow = {at.water_mm[i], at.depth_m[i], at.age[i], at.liquid_mm[i],
                                at.lacking_mm[i]};
    snowpack::advance(snow, step, at.drift[i], sun_mm, parameters);
    at.water_mm[i] = snow.water_mm;
    at.depth_m[i] = snow.depth_m;
    at.age[i] = snow.age;
    at.liquid_mm[i] = snow.liquid_mm;
    at.lacking_mm[i] = snow.lacking_mm;
  }
}

/// Advances the places from `first` on, as many as there are lanes or places.
void advance_some(std::size_t first, const SeasonStep& step, SnowpackField& packs,
                  const HeightClasses& classes, std::span<const float> drift,
                  const GroundRise& rise) {
  const std::size_t count = std::min(lanes, packs.water_mm.size() - first);
  const auto place = static_cast<std::ptrdiff_t>(first);
  PlaceLanes at{};
  const auto each_value = [&](const auto& move) {
    move(packs.water_mm, at.water_mm);
    move(packs.depth_m, at.depth_m);
    move(packs.age, at.age);
    move(packs.liquid_mm, at.liquid_mm);
    move(packs.lacking_mm, at.lacking_mm);
  };
  const auto in = [&](const auto& from, Lanes<double>& to) {
    std::copy_n(from.begin() + place, count, to.begin());
  };
  each_value(in);
  in(drift, at.drift);
  in(rise.east, at.rise_east);
  in(rise.north, at.rise_north);
  for (std::size_t i = 0; i < count; ++i)
    at.height_m[i] = classes.height_m(classes.of_place()[first + i]);
  advance_lanes(at, step.weather, *step.weather.sky, step.hours);
  each_value([&](std::vector<double>& to, const Lanes<double>& from) {
    std::copy_n(from.begin(), count, to.begin() + place);
  });
}

void advance_by(const SeasonStep& step, SnowpackField& packs, const HeightClasses& classes,
                std::span<const float> drift, const GroundRise& rise) {
  const std::size_t places = packs.water_mm.size();
  packs.liquid_mm.resize(places, 0.0);
  packs.lacking_mm.resize(places, 0.0);
  constexpr std::size_t block = 64 * lanes;
  parallel_for((places + block - 1) / block, [&](std::size_t b) {
    const std::size_t end = std::min(places, (b + 1) * block);
    for (std::size_t first = b * block; first < end; first += lanes)
      advance_some(first, step, packs, classes, drift, rise);
  });
}

}  // namespace

snowpack::SnowStep SeasonStep::at(double height_m) const {
  return step_at(weather, *weather.sky, hours, height_m);
}

void advance(SnowpackField& packs, const HeightClasses& classes, const FieldStep& step,
             std::span<const float> drift, const GroundRise& rise) {
  if (const auto* season = std::get_if<SeasonStep>(&step))
    advance_by(*season, packs, classes, drift, rise);
  else
    advance_by(std::get<std::vector<PackStep>>(step), packs, classes, drift);
}

}  // namespace wold::snow
