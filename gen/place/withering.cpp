#include "place/withering.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/random.h"
#include "core/statistics.h"
#include "place/cell_window.h"
#include "place/dryness.h"
#include "place/topography.h"
#include "scene/calendar.h"
#include "snow/weather.h"
#include "terrain/relief.h"

namespace wold::place {
namespace {

/// Hopkins 1920: four days for 400 feet.
constexpr double days_per_m = 4.0 / 121.92;
/// Nights are half of the day.
constexpr double days_per_night_k = 0.5 * days_per_m / snow::lapse_k_per_m;
constexpr double days_of_twice_the_sun = 10.0;
/// The field is cut at so many standard deviations.
constexpr double max_deviations = 2.5;

/// By how many days a place withers later than the mean one.
FactorMap delays_days(const scene::Scene& scene, const Heightfield& terrain) {
  const FactorMap hollow = hollows(terrain);
  const double mean_m = mean(terrain.values());
  const glm::dvec3 sun = equinox_sun(scene.sun.latitude_deg);
  FactorMap delays(terrain.samples(), terrain.square());
  for (int j = 0; j < delays.samples(); ++j)
    for (int i = 0; i < delays.samples(); ++i) {
      const glm::dvec2 at_m = delays.place_m(i, j);
      const double early =
          days_per_m * (double{terrain.at(i, j)} - mean_m) +
          days_per_night_k * scene.season.hollow_frost_k * hollow.at(i, j) +
          days_of_twice_the_sun *
              (sun_over_level(terrain::gradient(terrain, at_m.x, at_m.y), sun) - 1.0);
      delays.at(i, j) = static_cast<float>(-early);
    }
  return delays;
}

std::uint64_t key_of_field(std::uint64_t seed) {
  return random_bits({seed, key_of("weathering"), 0, key_of("field")});
}

/// How far the weathering degree may differ from place to place without a season.
double amplitude(const scene::Ageing& ageing, double degree) {
  return ageing.age_spread * 4.0 * degree * (1.0 - degree);
}

}  // namespace

Withering::Withering(const scene::Scene& scene, const Heightfield& terrain,
                     std::shared_ptr<const phenology::FilmSeason> season)
    : ageing_(scene.ageing), field_(key_of_field(scene.seed), /*octaves=*/2, /*hurst=*/1.0) {
  if (is_large(scene)) {
    constexpr double of_terrain = 0.1, of_feature = 0.25, hurst = 0.2;
    const double feature_m = ageing_.age_spread_feature_m;
    scale_free_.emplace(key_of_field(scene.seed),
                        ScaleFreeNoise::Sizes{std::max(of_terrain * terrain.size_m(), feature_m),
                                              of_feature * feature_m},
                        hurst, /*step_m=*/0.0);
    dryness_ = dryness_map(terrain, equinox_sun(scene.sun.latitude_deg));
  }
  if (!season) return;
  season_ = std::move(season);
  for (int frame = 1; frame <= scene.season.frames; ++frame)
    frame_days_.push_back(scene::season_days(scene, frame));
  spread_days_ = scene.season.spread_days;
  delay_days_ = delays_days(scene, coarsened(terrain));
  const auto [min, max] =
      std::minmax_element(delay_days_.values().begin(), delay_days_.values().end());
  const double soil_days = max_deviations * spread_days_;
  delays_days_ = {*min - soil_days, *max + soil_days};
}

double Withering::noise(const glm::dvec2& at_m) const {
  if (!scale_free_) return field_.at(at_m / ageing_.age_spread_feature_m);
  constexpr double by_chance = 0.8, by_water = 0.6;  // their squares are 1 together
  return by_chance * scale_free_->at(at_m) + by_water * double{dryness_.sample(at_m.x, at_m.y)};
}

double Withering::at(const glm::dvec2& at_m, int frame) const {
  const auto index = static_cast<std::size_t>(frame - 1);
  if (season_) {
    const double soil = std::clamp(noise(at_m), -max_deviations, max_deviations);
    return season_->weathering_at(frame_days_.at(index) - spread_days_ * soil -
                                  double{delay_days_.sample(at_m.x, at_m.y)});
  }
  const double degree = ageing_.frames.at(index);
  const double field = std::clamp(0.6 * noise(at_m), -1.0, 1.0);
  return std::clamp(degree + amplitude(ageing_, degree) * field, 0.0, 1.0);
}

std::pair<double, double> Withering::range(int frame) const {
  const auto index = static_cast<std::size_t>(frame - 1);
  if (season_) {
    const double from = frame_days_.at(index) - delays_days_.second;
    const double to = frame_days_.at(index) - delays_days_.first;
    auto [min, max] = std::minmax({season_->weathering_at(from), season_->weathering_at(to)});
    for (int day = static_cast<int>(std::ceil(from)); day < to; ++day) {
      min = std::min(min, season_->weathering_at(day));
      max = std::max(max, season_->weathering_at(day));
    }
    return {min, max};
  }
  const double degree = ageing_.frames.at(index);
  const double max = amplitude(ageing_, degree);
  return {std::max(0.0, degree - max), std::min(1.0, degree + max)};
}

}  // namespace wold::place
