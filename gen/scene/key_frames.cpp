#include "scene/key_frames.h"

#include <algorithm>
#include <cmath>

namespace wold::scene {
namespace {

constexpr int min_steps = 12;
constexpr int max_steps = 48;

/// The least that the weathering degree changes by between two frames, where it changes at all.
double shortest_step(const std::vector<double>& frames) {
  double shortest = 1.0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (const double step = std::abs(frames[i] - frames[i - 1]); step > 0.0)
      shortest = std::min(shortest, step);
  return shortest;
}

}  // namespace

std::vector<double> key_frames(const MeadowPart& meadow) {
  if (!meadow.grass.key_frames.empty()) return meadow.grass.key_frames;
  const double wanted = std::ceil(1.0 / shortest_step(meadow.ageing.frames) - 1e-9);
  const auto steps = static_cast<int>(std::clamp(wanted, double{min_steps}, double{max_steps}));
  std::vector<double> degrees;
  for (int i = 0; i <= steps; ++i) degrees.push_back(static_cast<double>(i) / steps);
  return degrees;
}

}  // namespace wold::scene
