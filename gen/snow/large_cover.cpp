#include "snow/large_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <system_error>

#include "core/error.h"
#include "snow/drifting.h"

namespace wold::snow {
namespace {

constexpr double seconds_per_hour = 3600.0;
constexpr int channels = 3;      ///< water, depth, age
constexpr int view_side = 64;    ///< samples of a level
constexpr int slide_apron = 16;  ///< samples that snow may slide in a pass

/// How far beyond its border a tile is felt.
int apron(const LargeGround& ground) {
  return slide_apron + static_cast<int>(std::ceil(farthest_shelter_m / ground.step_m));
}

/// What a tile is reckoned on: a square of the ground that holds it and its apron, moved inwards at
/// the ground's border.
int window_side(const LargeGround& ground, int tile_samples) {
  return std::min(ground.samples, tile_samples + 2 * apron(ground));
}

void require_number(float height_m, const glm::ivec2& at) {
  if (std::isfinite(height_m)) return;
  throw InputError(fmt::format(
      "the terrain's height in column {} of row {} is {}; expected a finite number of metres", at.x,
      at.y, height_m));
}

}  // namespace

struct LargeCover::Window {
  glm::ivec2 first = {};       ///< of the ground's samples
  glm::ivec2 tile_first = {};  ///< of the window's samples
  glm::ivec2 tile_count = {};  ///< less than a tile at the ground's far borders
  Heightfield heights;

  /// Calls body(sample of the tile, index in the window) for the tile's samples.
  template <class Body>
  void each_of_tile(const Body& body) const {
    for (int y = 0; y < tile_count.y; ++y)
      for (int x = 0; x < tile_count.x; ++x)
        body(glm::ivec2(x, y),
             static_cast<std::size_t>((tile_first.y + y) * heights.samples() + tile_first.x + x));
  }
};

LargeGround large_ground(const Heightfield& terrain) {
  return {terrain.samples(), terrain.step_m(),
          [&terrain](const glm::ivec2& first, int side, std::span<float> heights_m) {
            for (int y = 0; y < side; ++y)
              std::copy_n(&terrain.at(first.x, first.y + y), side,
                          heights_m.begin() + static_cast<std::ptrdiff_t>(y) * side);
          }};
}

LargeCover::LargeCover(const scene::Scene& scene, LargeGround ground, WeatherFunction weather,
                       std::filesystem::path folder, Limits limits)
    : cover_(scene.snow_cover),
      earlier_s_(scene.weather.earlier_h * seconds_per_hour),
      ground_(std::move(ground)),
      weather_(std::move(weather)),
      folder_(std::move(folder)),
      limits_(limits),
      images_(limits.cache_mb) {
  if (ground_.samples < 2 || !(ground_.step_m > 0.0))
    throw InputError(
        fmt::format("a ground for snow needs at least 2 samples and a positive step, "
                    "got {} and {} m",
                    ground_.samples, ground_.step_m));
  while (extent(levels_ - 1).size_px.x > view_side) ++levels_;
}

TiledExtent LargeCover::extent(int level) const {
  TiledExtent result{glm::ivec2(ground_.samples), channels, limits_.tile_samples};
  for (int i = 0; i < level; ++i) result = halved(result);
  return result;
}

std::filesystem::path LargeCover::picture(int hour, int level) const {
  return folder_ / fmt::format("hour_{:05}_level_{}.tif", hour, level);
}

void LargeCover::reckon(int hour) {
  constexpr int longest_pass_h = 24;
  if (hours_.contains(hour)) return;
  const auto later = hours_.upper_bound(hour);
  int from = later == hours_.begin() ? -1 : *std::prev(later);
  while (from < hour) {
    const int to = from < 0 ? 0 : std::min(from + longest_pass_h, hour);
    remove(to);  // from another time
    pass(from, to);
    from = to;
  }
  const std::set<int> all = hours_;
  for (int other : all)
    if (other != hour && other != hour - 1) remove(other);
}

void LargeCover::remove(int hour) {
  for (int level = 0; level < levels_; ++level) {
    std::error_code ignored;
    std::filesystem::remove(picture(hour, level), ignored);
    images_.forget(picture(hour, level));
  }
  hours_.erase(hour);
}

/// Brings all tiles from one whole hour to a later one; from -1, the snow that lies at first.
void LargeCover::pass(int from_hour, int to_hour) {
  std::vector<WeatherMoment> weather;
  for (int hour = std::max(from_hour, 0); hour < to_hour; ++hour)
    weather.push_back(weather_((hour + 0.5) * seconds_per_hour - earlier_s_));
  for (const WeatherMoment& hour : weather) know_mean_drift(drift_heading_deg(hour, cover_.drifting));
  const auto reckon_tile = [&](const glm::ivec2& tile, std::span<float> values) {
    const Window around = window(tile);
    const SnowSlide slide(around.heights);
    const HeightClasses classes(around.heights.values());
    SnowpackField lying = packs(around, from_hour);
    std::map<int, FactorMap> drifts;
    slide.settle(lying);
    for (const WeatherMoment& hour : weather) {
      const int heading_deg = drift_heading_deg(hour, cover_.drifting);
      FactorMap& factor = drifts[heading_deg];
      if (factor.samples() == 0) factor = drift(around, heading_deg);
      advance(lying, classes, classes.steps(hour, 1.0, cover_.melt_mm_per_day), factor.values());
      slide.settle(lying);
    }
    around.each_of_tile([&](const glm::ivec2& at, std::size_t i) {
      float* const value =
          values.data() +
          static_cast<std::ptrdiff_t>(at.y * limits_.tile_samples + at.x) * channels;
      value[0] = static_cast<float>(lying.water_mm[i]);
      value[1] = static_cast<float>(lying.depth_m[i]);
      value[2] = static_cast<float>(lying.age[i]);
    });
  };
  write_tiled_image(picture(to_hour, 0), extent(0), limits_.tiles_at_a_time, reckon_tile);
  for (int level = 1; level < levels_; ++level)
    write_halved(images_, picture(to_hour, level - 1), extent(level - 1), picture(to_hour, level),
                 limits_.tiles_at_a_time);
  hours_.insert(to_hour);
}

LargeCover::Window LargeCover::window(const glm::ivec2& tile) const {
  const int side = window_side(ground_, limits_.tile_samples);
  const glm::ivec2 first_of_tile = tile * limits_.tile_samples;
  const glm::ivec2 first =
      glm::clamp(first_of_tile - apron(ground_), glm::ivec2(0), glm::ivec2(ground_.samples - side));
  Window result{
      first, first_of_tile - first,
      glm::min(glm::ivec2(ground_.samples) - first_of_tile, glm::ivec2(limits_.tile_samples)),
      Heightfield(side, (side - 1) * ground_.step_m)};
  ground_.heights(first, side, result.heights.values());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      require_number(result.heights.at(x, y), first + glm::ivec2(x, y));
  return result;
}

SnowpackField LargeCover::packs(const Window& window, int hour) const {
  const std::size_t places = window.heights.values().size();
  if (hour < 0) return {places, fresh_pack(cover_.initial_mm)};
  std::vector<float> values(places * channels);
  images_.read(picture(hour, 0), window.first, glm::ivec2(window.heights.samples()), channels,
               values);
  SnowpackField packs(places, {});
  for (std::size_t i = 0; i < places; ++i) {
    packs.water_mm[i] = values[i * channels];
    packs.depth_m[i] = values[i * channels + 1];
    packs.age[i] = values[i * channels + 2];
  }
  return packs;
}

void LargeCover::know_mean_drift(int heading_deg) {
  if (heading_deg < 0 || mean_drifts_.contains(heading_deg)) return;
  const glm::ivec2 tiles = extent(0).tiles();
  std::vector<double> sums(static_cast<std::size_t>(tiles.x * tiles.y), 0.0);
  parallel_for(sums.size(), [&](std::size_t i) {
    const Window around = window({static_cast<int>(i) % tiles.x, static_cast<int>(i) / tiles.x});
    const FactorMap weights = drift_weights(around.heights, heading_deg, cover_.drifting);
    around.each_of_tile(
        [&](const glm::ivec2&, std::size_t place) { sums[i] += weights.values()[place]; });
  });
  const double places = static_cast<double>(ground_.samples) * ground_.samples;
  mean_drifts_[heading_deg] = std::accumulate(sums.begin(), sums.end(), 0.0) / places;
}

FactorMap LargeCover::drift(const Window& window, int heading_deg) const {
  if (heading_deg < 0) return {window.heights.samples(), window.heights.size_m(), 1.0F};
  FactorMap factor = drift_weights(window.heights, heading_deg, cover_.drifting);
  const double mean = mean_drifts_.at(heading_deg);
  for (float& value : factor.values()) value = static_cast<float>(value / mean);
  return factor;
}

std::vector<CoverLevel> LargeCover::view(double time_s, const glm::dvec2& eye_m) {
  const double hours = std::max(time_s + earlier_s_, 0.0) / seconds_per_hour;
  const int hour = static_cast<int>(hours);
  reckon(hour);
  reckon(hour + 1);
  std::vector<CoverLevel> levels(static_cast<std::size_t>(levels_));
  for (int level = 0; level < levels_; ++level)
    levels[static_cast<std::size_t>(level)] = level_view(level, hours, eye_m);
  return levels;
}

CoverLevel LargeCover::level_view(int level, double hours, const glm::dvec2& eye_m) {
  constexpr int snap = 8;  // samples that the camera moves before a square does
  const int samples = extent(level).size_px.x;
  const double scale = std::exp2(level);
  CoverLevel result;
  result.side = std::min(view_side, samples);
  result.step_m = ground_.step_m * scale;
  const glm::ivec2 middle =
      glm::ivec2(glm::floor(eye_m / (result.step_m * snap) + 0.5)) * snap - view_side / 2;
  const glm::ivec2 first = glm::clamp(middle, glm::ivec2(0), glm::ivec2(samples - result.side));
  result.first_m = (glm::dvec2(first) * scale + 0.5 * (scale - 1.0)) * ground_.step_m;

  const int hour = static_cast<int>(hours);
  const auto share = static_cast<float>(hours - hour);
  const std::vector<float>& before = square(level, hour, first, result.side);
  const std::vector<float>& after = square(level, hour + 1, first, result.side);
  const auto places = static_cast<std::size_t>(result.side * result.side);
  result.depth_m.resize(places);
  result.white.resize(places);
  result.albedo.resize(places);
  for (std::size_t i = 0; i < places; ++i) {
    const auto between = [&](std::size_t channel) {
      const std::size_t k = i * channels + channel;
      return before[k] + share * (after[k] - before[k]);
    };
    result.white[i] = static_cast<float>(cover_share(between(0)));
    result.depth_m[i] = between(1);
    result.albedo[i] = static_cast<float>(visible_albedo(between(2)));
  }
  return result;
}

const std::vector<float>& LargeCover::square(int level, int hour, const glm::ivec2& first,
                                             int side) {
  Square& kept = squares_[{level, hour % 2}];
  if (kept.hour != hour || kept.first != first) {
    kept.values.resize(static_cast<std::size_t>(side * side) * channels);
    images_.read(picture(hour, level), first, glm::ivec2(side), channels, kept.values);
    kept.hour = hour;
    kept.first = first;
  }
  return kept.values;
}

}  // namespace wold::snow
