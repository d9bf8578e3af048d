#include "terrain/streams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace wold::terrain {
namespace {

/// Samples by their place in GroundMap::values(). Beyond the border is the opposite side; no water
/// gets there where the border is base level.
class Grid {
 public:
  Grid(int samples, const BaseLevel& base_level) : samples_(samples), base_level_(base_level) {
    if (base_level.size() != static_cast<std::size_t>(count()))
      throw std::invalid_argument("base level and heights must have as many samples");
    if (std::ranges::find(base_level, true) == base_level.end())
      throw std::invalid_argument("some samples must be base level");
  }

  int count() const { return samples_ * samples_; }
  int side() const { return samples_; }
  /// Whether water leaves there.
  bool base(int k) const { return base_level_[static_cast<std::size_t>(k)]; }
  std::array<int, 8> neighbours(int k) const {
    const int n = samples_, i = k % n, row = k - i;
    const int west = i > 0 ? i - 1 : n - 1, east = i < n - 1 ? i + 1 : 0;
    const int south = row > 0 ? row - n : count() - n, north = row < count() - n ? row + n : 0;
    return {south + west, south + i,    south + east, row + west,
            row + east,   north + west, north + i,    north + east};
  }
  /// In grid steps, between neighbours.
  double distance(int k, int to) const {
    const bool straight = k % samples_ == to % samples_ || k / samples_ == to / samples_;
    return straight ? 1.0 : std::numbers::sqrt2;
  }

 private:
  int samples_;
  const BaseLevel& base_level_;
};

/// That of a map whose border is its base level.
BaseLevel border_of(int samples) {
  BaseLevel border;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i)
      border.push_back(i == 0 || j == 0 || i == samples - 1 || j == samples - 1);
  return border;
}

/// The flood that rises from the base level and enters each pit over its lowest outlet.
struct Flood {
  std::vector<int> order;  ///< other samples as the water reaches them, their levels ascending
  std::vector<int> from;   ///< the sample that the water came from
};

/// Fills the pits. Samples of a pit need no place in the queue: they all lie at its outlet's level.
class Flooding {
 public:
  Flooding(std::vector<double>& levels_m, const Grid& grid)
      : levels_m_(levels_m), grid_(grid), reached_(levels_m.size(), false) {
    flood_.from.resize(levels_m.size());
    flood_.order.reserve(levels_m.size());
    for (int k = 0; k < grid_.count(); ++k)
      if (grid_.base(k)) reach(k, k);
  }

  Flood run() {
    constexpr std::size_t some = 1 << 16;
    while (!pit_.empty() || !shore_.empty()) {
      if (flood_.order.size() % some == 0) stop_if_asked();
      const int k = next();
      if (!grid_.base(k)) flood_.order.push_back(k);
      for (const int to : grid_.neighbours(k))
        if (!reached_[index(to)]) reach(to, k);
    }
    return std::move(flood_);
  }

 private:
  static std::size_t index(int k) { return static_cast<std::size_t>(k); }

  void reach(int k, int from) {
    reached_[index(k)] = true;
    flood_.from[index(k)] = from;
    const double level_m = levels_m_[index(from)];
    if (k != from && levels_m_[index(k)] <= level_m) {
      levels_m_[index(k)] = level_m;
      pit_.push(k);
    } else {
      shore_.emplace(levels_m_[index(k)], k);
    }
  }

  int next() {
    if (pit_.empty()) {
      const int k = shore_.top().second;
      shore_.pop();
      return k;
    }
    const int k = pit_.front();
    pit_.pop();
    return k;
  }

  using Sample = std::pair<double, int>;  // ties go to the lower index
  std::vector<double>& levels_m_;
  Grid grid_;
  std::vector<bool> reached_;
  std::queue<int> pit_;
  std::priority_queue<Sample, std::vector<Sample>, std::greater<>> shore_;
  Flood flood_;
};

/// The neighbour that water flows to: the steepest, on level ground the way the flood came.
int receiver(const std::vector<double>& levels_m, const Grid& grid, int k, int flooded_from) {
  int steepest = flooded_from;
  double slope = 0.0;
  for (const int to : grid.neighbours(k)) {
    const double drop =
        levels_m[static_cast<std::size_t>(k)] - levels_m[static_cast<std::size_t>(to)];
    if (drop <= slope * grid.distance(k, to)) continue;
    slope = drop / grid.distance(k, to);
    steepest = to;
  }
  return steepest;
}

/// Turns the way that the flood came into the way that water flows. The flood's order holds for
/// both: it reaches what is lower first.
void drain(const std::vector<double>& levels_m, const Grid& grid, Flood& flood) {
  parallel_for_blocks(flood.order.size(), [&](std::size_t place) {
    const int k = flood.order[place];
    int& to = flood.from[static_cast<std::size_t>(k)];
    to = receiver(levels_m, grid, k, to);
  });
}

/// Samples that drain through each sample, itself included.
std::vector<double> drained(const Flood& flow) {
  std::vector<double> samples(flow.from.size(), 1.0);
  for (std::size_t place = flow.order.size(); place-- > 0;) {
    const auto k = static_cast<std::size_t>(flow.order[place]);
    samples[static_cast<std::size_t>(flow.from[k])] += samples[k];
  }
  return samples;
}

/// One implicit step of reach `reach` along the flow, from the base level upstream.
void cut(GroundMap<double>& heights_m, const Grid& grid, const Flood& flow, double reach,
         double source_fraction) {
  // Leaves no level ground: enough for doubles, too little to be seen.
  const double min_drop_m = 1e-7 * heights_m.step_m();
  const std::vector<double> samples = drained(flow);
  const double steps_per_side = grid.side() - 1.0;
  stop_if_asked();
  for (const int at : flow.order) {
    const auto k = static_cast<std::size_t>(at);
    const double fraction = samples[k] / (steps_per_side * steps_per_side);
    const int to = flow.from[k];
    const double speed = reach * std::sqrt(std::max(fraction, source_fraction)) * steps_per_side /
                         grid.distance(at, to);
    const double below_m = heights_m.values()[static_cast<std::size_t>(to)];
    double& height_m = heights_m.values()[k];
    height_m = std::max((height_m + speed * below_m) / (1.0 + speed), below_m + min_drop_m);
  }
}

/// What the ground rises by in one of the steps.
void lift(GroundMap<double>& heights_m, const Grid& grid, const GroundMap<double>& uplift_m,
          int steps) {
  for (int k = 0; k < grid.count(); ++k)
    if (!grid.base(k))
      heights_m.values()[static_cast<std::size_t>(k)] +=
          uplift_m.values()[static_cast<std::size_t>(k)] / steps;
}

}  // namespace

void carve(GroundMap<double>& heights_m, const Incision& incision) {
  carve(heights_m, GroundMap<double>(heights_m.samples(), heights_m.size_m()), incision);
}

void carve(GroundMap<double>& heights_m, const GroundMap<double>& uplift_m,
           const Incision& incision) {
  carve(heights_m, uplift_m, border_of(heights_m.samples()), incision);
}

void carve(GroundMap<double>& heights_m, const GroundMap<double>& uplift_m,
           const BaseLevel& base_level, const Incision& incision) {
  if (uplift_m.samples() != heights_m.samples())
    throw std::invalid_argument("uplift and heights must have as many samples");
  const Grid grid(heights_m.samples(), base_level);
  for (int step = 0; step < incision.steps; ++step) {
    lift(heights_m, grid, uplift_m, incision.steps);
    Flood flow = Flooding(heights_m.values(), grid).run();
    drain(heights_m.values(), grid, flow);
    cut(heights_m, grid, flow, incision.reach / incision.steps, incision.source_fraction);
  }
}

GroundMap<double> drained_samples(const GroundMap<double>& heights_m) {
  const BaseLevel border = border_of(heights_m.samples());
  const Grid grid(heights_m.samples(), border);
  GroundMap<double> map = heights_m;
  Flood flow = Flooding(map.values(), grid).run();
  drain(map.values(), grid, flow);
  map.values() = drained(flow);
  return map;
}

}  // namespace wold::terrain
