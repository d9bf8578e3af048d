#include "phenology/withering.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"

namespace wold::phenology {
namespace {

constexpr double half_way = 0.43;
constexpr double steepness = 5.0;
/// Greenness by which a meadow has to rise above its palest for that to be new growth.
constexpr double regrowth = 0.05;

double logistic(double weathering_degree) {
  return 1.0 / (1.0 + math::exp(steepness * (weathering_degree - half_way)));
}

/// Follows how green a meadow looks whose dead blades stay dead.
class Fading {
 public:
  explicit Fading(double green) : looks_(green), palest_(green), last_(green) {}

  double advance(double green) {
    const bool grows = green > last_ && green > palest_ + regrowth;
    last_ = green;
    palest_ = grows ? green - regrowth : std::min(palest_, green);
    looks_ = grows ? green : std::min(looks_, green);
    return looks_;
  }

 private:
  double looks_;
  double palest_;  ///< since blades last grew
  double last_;
};

}  // namespace

double greenness_of(double weathering_degree) {
  return (logistic(weathering_degree) - logistic(1.0)) / (logistic(0.0) - logistic(1.0));
}

double weathering_degree_of(double greenness) {
  const double fraction = logistic(1.0) + greenness * (logistic(0.0) - logistic(1.0));
  return std::clamp(half_way + math::log(1.0 / fraction - 1.0) / steepness, 0.0, 1.0);
}

std::vector<double> weathering_degrees(std::span<const double> greenness) {
  std::vector<double> degrees;
  if (greenness.empty()) return degrees;
  Fading fading(greenness.front());
  for (const double green : greenness)
    degrees.push_back(weathering_degree_of(fading.advance(green)));
  return degrees;
}

}  // namespace wold::phenology
