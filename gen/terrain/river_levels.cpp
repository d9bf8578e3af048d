#include "terrain/river_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/ground_map.h"

namespace wold::terrain {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

/// Which places lie beside each other, by sides and corners.
class Channel {
 public:
  explicit Channel(std::span<const glm::ivec2> places) : neighbours_(places.size()) {
    glm::ivec2 low = places.front(), high = low;
    for (const glm::ivec2& at : places) {
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
    const glm::ivec2 size = high - low + 3;  // with a border
    const auto cell = [&](const glm::ivec2& at) {
      const glm::ivec2 from = at - low + 1;
      return static_cast<std::size_t>(from.y) * static_cast<std::size_t>(size.x) +
             static_cast<std::size_t>(from.x);
    };
    std::vector<std::size_t> place_in(
        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), none);
    for (std::size_t k = 0; k < places.size(); ++k) place_in[cell(places[k])] = k;
    constexpr std::array<glm::ivec2, 8> around = {
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    for (std::size_t k = 0; k < places.size(); ++k)
      std::ranges::transform(around, neighbours_[k].begin(),
                             [&](const glm::ivec2& to) { return place_in[cell(places[k] + to)]; });
  }

  template <class Visit>
  void each_neighbour(std::size_t place, const Visit& visit) const {
    for (const std::size_t other : neighbours_[place])
      if (other != none) visit(other);
  }

  /// Each the mean of itself and its neighbours, over and over.
  void smooth(std::vector<double>& values, int rounds) const {
    std::vector<double> mean(values.size());
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t k = 0; k < values.size(); ++k) {
        double sum = values[k];
        int count = 1;
        each_neighbour(k, [&](std::size_t other) {
          sum += values[other];
          ++count;
        });
        mean[k] = sum / count;
      }
      std::swap(values, mean);
    }
  }

 private:
  std::vector<std::array<std::size_t, 8>> neighbours_;
};

/// The river across: of places as many steps from its mouth those that lie beside each other, in
/// order upstream.
struct Sections {
  std::vector<std::size_t> of_place;
  std::vector<std::size_t> next;  ///< downstream of each; of the mouth itself
  std::vector<int> steps;         ///< from the mouth

  Sections(const Channel& channel, std::size_t mouth, std::size_t places)
      : of_place(places, none), next{0}, steps{0} {
    std::vector<int> away(places, -1);
    std::vector<std::size_t> upstream = {mouth};
    away[mouth] = 0;
    of_place[mouth] = 0;
    for (std::size_t k = 0; k < upstream.size(); ++k) {
      const std::size_t place = upstream[k];
      channel.each_neighbour(place, [&](std::size_t other) {
        if (away[other] >= 0) return;
        away[other] = away[place] + 1;
        upstream.push_back(other);
        of_place[other] = section_beside(channel, other, away);
        if (of_place[other] != none) return;
        of_place[other] = next.size();
        next.push_back(of_place[place]);
        steps.push_back(away[other]);
      });
    }
  }

  std::vector<double> means(std::span<const double> values) const {
    std::vector<double> sums(next.size(), 0.0), counts(next.size(), 0.0);
    for (std::size_t k = 0; k < values.size(); ++k) {
      sums[of_place[k]] += values[k];
      counts[of_place[k]] += 1.0;
    }
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= counts[k];
    return sums;
  }

 private:
  std::size_t section_beside(const Channel& channel, std::size_t place,
                             const std::vector<int>& away) const {
    std::size_t section = none;
    channel.each_neighbour(place, [&](std::size_t other) {
      if (away[other] == away[place] && of_place[other] != none) section = of_place[other];
    });
    return section;
  }
};

/// The highest levels that are nowhere above one upstream. What a model has wrong is too high most
/// of the time: bridges, trees, banks.
void cut_downstream(const Sections& sections, std::vector<double>& levels_m) {
  for (std::size_t k = levels_m.size(); k-- > 0;) {
    double& next_m = levels_m[sections.next[k]];
    next_m = std::min(next_m, levels_m[k]);
  }
}

/// Heights where none stands out of the water downstream of it by more than what is measured there
/// is uneven: a bridge is not to lift the water beside it. None where much stands out far: no river
/// flows so.
std::optional<std::vector<double>> without_bridges(const Sections& sections,
                                                   std::span<const double> heights_m) {
  constexpr double uneven_m = 5.0, far_m = 25.0, much = 0.1;
  std::vector<double> heights(heights_m.begin(), heights_m.end());
  const std::vector<double> measured_m = sections.means(heights);
  std::vector<double> cut_m = measured_m;
  cut_downstream(sections, cut_m);
  std::size_t far = 0;
  for (std::size_t k = 0; k < cut_m.size(); ++k)
    if (measured_m[k] - cut_m[k] > far_m) ++far;
  if (static_cast<double>(far) > much * static_cast<double>(cut_m.size())) return std::nullopt;
  for (std::size_t k = 0; k < heights.size(); ++k)
    heights[k] = std::min(heights[k], cut_m[sections.of_place[k]] + uneven_m);
  return heights;
}

}  // namespace

std::optional<std::vector<double>> river_levels_m(std::span<const glm::ivec2> places,
                                                  std::span<const double> heights_m,
                                                  double step_m) {
  constexpr int rounds = 48;         // errors of some cells' width go
  constexpr int rounds_between = 4;  // so do steps from section to section
  constexpr double steepest = 0.1;
  const Channel channel(places);
  std::vector<double> levels_m(heights_m.begin(), heights_m.end());
  channel.smooth(levels_m, rounds);
  const auto mouth =
      static_cast<std::size_t>(std::ranges::min_element(levels_m) - levels_m.begin());
  const Sections sections(channel, mouth, places.size());
  std::optional<std::vector<double>> open_m = without_bridges(sections, heights_m);
  if (!open_m) return std::nullopt;
  levels_m = std::move(*open_m);
  channel.smooth(levels_m, rounds);
  std::vector<double> of_sections_m = sections.means(levels_m);
  cut_downstream(sections, of_sections_m);
  for (std::size_t k = 0; k < levels_m.size(); ++k)
    levels_m[k] = of_sections_m[sections.of_place[k]];
  channel.smooth(levels_m, rounds_between);
  const double rise_m = *std::ranges::max_element(levels_m) - levels_m[mouth];
  const int longest = sections.steps.back();
  if (rise_m > steepest * step_m * longest) return std::nullopt;
  return levels_m;
}

}  // namespace wold::terrain
