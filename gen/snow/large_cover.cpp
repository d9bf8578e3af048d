#include "snow/large_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <system_error>
#include <tuple>

#include "core/elementary.h"
#include "core/error.h"
#include "snow/drifting.h"

namespace wold::snow {
namespace {

constexpr double seconds_per_hour = 3600.0;
constexpr int slide_apron = 16;  ///< samples that snow may slide in a pass

/// How far beyond its border a tile is felt.
int apron(double step_m) {
  return slide_apron + static_cast<int>(std::ceil(farthest_shelter_m / step_m));
}

/// Where a sample or tile lies, row by row.
std::size_t place_of(const glm::ivec2& at, int in_a_row) {
  return static_cast<std::size_t>(at.y) * in_a_row + at.x;
}

void require_number(float height_m, const glm::ivec2& at) {
  if (std::isfinite(height_m)) return;
  throw InputError(fmt::format(
      "the terrain's height in column {} of row {} is {}; expected a finite number of metres", at.x,
      at.y, height_m));
}

/// Values a fraction of the way from `before` to `after`.
std::vector<float> between(const std::vector<float>& before, const std::vector<float>& after,
                           float fraction) {
  std::vector<float> values(before.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = before[i] + fraction * (after[i] - before[i]);
  return values;
}

/// The first `count` values of packs, in the order of the pictures' channels.
std::vector<std::vector<double>*> channels_of(SnowpackField& packs, int count) {
  std::vector<std::vector<double>*> all = {&packs.water_mm, &packs.depth_m, &packs.age,
                                           &packs.liquid_mm, &packs.lacking_mm};
  all.resize(static_cast<std::size_t>(count));
  for (std::vector<double>* values : all) values->resize(packs.water_mm.size(), 0.0);
  return all;
}

}  // namespace

/// What a tile is reckoned on: a square of the ground that holds it and its apron, moved inwards at
/// the ground's border.
struct LargeCover::Window {
  int side = 0;
  glm::ivec2 first = {};       ///< of the ground's samples
  glm::ivec2 tile_first = {};  ///< of the window's samples
  glm::ivec2 tile_count = {};  ///< less than a tile at the ground's far borders

  /// Calls body(sample of the tile, index in the window) for the tile's samples.
  template <class Body>
  void each_of_tile(const Body& body) const {
    for (int y = 0; y < tile_count.y; ++y)
      for (int x = 0; x < tile_count.x; ++x)
        body(glm::ivec2(x, y), place_of(tile_first + glm::ivec2(x, y), side));
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

LargeCover::LargeCover(const scene::SnowCoverPart& part, const LargeGround& ground,
                       WeatherFunction weather, std::filesystem::path folder, Limits limits)
    : cover_(part.cover),
      first_(first_pack(part)),
      is_season_(part.is_season),
      clock_(snow_clock(part.is_season)),
      earlier_s_(part.earlier_h * seconds_per_hour),
      samples_(ground.samples),
      step_m_(ground.step_m),
      weather_(std::move(weather)),
      folder_(std::move(folder)),
      limits_(limits),
      images_(limits.cache_mb) {
  if (samples_ < 2 || !(step_m_ > 0.0))
    throw InputError(
        fmt::format("a ground for snow needs at least 2 samples and a positive step, "
                    "got {} and {} m",
                    samples_, step_m_));
  while (extent(levels_ - 1).size_px.x > limits_.view_samples) ++levels_;
  squares_.resize(static_cast<std::size_t>(levels_));
  write_ground(ground);
}

/// Water, depth and age; in a season what is held and lacking, too.
int LargeCover::channels() const { return is_season_ ? 5 : 3; }

TiledExtent LargeCover::extent_of(int channel_count) const {
  return {glm::ivec2(samples_), channel_count, limits_.tile_samples};
}

TiledExtent LargeCover::extent(int level) const {
  TiledExtent result = extent_of(channels());
  for (int i = 0; i < level; ++i) result = halved(result);
  return result;
}

std::filesystem::path LargeCover::picture(int hour, int level) const {
  return folder_ / fmt::format("hour_{:05}_level_{}.tif", hour, level);
}

void LargeCover::integrate(int hour) {
  constexpr int longest_pass_h = 24;
  if (hours_.contains(hour)) return;
  const auto later = hours_.upper_bound(hour);
  int from = later == hours_.begin() ? -1 : *std::prev(later);
  while (from < hour) {
    const int to = from < 0
                       ? clock_.first_h
                       : std::max(std::min(from + longest_pass_h, hour), bare_until(from, hour));
    remove(to);  // from another time
    pass(from, to);
    from = to;
  }
  const std::set<int> all = hours_;
  for (int other : all)
    if (other != hour && other != hour - clock_.step_h) remove(other);
}

/// The last hour, at most `to_hour`, up to which bare ground stays bare: where nothing lies nothing
/// slides, and a pass may be as long as that.
int LargeCover::bare_until(int from_hour, int to_hour) const {
  if (!bare_hours_.contains(from_hour)) return from_hour;
  const HeightClasses classes(lowest_to_highest_m_);
  for (int hour = from_hour; hour < to_hour; hour += clock_.step_h)
    if (snows(classes.step(weather_during(hour), clock_.step_h, cover_.melt_mm_per_day), classes))
      return hour;
  return to_hour;
}

void LargeCover::remove(int hour) {
  for (int level = 0; level < levels_; ++level) {
    std::error_code ignored;
    std::filesystem::remove(picture(hour, level), ignored);
    images_.forget(picture(hour, level));
  }
  hours_.erase(hour);
  bare_hours_.erase(hour);
}

LargeCover::Window LargeCover::window(const glm::ivec2& tile) const {
  const int side = std::min(samples_, limits_.tile_samples + 2 * apron(step_m_));
  const glm::ivec2 first_of_tile = tile * limits_.tile_samples;
  const glm::ivec2 first =
      glm::clamp(first_of_tile - apron(step_m_), glm::ivec2(0), glm::ivec2(samples_ - side));
  return {side, first, first_of_tile - first,
          glm::min(glm::ivec2(samples_) - first_of_tile, glm::ivec2(limits_.tile_samples))};
}

std::vector<float> LargeCover::read(const std::filesystem::path& path, const Window& window,
                                    int channel_count) const {
  std::vector<float> values(static_cast<std::size_t>(window.side) *
                            static_cast<std::size_t>(window.side * channel_count));
  images_.read(path, window.first, glm::ivec2(window.side), channel_count, values);
  return values;
}

/// Heights and how deep snow can lie, so that neither is asked for again by the hour.
void LargeCover::write_ground(const LargeGround& ground) {
  const glm::ivec2 tiles = extent_of(2).tiles();
  std::vector<float> extremes_m(static_cast<std::size_t>(2 * tiles.x * tiles.y));
  const auto fill = [&](const glm::ivec2& tile, std::span<float> values) {
    const Window around = window(tile);
    Heightfield heights(around.side, (around.side - 1) * step_m_);
    ground.heights(around.first, around.side, heights.values());
    for (int y = 0; y < around.side; ++y)
      for (int x = 0; x < around.side; ++x)
        require_number(heights.at(x, y), around.first + glm::ivec2(x, y));
    const auto [lowest_m, highest_m] = std::ranges::minmax(heights.values());
    extremes_m[2 * place_of(tile, tiles.x)] = lowest_m;
    extremes_m[2 * place_of(tile, tiles.x) + 1] = highest_m;
    const FactorMap max_m = max_depths_m(heights);
    around.each_of_tile([&](const glm::ivec2& at, std::size_t place) {
      const auto value = place_of(at, limits_.tile_samples) * 2;
      values[value] = heights.values()[place];
      values[value + 1] = max_m.values()[place];
    });
  };
  images_.forget(folder_ / "ground.tif");
  write_tiled_image(folder_ / "ground.tif", extent_of(2), limits_.tiles_at_a_time, fill);
  const auto [lowest_m, highest_m] = std::ranges::minmax(extremes_m);
  lowest_to_highest_m_ = {lowest_m, highest_m};
}

/// Heights and how deep snow can lie.
std::pair<Heightfield, FactorMap> LargeCover::ground(const Window& window) const {
  const std::vector<float> values = read(folder_ / "ground.tif", window, 2);
  const double size_m = (window.side - 1) * step_m_;
  std::pair<Heightfield, FactorMap> result(std::piecewise_construct,
                                           std::forward_as_tuple(window.side, size_m),
                                           std::forward_as_tuple(window.side, size_m));
  for (std::size_t i = 0; 2 * i < values.size(); ++i) {
    result.first.values()[i] = values[2 * i];
    result.second.values()[i] = values[2 * i + 1];
  }
  return result;
}

/// The weights of a wind, and their mean over the whole ground.
void LargeCover::write_drift(int heading_deg) {
  if (heading_deg < 0 || drifts_.contains(heading_deg)) return;
  const glm::ivec2 tiles = extent_of(1).tiles();
  std::vector<double> sums(static_cast<std::size_t>(tiles.x * tiles.y), 0.0);
  const auto fill = [&](const glm::ivec2& tile, std::span<float> values) {
    const Window around = window(tile);
    const FactorMap weights = drift_weights(ground(around).first, heading_deg, cover_.drifting);
    double& sum = sums[place_of(tile, tiles.x)];
    around.each_of_tile([&](const glm::ivec2& at, std::size_t place) {
      const float weight = weights.values()[place];
      values[place_of(at, limits_.tile_samples)] = weight;
      sum += weight;
    });
  };
  const std::filesystem::path path = folder_ / fmt::format("drift_{:03}.tif", heading_deg);
  images_.forget(path);
  write_tiled_image(path, extent_of(1), limits_.tiles_at_a_time, fill);
  const double places = static_cast<double>(samples_) * samples_;
  drifts_[heading_deg] = {path, std::accumulate(sums.begin(), sums.end(), 0.0) / places};
}

/// In the middle of the clock's step that begins at an hour.
WeatherMoment LargeCover::weather_during(int hour) const {
  return weather_((hour + 0.5 * clock_.step_h) * seconds_per_hour - earlier_s_);
}

/// Brings all tiles from one whole hour to a later one; from -1, the snow that lies at first.
void LargeCover::pass(int from_hour, int to_hour) {
  std::vector<WeatherMoment> weather;
  for (int hour = from_hour < 0 ? to_hour : from_hour; hour < to_hour; hour += clock_.step_h)
    weather.push_back(weather_during(hour));
  for (const WeatherMoment& hour : weather) write_drift(drift_heading_deg(hour, cover_.drifting));
  const glm::ivec2 tiles = extent_of(1).tiles();
  std::vector<char> white(static_cast<std::size_t>(tiles.x * tiles.y));
  const auto integrate_tile = [&](const glm::ivec2& tile, std::span<float> values) {
    const Window around = window(tile);
    SnowpackField lying = after(around, packs(around, from_hour), weather);
    white[place_of(tile, tiles.x)] = is_bare(lying) ? 0 : 1;
    const std::vector<std::vector<double>*> of_pack = channels_of(lying, channels());
    around.each_of_tile([&](const glm::ivec2& at, std::size_t place) {
      auto value = place_of(at, limits_.tile_samples) * of_pack.size();
      for (const std::vector<double>* channel : of_pack)
        values[value++] = static_cast<float>((*channel)[place]);
    });
  };
  write_tiled_image(picture(to_hour, 0), extent(0), limits_.tiles_at_a_time, integrate_tile);
  for (int level = 1; level < levels_; ++level)
    write_halved(images_, picture(to_hour, level - 1), extent(level - 1), picture(to_hour, level),
                 limits_.tiles_at_a_time);
  hours_.insert(to_hour);
  if (std::ranges::count(white, 1) == 0) bare_hours_.insert(to_hour);
}

/// The packs of a window after hours of weather.
SnowpackField LargeCover::after(const Window& window, SnowpackField packs,
                                const std::vector<WeatherMoment>& hours) const {
  auto [heights, max_m] = ground(window);
  const HeightClasses classes(heights.values());
  const GroundRise rise = is_season_ ? GroundRise(heights) : GroundRise();
  const SnowSlide slide(std::move(heights), std::move(max_m));
  slide.settle(packs);
  std::map<int, std::vector<float>> drifts;
  for (const WeatherMoment& hour : hours) {
    const FieldStep step = classes.step(hour, clock_.step_h, cover_.melt_mm_per_day);
    if (!snows(step, classes) && is_bare(packs)) continue;
    const int heading_deg = drift_heading_deg(hour, cover_.drifting);
    std::vector<float>& factor = drifts[heading_deg];
    if (factor.empty()) factor = drift(window, heading_deg);
    advance(packs, classes, step, factor, rise);
    slide.settle(packs);
  }
  return packs;
}

std::vector<float> LargeCover::drift(const Window& window, int heading_deg) const {
  const std::size_t places = static_cast<std::size_t>(window.side) * window.side;
  if (heading_deg < 0) return std::vector<float>(places, 1.0F);
  const Drift& drift = drifts_.at(heading_deg);
  std::vector<float> factor = read(drift.weights, window, 1);
  for (float& value : factor) value = static_cast<float>(value / drift.mean);
  return factor;
}

SnowpackField LargeCover::packs(const Window& window, int hour) const {
  const std::size_t places = static_cast<std::size_t>(window.side) * window.side;
  if (hour < 0) return {places, first_};
  const std::vector<float> values = read(picture(hour, 0), window, channels());
  SnowpackField packs(places, {});
  auto value = values.begin();
  const std::vector<std::vector<double>*> of_pack = channels_of(packs, channels());
  for (std::size_t i = 0; i < places; ++i)
    for (std::vector<double>* channel : of_pack) (*channel)[i] = *value++;
  return packs;
}

std::vector<CoverLevel> LargeCover::view(double time_s, const glm::dvec2& eye_m) {
  const double hours =
      std::max((time_s + earlier_s_) / seconds_per_hour, static_cast<double>(clock_.first_h));
  integrate(step_at(hours));
  integrate(step_at(hours) + clock_.step_h);
  std::vector<CoverLevel> levels(static_cast<std::size_t>(levels_));
  parallel_for(levels.size(), [&](std::size_t level) {
    levels[level] = level_view(static_cast<int>(level), hours, eye_m);
  });
  return levels;
}

/// The clock's latest hour.
int LargeCover::step_at(double hours) const {
  const int steps = static_cast<int>((hours - clock_.first_h) / clock_.step_h);
  return clock_.first_h + steps * clock_.step_h;
}

CoverLevel LargeCover::level_view(int level, double hours, const glm::dvec2& eye_m) {
  constexpr int snap = 8;  // samples that the camera moves before a square does
  const int samples = extent(level).size_px.x;
  const double scale = math::exp2(1.0 * level);
  CoverLevel result;
  result.side = std::min(limits_.view_samples, samples);
  result.step_m = step_m_ * scale;
  const glm::dvec2 on_ground_m = glm::clamp(eye_m, 0.0, (samples_ - 1) * step_m_);
  const glm::ivec2 middle =
      glm::ivec2(glm::floor(on_ground_m / (result.step_m * snap) + 0.5)) * snap -
      limits_.view_samples / 2;
  const glm::ivec2 first = glm::clamp(middle, glm::ivec2(0), glm::ivec2(samples - result.side));
  result.first_m = (glm::dvec2(first) * scale + 0.5 * (scale - 1.0)) * step_m_;

  const int hour = step_at(hours);
  const auto fraction = static_cast<float>((hours - hour) / clock_.step_h);
  const CoverLevel& before = square(level, hour, first, result.side);
  const CoverLevel& after = square(level, hour + clock_.step_h, first, result.side);
  result.depth_m = between(before.depth_m, after.depth_m, fraction);
  result.white = between(before.white, after.white, fraction);
  result.albedo = between(before.albedo, after.albedo, fraction);
  return result;
}

const CoverLevel& LargeCover::square(int level, int hour, const glm::ivec2& first, int side) {
  const int step = (hour - clock_.first_h) / clock_.step_h;
  Square& kept = squares_[static_cast<std::size_t>(level)][static_cast<std::size_t>(step % 2)];
  if (kept.hour == hour && kept.first == first) return kept.lying;
  const std::size_t places = static_cast<std::size_t>(side) * side;
  const auto of_pack = static_cast<std::size_t>(channels());
  std::vector<float> values(places * of_pack);
  images_.read(picture(hour, level), first, glm::ivec2(side), channels(), values);
  kept = {hour, first, {}};
  for (std::size_t i = 0; i < places; ++i) {
    kept.lying.white.push_back(static_cast<float>(cover_fraction(values[i * of_pack])));
    kept.lying.depth_m.push_back(values[i * of_pack + 1]);
    kept.lying.albedo.push_back(static_cast<float>(visible_albedo(values[i * of_pack + 2])));
  }
  return kept.lying;
}

}  // namespace wold::snow
