#include "cloud/trails.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "cloud/box_filter.h"
#include "cloud/texture_noise.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::cloud {
namespace {

/// Trails end after so many lengths: the last ice has sublimed.
constexpr double longest = 3.5;

/// A place along a trail, what of the ice that fell there is left, and the map to look it up in.
struct Step {
  double away;  ///< in trails' lengths
  double left;
  std::size_t level;
};

/// What is left of ice at a distance from its head, in lengths. In the head it has to grow first.
double left_at(double away) {
  constexpr double growth = 0.15;
  const double end = math::pow(away / longest, 8.0);
  return -math::expm1(-away / growth) * math::exp(-away) * std::max(1.0 - end, 0.0);
}

/// Steps of a pixel of their level; length_px: of a trail. Falling ice spreads, so that farther
/// steps have coarser levels, each of half as many pixels.
std::vector<Step> steps_of_trail(double length_px, std::size_t levels) {
  constexpr double spread = 1.0 / 60.0;  // width over the way
  constexpr double few = 8.0;            // steps, of trails shorter than that
  std::vector<Step> steps;
  double from_px = 0.0, step_px = std::min(1.0, longest * length_px / few);
  for (std::size_t level = 0; from_px < longest * length_px; from_px += step_px) {
    if (level + 1 < levels && spread * from_px > step_px) {
      ++level;
      step_px *= 2.0;
    }
    const double away = (from_px + 0.5 * step_px) / length_px;
    steps.push_back({away, left_at(away) * step_px / length_px, level});
  }
  return steps;
}

/// How far aside a trail is, in its lengths: the wind turns with the height that ice falls through,
/// most of it on the first length or two.
double aside_at(double bend, double away) { return bend * away * away * 3.0 / (2.0 + away); }

/// How far turbulence moves trails, so that fibres undulate: some waves on a trail's length. Size
/// and height are choices, made by looking.
class Waves {
 public:
  Waves(double length, std::uint64_t key)
      : key_(key),
        height_(0.02 * length),
        period_(std::max(1, static_cast<int>(std::lround(1.3 / length)))) {}

  /// In textures.
  glm::dvec2 at(const glm::dvec2& place) const {
    constexpr std::uint64_t octaves = 3;
    glm::dvec2 sum(0.0);
    glm::ivec2 period(period_);
    double height = height_;
    for (std::uint64_t octave = 0; octave < octaves; ++octave, period *= 2, height *= 0.45) {
      const glm::dvec2 features = place * glm::dvec2(period);
      sum += height * glm::dvec2(perlin(features, random_bits({key_, octave, 0}), period),
                                 perlin(features, random_bits({key_, octave, 1}), period));
    }
    return sum;
  }

 private:
  std::uint64_t key_;
  double height_;
  int period_;
};

PeriodicMap<float> falling(const PeriodicMap<float>& heads, double contrast) {
  PeriodicMap<float> ice(heads.width(), heads.height());
  parallel_for_blocks(ice.values().size(), [&](std::size_t i) {
    ice.values()[i] = static_cast<float>(math::exp(contrast * double{heads.values()[i]}));
  });
  return ice;
}

}  // namespace

PeriodicMap<float> trailing(const PeriodicMap<float>& heads, const Trails& trails,
                            std::uint64_t key) {
  const std::vector<PeriodicMap<float>> ice = with_halves(falling(heads, trails.contrast));
  const std::vector<Step> path = steps_of_trail(trails.length * heads.width(), ice.size());
  const Waves waves(trails.length, key);
  const glm::dvec2 downwind(math::sin(trails.heading_rad), math::cos(trails.heading_rad));
  const glm::dvec2 aside(downwind.y, -downwind.x);
  PeriodicMap<float> field(heads.width(), heads.height());
  parallel_for(static_cast<std::size_t>(field.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < field.width(); ++x) {
      const glm::dvec2 place((x + 0.5) / field.width(), (y + 0.5) / field.height());
      constexpr glm::ivec2 regions(2);
      const glm::dvec2 from = place + waves.at(place);
      const double bend =
          trails.bend * (1.0 + 0.5 * perlin(place * glm::dvec2(regions), key, regions));
      double sum = 0.0;
      for (const Step& step : path) {
        const glm::dvec2 head =
            from + trails.length * (step.away * downwind + aside_at(bend, step.away) * aside);
        sum += step.left * ice[step.level].sample(head.x, head.y);
      }
      field.at(x, y) = static_cast<float>(math::log(sum));
    }
  });
  return field;
}

}  // namespace wold::cloud
