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
/// New greenness that hides all dead blades.
constexpr double hiding = 0.5;

double logistic(double weathering_degree) {
  return 1.0 / (1.0 + math::exp(steepness * (weathering_degree - half_way)));
}

/// Follows how much of the season's greenness is lost.
class Fading {
 public:
  explicit Fading(double green) : lost_(1.0 - green), palest_(green), last_(green) {}

  double advance(double green) {
    const double gain = green - last_;
    last_ = green;
    if (gain > 0.0 && green > palest_ + regrowth) {
      lost_ = std::max(0.0, lost_ - gain / hiding);
      palest_ = green - regrowth;
      greatest_ = green / std::max(1.0 - lost_, 1e-6);
    } else {
      palest_ = std::min(palest_, green);
      lost_ = std::clamp(1.0 - green / greatest_, lost_, 1.0);
    }
    return lost_;
  }

 private:
  double lost_;            ///< fraction of the season's greatest greenness
  double greatest_ = 1.0;  ///< of this season
  double palest_;          ///< since it was that
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
    degrees.push_back(weathering_degree_of(1.0 - fading.advance(green)));
  return degrees;
}

}  // namespace wold::phenology
