#include "terrain/finer_relief.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/elementary.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// Of gradient noise whose power lies in waves of one to two lengths: its features, in the longest.
constexpr double feature_of_waves = 0.6;
/// The shortest waves, metres, that creeping soil leaves.
constexpr double min_wave_m = 0.7;

/// Noise of deviation 1 as a mean of places along a way, its gradient per unit: `along`, in
/// features, at most 0.8 long.
NoiseSlope carried_noise(const glm::dvec2& at, const glm::dvec2& along, std::uint64_t key) {
  NoiseSlope sum;
  for (int tap = -1; tap <= 1; ++tap) {
    const NoiseSlope noise = gradient_noise_slope(at + 1.0 * tap * along, key);
    sum.value += noise.value;
    sum.gradient += noise.gradient;
  }
  // What the mean of the three keeps of the variance: a fit, true to 1 %.
  const double length2 = glm::dot(along, along);
  const double kept = 1.0 / (1.0 + (6.2685 - 3.6166 * length2) * length2);
  const double scale = 1.0 / (3.0 * gradient_noise_deviation * std::sqrt(kept));
  return {sum.value * scale, sum.gradient * scale};
}

GroundMap<glm::vec2> gradients(const GroundMap<double>& heights_m) {
  GroundMap<glm::vec2> map(heights_m.samples(), heights_m.square());
  const int last = heights_m.samples() - 1;
  for (int j = 0; j <= last; ++j)
    for (int i = 0; i <= last; ++i) {
      const int west = std::max(i - 1, 0), east = std::min(i + 1, last);
      const int south = std::max(j - 1, 0), north = std::min(j + 1, last);
      const double step_m = heights_m.step_m();
      map.at(i, j) =
          glm::vec2((heights_m.at(east, j) - heights_m.at(west, j)) / ((east - west) * step_m),
                    (heights_m.at(i, north) - heights_m.at(i, south)) / ((north - south) * step_m));
    }
  return map;
}

/// Octaves up to the last that is shown.
std::size_t shown_octaves(const FinerRelief::Weights& weights) {
  std::size_t count = weights.size();
  while (count > 0 && weights[count - 1] <= 0.0) --count;
  return count;
}

/// Of waves' heights, where what there is within some length counts with a Gaussian's weight.
double left_by_smoothing(double wave_m, double length2_m2) {
  const double turns_per_m = 2.0 * std::numbers::pi / wave_m;
  return math::exp(-turns_per_m * turns_per_m * length2_m2);
}

/// Of waves' heights, by soil that creeps as in crept().
double left_by_creep(double wave_m) { return left_by_smoothing(wave_m, 0.1); }

/// Of waves' heights, what snow on them hides: those that are shorter than some times its depth.
double hidden_by_snow(double wave_m, double depth_m) {
  constexpr double smoothed = 0.6;  // squares of the depth
  return 1.0 - left_by_smoothing(wave_m, smoothed * depth_m * depth_m);
}

}  // namespace

FinerRelief::FinerRelief(const GroundMap<double>& heights_m, Roughness roughness, double hurst,
                         std::uint64_t seed)
    : hurst_(hurst), roughness_(std::move(roughness)), gradient_(gradients(heights_m)) {
  std::uint64_t index = 0;
  for (double wave_m = 2.0 * cell_m(heights_m); wave_m > min_wave_m; wave_m /= 2.0, ++index) {
    const auto bits = [&](const char* purpose) {
      return random_bits({seed, key_of("finer relief"), index, key_of(purpose)});
    };
    const auto unit = [&](const char* purpose) {
      return static_cast<double>(bits(purpose) >> 11) * 0x1.0p-53;
    };
    octaves_.push_back(
        {feature_of_waves * wave_m, bits("field"), glm::dvec2(unit("east"), unit("north"))});
  }
}

FinerRelief::Weights FinerRelief::shown_at(double step_m) const {
  constexpr double all = 0.3, none = 0.9;
  Weights weights;
  for (const Octave& octave : octaves_)
    weights.push_back(1.0 - glm::smoothstep(all, none, step_m / octave.feature_m));
  return weights;
}

FinerRelief::Weights FinerRelief::shown_below(double coarse_step_m, double step_m) const {
  const Weights coarse = shown_at(coarse_step_m);
  Weights weights = shown_at(step_m);
  for (std::size_t k = 0; k < weights.size(); ++k)
    weights[k] = std::max(weights[k] - coarse[k], 0.0) *
                 left_by_creep(octaves_[k].feature_m / feature_of_waves);
  return weights;
}

FinerRelief::State FinerRelief::first_state(const glm::dvec2& at_m) const {
  return {{},
          glm::dvec2(gradient_.sample(at_m.x, at_m.y)),
          double{roughness_.deviation_m.sample(at_m.x, at_m.y)},
          double{roughness_.hurst.sample(at_m.x, at_m.y)} - hurst_};
}

void FinerRelief::add_octave(State& state, const glm::dvec2& at_m, std::size_t k,
                             double weight) const {
  constexpr double carry = 0.65;  // features, at most
  const Octave& octave = octaves_[k];
  // Ground no steeper than the octave itself has no fall line for it.
  const double own_slope = 2.0 * state.deviation_m / octave.feature_m + 1e-9;
  const glm::dvec2 along = state.ascent * (carry / (glm::length(state.ascent) + own_slope));
  const NoiseSlope noise = carried_noise(at_m / octave.feature_m + octave.shift, along, octave.key);
  const glm::dvec2 gradient = noise.gradient * (state.deviation_m / octave.feature_m);
  state.ascent += gradient;
  state.shown.height_m += weight * state.deviation_m * noise.value;
  state.shown.gradient += weight * gradient;
  state.shown.deviation_m += weight * weight * state.deviation_m * state.deviation_m;
  state.excess *= 0.5;
  state.deviation_m *= math::exp2(-(hurst_ + state.excess));
}

void FinerRelief::add_octaves(State& state, const glm::dvec2& at_m, const Octaves& octaves,
                              const Weights& weights, const SnowDepth& snow_m) const {
  const double depth_m = snow_m ? snow_m(at_m) : 0.0;
  for (std::size_t k = octaves.first; k < octaves.last; ++k) {
    const double wave_m = octaves_[k].feature_m / feature_of_waves;
    add_octave(state, at_m, k, weights[k] * (snow_m ? hidden_by_snow(wave_m, depth_m) : 1.0));
  }
}

FinerRelief::Bump FinerRelief::at(const glm::dvec2& at_m, const Weights& weights) const {
  State state = first_state(at_m);
  add_octaves(state, at_m, {0, shown_octaves(weights)}, weights, {});
  state.shown.deviation_m = std::sqrt(state.shown.deviation_m);
  return state.shown;
}

FinerRelief::State FinerRelief::States::at(const glm::dvec2& at_m) const {
  const glm::dvec4 slope(slopes.sample(at_m.x, at_m.y));
  const glm::dvec4 height(heights.sample(at_m.x, at_m.y));
  return {{height.x, glm::dvec2(slope), height.y}, {slope.z, slope.w}, height.z, height.w};
}

template <class Visit>
void FinerRelief::visit_states(const GroundGrid& grid, const Weights& weights, std::size_t count,
                               const RowParts& parts, const SnowDepth& snow_m,
                               const Visit& visit) const {
  constexpr int apart = 4;
  constexpr double min_feature_steps = 4.0 * apart;
  std::size_t large = 0;
  while (large < count && octaves_[large].feature_m >= min_feature_steps * grid.step_m()) ++large;
  std::optional<States> coarse;
  if (large > 0) {
    const int samples = (grid.samples + apart - 2) / apart + 1;
    const Square square{grid.square.corner_m, (samples - 1) * apart * grid.step_m()};
    coarse = states({square, samples}, weights, large, snow_m);
  }
  parallel_for(static_cast<std::size_t>(grid.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(parts[row], [&](int i) {
      const glm::dvec2 at_m = grid.square.corner_m + glm::dvec2(i, j) * grid.step_m();
      State state = coarse ? coarse->at(at_m) : first_state(at_m);
      add_octaves(state, at_m, {large, count}, weights, snow_m);
      visit(i, j, state);
    });
  });
}

FinerRelief::States FinerRelief::states(const GroundGrid& grid, const Weights& weights,
                                        std::size_t count, const SnowDepth& snow_m) const {
  States states{GroundMap<glm::vec4>(grid.samples, grid.square),
                GroundMap<glm::vec4>(grid.samples, grid.square)};
  visit_states(grid, weights, count, whole_rows(grid.samples), snow_m,
               [&](int i, int j, const State& state) {
                 states.slopes.at(i, j) =
                     glm::vec4(glm::vec2(state.shown.gradient), glm::vec2(state.ascent));
                 states.heights.at(i, j) =
                     glm::vec4(glm::dvec4(state.shown.height_m, state.shown.deviation_m,
                                          state.deviation_m, state.excess));
               });
  return states;
}

GroundMap<FinerRelief::Bump> FinerRelief::on_grid(const GroundGrid& grid, const Weights& weights,
                                                  const RowParts& parts) const {
  GroundMap<Bump> bumps(grid.samples, grid.square);
  visit_states(grid, weights, shown_octaves(weights), parts, /*snow_m=*/{},
               [&](int i, int j, const State& state) {
                 bumps.at(i, j) = state.shown;
                 bumps.at(i, j).deviation_m = std::sqrt(state.shown.deviation_m);
               });
  return bumps;
}

GroundMap<glm::vec2> FinerRelief::hidden_by(const SnowDepth& snow_m, const GroundGrid& grid,
                                            const Weights& weights, const RowParts& parts) const {
  GroundMap<glm::vec2> gradient(grid.samples, grid.square);
  visit_states(grid, weights, shown_octaves(weights), parts, snow_m,
               [&](int i, int j, const State& state) {
                 gradient.at(i, j) = glm::vec2(state.shown.gradient);
               });
  return gradient;
}

}  // namespace wold::terrain
