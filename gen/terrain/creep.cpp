#include "terrain/creep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace wold::terrain {
namespace {

/// Modified Bessel functions I_0(2 t), I_1(2 t) ..., t > 0, times one unknown factor, down to what
/// is not seen beside the first: by Miller's recurrence I_{k-1} = I_{k+1} + k I_k / t, from beyond
/// where they vanish.
std::vector<double> bessel_functions(double t) {
  constexpr double unseen = 1e-10;
  const auto start = static_cast<std::size_t>(20.0 + 12.0 * std::sqrt(2.0 * t));
  std::vector<double> values(start + 2, 0.0);
  values[start] = 1e-300;
  for (std::size_t k = start; k > 0; --k) {
    values[k - 1] = values[k + 1] + static_cast<double>(k) / t * values[k];
    if (values[k - 1] < 1e200) continue;
    for (double& value : values) value *= 1e-200;
  }
  std::erase_if(values, [&](double value) { return value < unseen * values.front(); });
  return values;
}

/// What a sample gets of one that lies k steps away, from k = 0 on: the heat kernel of a line of
/// samples, exp(-2 t) I_k(2 t), t = length2 / step^2. It solves dz/dt = D laplacian(z) for the
/// central second difference exactly, whatever the step [Lindeberg1990]. On both sides it sums
/// to 1.
std::vector<double> heat_kernel(double t) {
  if (t <= 0.0) return {1.0};
  std::vector<double> weights = bessel_functions(t);
  const double all =
      weights.front() + 2.0 * std::accumulate(weights.begin() + 1, weights.end(), 0.0);
  for (double& weight : weights) weight /= all;
  return weights;
}

/// The line goes on beyond its ends as in a mirror, so that nothing leaves it.
std::size_t mirrored(std::ptrdiff_t i, std::ptrdiff_t samples) {
  const std::ptrdiff_t period = 2 * samples, within = (i % period + period) % period;
  return static_cast<std::size_t>(std::min(within, period - 1 - within));
}

/// Creep from south to north, whole rows at a time. What a sample gets is reckoned from how much
/// others lie above it, so that level ground stays level to the last bit.
void creep_northward(const GroundMap<double>& from_m, const std::vector<double>& kernel,
                     GroundMap<double>& to_m) {
  const auto samples = static_cast<std::size_t>(from_m.samples());
  const auto row_of = [&](std::ptrdiff_t j) {
    return from_m.values().data() + mirrored(j, from_m.samples()) * samples;
  };
  parallel_for(samples, [&](std::size_t row) {
    const auto j = static_cast<std::ptrdiff_t>(row);
    const double* here = row_of(j);
    double* crept = to_m.values().data() + row * samples;
    std::copy_n(here, samples, crept);
    for (std::size_t k = 1; k < kernel.size(); ++k) {
      const double* south = row_of(j - static_cast<std::ptrdiff_t>(k));
      const double* north = row_of(j + static_cast<std::ptrdiff_t>(k));
      for (std::size_t i = 0; i < samples; ++i)
        crept[i] += kernel[k] * ((south[i] - here[i]) + (north[i] - here[i]));
    }
  });
}

void transpose(GroundMap<double>& heights_m) {
  for (int j = 0; j < heights_m.samples(); ++j)
    for (int i = 0; i < j; ++i) std::swap(heights_m.at(i, j), heights_m.at(j, i));
}

}  // namespace

void creep(GroundMap<double>& heights_m, double length2_m2) {
  const auto kernel = heat_kernel(length2_m2 / (heights_m.step_m() * heights_m.step_m()));
  for (int axis = 0; axis < 2; ++axis) {
    const GroundMap<double> before_m = heights_m;
    creep_northward(before_m, kernel, heights_m);
    transpose(heights_m);
  }
}

Heightfield crept(GroundMap<double> heights_m) {
  creep(heights_m, 0.1);
  Heightfield result(heights_m.samples(), heights_m.size_m());
  for (std::size_t k = 0; k < result.values().size(); ++k)
    result.values()[k] = static_cast<float>(heights_m.values()[k]);
  return result;
}

}  // namespace wold::terrain
