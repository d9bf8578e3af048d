#include "terrain/river_levels.h"

#include <algorithm>
#include <array>
#include <cstddef>

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

/// The river across: places as many steps from its mouth that lie beside each other, in order
/// upstream.
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

  std::vector<double> means(const std::vector<double>& values) const {
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

/// Half-way between the lowest levels that are not below any downstream, and the highest that are
/// not above any upstream.
void let_rise_upstream(const Sections& sections, std::vector<double>& levels_m) {
  std::vector<double> filled_m = levels_m, cut_m = levels_m;
  for (std::size_t k = 0; k < levels_m.size(); ++k)
    filled_m[k] = std::max(filled_m[k], filled_m[sections.next[k]]);
  for (std::size_t k = levels_m.size(); k-- > 0;)
    cut_m[sections.next[k]] = std::min(cut_m[sections.next[k]], cut_m[k]);
  for (std::size_t k = 0; k < levels_m.size(); ++k) levels_m[k] = 0.5 * (filled_m[k] + cut_m[k]);
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
  std::vector<double> of_sections_m = sections.means(levels_m);
  let_rise_upstream(sections, of_sections_m);
  for (std::size_t k = 0; k < levels_m.size(); ++k)
    levels_m[k] = of_sections_m[sections.of_place[k]];
  channel.smooth(levels_m, rounds_between);
  const double rise_m = *std::ranges::max_element(levels_m) - levels_m[mouth];
  const int longest = sections.steps.back();
  if (rise_m > steepest * step_m * longest) return std::nullopt;
  return levels_m;
}

}  // namespace wold::terrain
