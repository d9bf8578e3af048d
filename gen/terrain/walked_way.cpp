#include "terrain/walked_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

#include "core/elementary.h"

namespace wold::terrain {
namespace {

/// Steps to the nearest nodes in 16 directions, counterclockwise from east.
constexpr std::array<glm::ivec2, 16> moves{{{1, 0},
                                            {2, 1},
                                            {1, 1},
                                            {1, 2},
                                            {0, 1},
                                            {-1, 2},
                                            {-1, 1},
                                            {-2, 1},
                                            {-1, 0},
                                            {-2, -1},
                                            {-1, -1},
                                            {-1, -2},
                                            {0, -1},
                                            {1, -2},
                                            {1, -1},
                                            {2, -1}}};
constexpr int directions = static_cast<int>(moves.size());

/// Nodes about two places, and how long it takes to walk there.
class Lattice {
 public:
  Lattice(const Heightfield& heights_m, const glm::dvec2& from_m, const glm::dvec2& to_m,
          const Water* water)
      : heights_m_(heights_m), water_(water) {
    constexpr double beyond = 1.0 / 3.0, most_steps = 160.0, least_step_m = 0.5;
    const double around_m = beyond * glm::distance(from_m, to_m);
    const glm::dvec2 low_m = heights_m.corner_m(), high_m = low_m + heights_m.size_m();
    corner_m_ = glm::clamp(glm::min(from_m, to_m) - around_m, low_m, high_m);
    const glm::dvec2 size_m =
        glm::clamp(glm::max(from_m, to_m) + around_m, low_m, high_m) - corner_m_;
    step_m_ = std::max(least_step_m, std::max(size_m.x, size_m.y) / most_steps);
    count_ = glm::ivec2(size_m / step_m_) + 1;
  }

  double step_m() const { return step_m_; }
  glm::dvec2 place_m(const glm::ivec2& node) const {
    return corner_m_ + glm::dvec2(node) * step_m_;
  }
  glm::ivec2 node_at(const glm::dvec2& at_m) const {
    return glm::clamp(glm::ivec2(glm::round((at_m - corner_m_) / step_m_)), glm::ivec2(0),
                      count_ - 1);
  }
  bool has(const glm::ivec2& node) const {
    return glm::all(glm::greaterThanEqual(node, glm::ivec2(0))) &&
           glm::all(glm::lessThan(node, count_));
  }
  std::size_t index(const glm::ivec2& node) const {
    return static_cast<std::size_t>(node.y) * static_cast<std::size_t>(count_.x) +
           static_cast<std::size_t>(node.x);
  }
  glm::ivec2 node(std::size_t index) const {
    const auto along = static_cast<std::size_t>(count_.x);
    return {static_cast<int>(index % along), static_cast<int>(index / along)};
  }
  std::size_t nodes() const {
    return static_cast<std::size_t>(count_.x) * static_cast<std::size_t>(count_.y);
  }

  /// Straight from one place to another, a step of the grid at a time.
  double seconds(const glm::dvec2& from_m, const glm::dvec2& to_m) const {
    constexpr double swimming = 30.0, wet = 0.5;
    const double far_m = glm::distance(from_m, to_m);
    const int pieces = std::max(1, static_cast<int>(std::ceil(far_m / step_m_ - 0.01)));
    double walked_s = 0.0;
    double height_m = height_at(from_m);
    for (int piece = 1; piece <= pieces; ++piece) {
      const glm::dvec2 at_m = glm::mix(from_m, to_m, static_cast<double>(piece) / pieces);
      const double next_m = height_at(at_m), run_m = far_m / pieces;
      const bool swims = water_ != nullptr && water_->share(at_m, step_m_) > wet;
      walked_s += (swims ? swimming : 1.0) * run_m *
                  seconds_per_metre((next_m - height_m) / std::max(run_m, 1e-9));
      height_m = next_m;
    }
    return walked_s;
  }

 private:
  double height_at(const glm::dvec2& at_m) const {
    return double{heights_m_.sample(at_m.x, at_m.y)};
  }

  const Heightfield& heights_m_;
  const Water* water_;
  glm::dvec2 corner_m_{0.0};
  double step_m_ = 1.0;
  glm::ivec2 count_{1};
};

/// Of a turn by so many of the directions, of which 16 are a full one.
double turning_seconds(int turn) {
  constexpr double hairpin_s = 20.0, half_turn = directions / 2.0;
  const int least = std::min(turn, directions - turn);
  return hairpin_s * (least / half_turn) * (least / half_turn);
}

/// The quickest way, by the A* algorithm over nodes and the directions in which one comes.
std::vector<glm::ivec2> quickest(const Lattice& lattice, const glm::ivec2& from,
                                 const glm::ivec2& to) {
  constexpr double far = std::numeric_limits<double>::infinity();
  constexpr auto around = static_cast<std::size_t>(directions);
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<double> seconds(lattice.nodes() * around, far);
  std::vector<std::size_t> before(seconds.size(), none);
  const double least_s_per_m = seconds_per_metre(0.0);
  const auto at_least_s = [&](const glm::ivec2& node) {
    return least_s_per_m * glm::distance(lattice.place_m(node), lattice.place_m(to));
  };
  using Reached = std::pair<double, std::size_t>;  // seconds to the end at least, state
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  for (std::size_t way = 0; way < around; ++way) {
    const std::size_t state = lattice.index(from) * around + way;
    seconds[state] = 0.0;
    next.emplace(at_least_s(from), state);
  }
  std::vector<bool> done(seconds.size(), false);
  std::size_t state = none;
  while (!next.empty()) {
    const std::size_t here = next.top().second;
    next.pop();
    if (done[here]) continue;
    done[here] = true;
    const glm::ivec2 node = lattice.node(here / around);
    state = here;
    if (node == to) break;
    for (int way = 0; way < directions; ++way) {
      const glm::ivec2 neighbour = node + moves[static_cast<std::size_t>(way)];
      if (!lattice.has(neighbour)) continue;
      const int turn = std::abs(way - static_cast<int>(here % around));
      const double there_s = seconds[here] +
                             lattice.seconds(lattice.place_m(node), lattice.place_m(neighbour)) +
                             turning_seconds(turn);
      const std::size_t there = lattice.index(neighbour) * around + static_cast<std::size_t>(way);
      if (there_s >= seconds[there]) continue;
      seconds[there] = there_s;
      before[there] = here;
      next.emplace(there_s + at_least_s(neighbour), there);
    }
  }
  std::vector<glm::ivec2> nodes;
  for (; state != none; state = before[state]) nodes.push_back(lattice.node(state / around));
  std::ranges::reverse(nodes);
  return nodes;
}

/// Leaves out points between which it takes no longer straight.
std::vector<glm::dvec2> straightened(const Lattice& lattice, const std::vector<glm::dvec2>& line) {
  constexpr double no_longer = 1.0 + 1e-9;
  std::vector<double> until_s{0.0};
  for (std::size_t k = 0; k + 1 < line.size(); ++k)
    until_s.push_back(until_s.back() + lattice.seconds(line[k], line[k + 1]));
  std::vector<glm::dvec2> straight{line.front()};
  for (std::size_t k = 0; k + 1 < line.size();) {
    std::size_t end = line.size() - 1;
    while (end > k + 1 &&
           lattice.seconds(line[k], line[end]) > no_longer * (until_s[end] - until_s[k]))
      --end;
    straight.push_back(line[end]);
    k = end;
  }
  return straight;
}

/// Points along a line, so far apart at most.
std::vector<glm::dvec2> divided(const std::vector<glm::dvec2>& line, double step_m) {
  std::vector<glm::dvec2> points{line.front()};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(glm::distance(line[k], line[k + 1]) / step_m)));
    for (int piece = 1; piece <= pieces; ++piece)
      points.push_back(glm::mix(line[k], line[k + 1], static_cast<double>(piece) / pieces));
  }
  return points;
}

}  // namespace

double seconds_per_metre(double slope) {
  constexpr double s_per_m_at_best = 3.6 / 6.0;  // at 6 km/h
  const auto one_way = [&](double rise) {
    return s_per_m_at_best * math::exp(3.5 * std::abs(rise + 0.05));
  };
  return 0.5 * (one_way(slope) + one_way(-slope));
}

std::vector<glm::dvec2> walked_way(const Heightfield& heights_m, const glm::dvec2& from_m,
                                   const glm::dvec2& to_m, const Water* water) {
  const Lattice lattice(heights_m, from_m, to_m, water);
  std::vector<glm::dvec2> line{from_m};
  for (const glm::ivec2& node : quickest(lattice, lattice.node_at(from_m), lattice.node_at(to_m)))
    line.push_back(lattice.place_m(node));
  // The nodes next to both ends may lie behind them.
  if (line.size() > 1) line.pop_back();
  if (line.size() > 1) line.erase(line.begin() + 1);
  line.push_back(to_m);
  return divided(straightened(lattice, line), lattice.step_m());
}

}  // namespace wold::terrain
