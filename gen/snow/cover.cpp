#include "snow/cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/statistics.h"
#include "snow/drifting.h"
#include "snow/paper_white.h"

namespace wold::snow {
namespace {

constexpr double seconds_per_hour = 3600.0;

void require_numbers(const Heightfield& terrain) {
  const std::vector<float>& heights = terrain.values();
  const auto bad = std::ranges::find_if_not(heights, [](float z) { return std::isfinite(z); });
  if (bad == heights.end()) return;
  const auto place = bad - heights.begin();
  throw InputError(fmt::format(
      "the terrain's height in column {} of row {} is {}; expected a finite number of metres",
      place % terrain.samples(), place / terrain.samples(), *bad));
}

/// The terrain with as many samples as snow is reckoned for.
Heightfield coarsened(const Heightfield& terrain, int max_samples) {
  require_numbers(terrain);
  if (terrain.samples() <= max_samples) return terrain;
  Heightfield result(max_samples, terrain.size_m());
  for (int j = 0; j < max_samples; ++j)
    for (int i = 0; i < max_samples; ++i)
      result.at(i, j) = terrain.sample(i * result.step_m(), j * result.step_m());
  return result;
}

/// An hour, or so short that a short film is followed closely.
double film_step(double film_s) {
  constexpr double steps = 24.0;
  return film_s > 0.0 ? std::min(film_s / steps, seconds_per_hour) : seconds_per_hour;
}

template <class Value>
FactorMap map_of(const Heightfield& terrain, const Value& value) {
  FactorMap map(terrain.samples(), terrain.size_m());
  parallel_for_blocks(map.values().size(),
                      [&](std::size_t i) { map.values()[i] = static_cast<float>(value(i)); });
  return map;
}

}  // namespace

SnowClock snow_clock(bool is_season) {
  if (!is_season) return {};
  return {snowpack::snow_day_h, snowpack::snow_step_h};
}

Snowpack first_pack(const scene::SnowCoverPart& part) {
  const snowpack::SnowState snow = snowpack::lain_snow(part.cover.initial_mm);
  return {snow.water_mm, snow.depth_m, snow.age};
}

SnowGround::SnowGround(const scene::SnowCoverPart& part, const Heightfield& terrain,
                       WeatherFunction weather, int max_samples)
    : cover_(part.cover),
      seed_(part.seed),
      weather_(std::move(weather)),
      first_(first_pack(part)),
      terrain_(coarsened(terrain, max_samples)),
      mean_height_m_(mean(terrain_.values())),
      earlier_s_(part.earlier_h * seconds_per_hour),
      earlier_steps_(static_cast<std::size_t>(std::ceil(part.earlier_h))),
      film_step_s_(film_step(part.film_s)),
      classes_(terrain_.values()) {
  if (part.is_season) {
    clock_ = snow_clock(part.is_season);
    rise_ = GroundRise(terrain_);
  }
  if (cover_.cover == scene::CoverModel::depth) slide_.emplace(terrain_);
  progress_ = beginning();
}

SnowGround::Progress SnowGround::beginning() const {
  Progress progress{0, {terrain_.values().size(), slide_ ? first_ : Snowpack{}}, cover_.initial_mm};
  if (slide_) slide_->settle(progress.packs);
  return progress;
}

double SnowGround::step_start_s(std::size_t step) const {
  if (clock_)
    return (clock_->first_h + clock_->step_h * static_cast<double>(step)) * seconds_per_hour -
           earlier_s_;
  if (step < earlier_steps_)
    return earlier_s_ * (static_cast<double>(step) / static_cast<double>(earlier_steps_) - 1.0);
  return static_cast<double>(step - earlier_steps_) * film_step_s_;
}

SnowGround::State SnowGround::at(double time_s) const {
  const std::lock_guard lock(mutex_);
  if (time_s < step_start_s(progress_.steps)) progress_ = beginning();
  while (step_start_s(progress_.steps + 1) <= time_s) {
    take_step(progress_, step_start_s(progress_.steps), step_start_s(progress_.steps + 1));
    ++progress_.steps;
  }
  const double start_s = step_start_s(progress_.steps);
  Progress now = progress_;
  if (time_s > start_s) take_step(now, start_s, time_s);
  const SnowpackField& packs = now.packs;
  return {map_of(terrain_, [&](std::size_t i) { return packs.depth_m[i]; }),
          map_of(terrain_, [&](std::size_t i) { return packs.water_mm[i]; }),
          map_of(terrain_, [&](std::size_t i) { return visible_albedo(packs.age[i]); }),
          now.fallen_mm};
}

void SnowGround::take_step(Progress& progress, double start_s, double end_s) const {
  const double hours = (end_s - start_s) / seconds_per_hour;
  const WeatherMoment weather = weather_(0.5 * (start_s + end_s));
  const FieldStep step = classes_.step(weather, hours, cover_.melt_mm_per_day);
  progress.fallen_mm += snow_mm_h(weather, mean_height_m_) * hours;
  if (!slide_ || (!snows(step, classes_) && is_bare(progress.packs))) return;
  advance(progress.packs, classes_, step, drift_of(weather).values(), rise_);
  slide_->settle(progress.packs);
}

const FactorMap& SnowGround::drift_of(const WeatherMoment& weather) const {
  const int heading_deg = drift_heading_deg(weather, cover_.drifting);
  const auto known = drifts_.find(heading_deg);
  if (known != drifts_.end()) return known->second;
  FactorMap drift = heading_deg >= 0 ? drift_factor(terrain_, heading_deg, cover_.drifting)
                                     : FactorMap(terrain_.samples(), terrain_.size_m(), 1.0F);
  return drifts_.emplace(heading_deg, std::move(drift)).first->second;
}

FactorMap SnowGround::white(const State& state, int samples) const {
  if (cover_.cover == scene::CoverModel::none) return {samples, terrain_.size_m(), 0.0F};
  if (cover_.cover == scene::CoverModel::paper) {
    const double gamma = std::min(state.fallen_mm / cover_.white_after_mm, 1.0);
    return paper_white(terrain_.size_m(), gamma, samples, seed_);
  }
  const FactorMap fractions =
      map_of(terrain_, [&](std::size_t i) { return cover_fraction(state.water_mm.values()[i]); });
  const std::lock_guard lock(mutex_);
  if (!patches_ || patches_->samples() != samples)
    patches_.emplace(terrain_, samples, cover_.feature_m, seed_);
  return patches_->white_map(fractions);
}

}  // namespace wold::snow
