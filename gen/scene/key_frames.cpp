#include "scene/key_frames.h"

#include <algorithm>
#include <cmath>

namespace wold::scene {
namespace {

constexpr int min_steps = 12;
constexpr int max_steps = 48;

/// The weathering degrees of a take's frames.
std::vector<double> degrees_of(const MeadowPart& meadow, const Take& take) {
  std::vector<double> degrees;
  for (int frame = take.first; frame <= take.last(); ++frame)
    degrees.push_back(meadow.ageing.frames.at(static_cast<std::size_t>(frame - 1)));
  return degrees;
}

/// Of a few seconds' weather nothing is seen.
bool is_still(const std::vector<double>& degrees) {
  const auto [min, max] = std::ranges::minmax(degrees);
  return max - min < 1.0 / max_steps;
}

/// The least that the weathering degree changes by between two frames, where it changes at all.
double shortest_step(const std::vector<double>& degrees) {
  double shortest = 1.0;
  for (std::size_t i = 1; i < degrees.size(); ++i)
    if (const double step = std::abs(degrees[i] - degrees[i - 1]); step > 0.0)
      shortest = std::min(shortest, step);
  return shortest;
}

double shortest_step(const MeadowPart& meadow) {
  if (meadow.takes.empty()) return shortest_step(meadow.ageing.frames);
  double shortest = 1.0;
  for (const Take& take : meadow.takes)
    if (const auto degrees = degrees_of(meadow, take); !is_still(degrees))
      shortest = std::min(shortest, shortest_step(degrees));
  return shortest;
}

}  // namespace

std::vector<double> key_frames(const MeadowPart& meadow) {
  if (!meadow.grass.key_frames.empty()) return meadow.grass.key_frames;
  const double wanted = std::ceil(1.0 / shortest_step(meadow) - 1e-9);
  const auto steps = static_cast<int>(std::clamp(wanted, double{min_steps}, double{max_steps}));
  std::vector<double> degrees;
  for (int i = 0; i <= steps; ++i) degrees.push_back(static_cast<double>(i) / steps);
  return degrees;
}

}  // namespace wold::scene
