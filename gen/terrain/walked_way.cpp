#include "terrain/walked_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
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

/// Nodes about two places, with their heights.
class Lattice {
 public:
  Lattice(const Heightfield& heights_m, const glm::dvec2& from_m, const glm::dvec2& to_m,
          const Water* water) {
    constexpr double beyond = 1.0 / 3.0, most_steps = 160.0, least_step_m = 0.5;
    const double around_m = beyond * glm::distance(from_m, to_m);
    const glm::dvec2 low_m = heights_m.corner_m(), high_m = low_m + heights_m.size_m();
    corner_m_ = glm::clamp(glm::min(from_m, to_m) - around_m, low_m, high_m);
    const glm::dvec2 size_m =
        glm::clamp(glm::max(from_m, to_m) + around_m, low_m, high_m) - corner_m_;
    step_m_ = std::max(least_step_m, std::max(size_m.x, size_m.y) / most_steps);
    count_ = glm::ivec2(size_m / step_m_) + 1;
    for (int j = 0; j < count_.y; ++j)
      for (int i = 0; i < count_.x; ++i) {
        const glm::dvec2 at_m = place_m({i, j});
        height_m_.push_back(double{heights_m.sample(at_m.x, at_m.y)});
        wet_.push_back(water != nullptr && water->share(at_m, step_m_) > 0.5);
      }
  }

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
  std::size_t nodes() const { return height_m_.size(); }

  /// From a node to its neighbour.
  double seconds(const glm::ivec2& from, const glm::ivec2& to) const {
    constexpr double swimming = 30.0;
    const double far_m = glm::length(glm::dvec2(to - from)) * step_m_;
    const double rise_m = height_m_[index(to)] - height_m_[index(from)];
    const double walked_s = far_m * seconds_per_metre(rise_m / far_m);
    return wet_[index(to)] ? swimming * walked_s : walked_s;
  }

 private:
  glm::dvec2 corner_m_{0.0};
  double step_m_ = 1.0;
  glm::ivec2 count_{1};
  std::vector<double> height_m_;
  std::vector<bool> wet_;
};

/// Of a turn by so many sixteenths of a full one.
double turning_seconds(int turn) {
  constexpr double hairpin_s = 20.0, half_turn = directions / 2.0;
  const int least = std::min(turn, directions - turn);
  return hairpin_s * (least / half_turn) * (least / half_turn);
}

/// The quickest way by Dijkstra's algorithm over nodes and the directions in which one comes.
std::vector<glm::ivec2> quickest(const Lattice& lattice, const glm::ivec2& from,
                                 const glm::ivec2& to) {
  constexpr double far = std::numeric_limits<double>::infinity();
  constexpr auto around = static_cast<std::size_t>(directions);
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<double> seconds(lattice.nodes() * around, far);
  std::vector<std::size_t> before(seconds.size(), none);
  using Reached = std::pair<double, std::size_t>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
  for (std::size_t way = 0; way < around; ++way) {
    const std::size_t state = lattice.index(from) * around + way;
    seconds[state] = 0.0;
    next.emplace(0.0, state);
  }
  std::size_t state = none;
  while (!next.empty()) {
    const auto [reached_s, here] = next.top();
    next.pop();
    if (reached_s > seconds[here]) continue;
    const glm::ivec2 node = lattice.node(here / around);
    state = here;
    if (node == to) break;
    for (int way = 0; way < directions; ++way) {
      const glm::ivec2 neighbour = node + moves[static_cast<std::size_t>(way)];
      if (!lattice.has(neighbour)) continue;
      const int turn = std::abs(way - static_cast<int>(here % around));
      const double there_s = reached_s + lattice.seconds(node, neighbour) + turning_seconds(turn);
      const std::size_t there = lattice.index(neighbour) * around + static_cast<std::size_t>(way);
      if (there_s >= seconds[there]) continue;
      seconds[there] = there_s;
      before[there] = here;
      next.emplace(there_s, there);
    }
  }
  std::vector<glm::ivec2> nodes;
  for (; state != none; state = before[state]) nodes.push_back(lattice.node(state / around));
  std::ranges::reverse(nodes);
  return nodes;
}

/// Cuts a line's corners, but for its ends (Chaikin 1974).
std::vector<glm::dvec2> cut_corners(const std::vector<glm::dvec2>& line) {
  std::vector<glm::dvec2> cut{line.front()};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    if (k > 0) cut.push_back(glm::mix(line[k], line[k + 1], 0.25));
    if (k + 2 < line.size()) cut.push_back(glm::mix(line[k], line[k + 1], 0.75));
  }
  cut.push_back(line.back());
  return cut;
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
  constexpr int rounds = 3;
  const Lattice lattice(heights_m, from_m, to_m, water);
  std::vector<glm::dvec2> line{from_m};
  for (const glm::ivec2& node : quickest(lattice, lattice.node_at(from_m), lattice.node_at(to_m)))
    line.push_back(lattice.place_m(node));
  line.push_back(to_m);
  for (int round = 0; round < rounds; ++round) line = cut_corners(line);
  return line;
}

}  // namespace wold::terrain
