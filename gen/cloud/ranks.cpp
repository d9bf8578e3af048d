#include "cloud/ranks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace wold::cloud {
namespace {

struct Pixel {
  float value;
  float around;  ///< mean of the surroundings
  std::uint32_t index;
};

/// Running mean of 2 radius + 1 values along a closed line of `count` values, `stride` apart.
void mean_along(std::vector<float>& values, std::size_t first, int count, std::size_t stride,
                int radius) {
  const auto value = [&](int i) -> float& {
    const int rest = i % count;
    return values[first + static_cast<std::size_t>(rest < 0 ? rest + count : rest) * stride];
  };
  std::vector<float> mean(static_cast<std::size_t>(count));
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) sum += value(i);
  for (int i = 0; i < count; ++i) {
    mean[static_cast<std::size_t>(i)] = static_cast<float>(sum / (2 * radius + 1));
    sum += value(i + radius + 1) - value(i - radius);
  }
  for (int i = 0; i < count; ++i) value(i) = mean[static_cast<std::size_t>(i)];
}

/// Box filtered twice, which has no corners to show.
std::vector<float> surroundings(const PeriodicMap<float>& field) {
  const int radius = std::max(1, std::min(field.width(), field.height()) / 16);
  const auto width = static_cast<std::size_t>(field.width());
  std::vector<float> mean = field.values();
  for (int pass = 0; pass < 2; ++pass) {
    for (int y = 0; y < field.height(); ++y)
      mean_along(mean, static_cast<std::size_t>(y) * width, field.width(), 1, radius);
    for (std::size_t x = 0; x < width; ++x) mean_along(mean, x, field.height(), width, radius);
  }
  return mean;
}

/// All pixels, field after field.
std::vector<Pixel> pixels_of(const std::vector<PeriodicMap<float>>& fields) {
  std::vector<Pixel> pixels;
  for (const PeriodicMap<float>& field : fields) {
    const std::vector<float> around = surroundings(field);
    for (std::size_t i = 0; i < around.size(); ++i)
      pixels.push_back({field.values()[i], around[i], static_cast<std::uint32_t>(pixels.size())});
  }
  return pixels;
}

}  // namespace

std::vector<PeriodicMap<float>> ranked(const std::vector<PeriodicMap<float>>& fields) {
  std::vector<Pixel> pixels = pixels_of(fields);
  std::sort(pixels.begin(), pixels.end(), [](const Pixel& a, const Pixel& b) {
    return std::tie(a.value, a.around, a.index) < std::tie(b.value, b.around, b.index);
  });
  std::vector<float> ranks(pixels.size());
  for (std::size_t place = 0; place < pixels.size(); ++place)
    ranks[pixels[place].index] =
        static_cast<float>((static_cast<double>(place) + 0.5) / static_cast<double>(pixels.size()));
  std::vector<PeriodicMap<float>> result;
  auto next = ranks.begin();
  for (const PeriodicMap<float>& field : fields) {
    PeriodicMap<float>& map = result.emplace_back(field.width(), field.height());
    const auto end = next + static_cast<std::ptrdiff_t>(map.values().size());
    std::copy(next, end, map.values().begin());
    next = end;
  }
  return result;
}

double rank_of_gaussian(double gaussian) {
  return 0.5 * std::erfc(-gaussian / std::numbers::sqrt2);
}

double gaussian_of_rank(double rank) {
  // Newton's method on the distribution's logarithm-free tail converges from Winitzki's (2008)
  // approximation of the inverse error function in three steps to the last bits.
  const double x = 2.0 * rank - 1.0;
  const double log_term = std::log(4.0 * rank * (1.0 - rank));
  constexpr double a = 0.147;
  const double half = 2.0 / (std::numbers::pi * a) + 0.5 * log_term;
  double gaussian = std::copysign(std::sqrt(std::sqrt(half * half - log_term / a) - half), x) *
                    std::numbers::sqrt2;
  for (int step = 0; step < 3; ++step) {
    const double density = std::exp(-0.5 * gaussian * gaussian) / std::sqrt(2.0 * std::numbers::pi);
    gaussian -= (rank_of_gaussian(gaussian) - rank) / density;
  }
  return gaussian;
}

}  // namespace wold::cloud
