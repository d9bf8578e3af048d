#include "terrain/scree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/normal_distribution.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/relief.h"

namespace wold::terrain {
namespace {

constexpr int max_samples = 1025;  // of a map of debris along a side

Heightfield thinned(const Heightfield& heights_m) {
  if (heights_m.samples() <= max_samples) return heights_m;
  Heightfield map(max_samples, heights_m.square());
  for (int j = 0; j < max_samples; ++j)
    for (int i = 0; i < max_samples; ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      map.at(i, j) = heights_m.sample(at_m.x, at_m.y);
    }
  return map;
}

/// Share of the ground about a sample that is rock, by its slope: what is finer has slopes that
/// deviate from it, so that some of gentler ground is rock, too.
FactorMap rock_shares(const Heightfield& heights_m, double rock_slope_deg) {
  constexpr double deviation_deg = 4.0;
  FactorMap shares(heights_m.samples(), heights_m.square());
  parallel_for(static_cast<std::size_t>(shares.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < shares.samples(); ++i) {
      const glm::dvec2 at_m = shares.place_m(i, j);
      shares.at(i, j) = static_cast<float>(
          normal_cdf((slope_deg(heights_m, at_m.x, at_m.y) - rock_slope_deg) / deviation_deg));
    }
  });
  return shares;
}

/// Debris on its way down, from the highest sample to the lowest.
class Fall {
 public:
  Fall(const Heightfield& heights_m, const FactorMap& rock)
      : heights_m_(heights_m),
        samples_(heights_m.samples()),
        step_m_(heights_m.step_m()),
        width_m_(rock.values().begin(), rock.values().end()),
        head_m_(rock.values().size(), none_m) {
    for (double& width_m : width_m_) width_m *= step_m_;
    for (std::size_t k = 0; k < head_m_.size(); ++k)
      if (rock.values()[k] > least_rock) head_m_[k] = 0.0;
  }

  void run() {
    for (const int k : downwards()) pass_on(k);
  }

  /// Length of the rock above a sample that has it for its debris, metres.
  double rock_m(std::size_t k) const { return width_m_[k]; }
  /// How high the energy line is over the ground, metres.
  double head_m(std::size_t k) const { return head_m_[k]; }

 private:
  static constexpr double none_m = -1e6, least_rock = 0.02;

  /// Ties go to the lower index.
  std::vector<int> downwards() const {
    std::vector<int> order(head_m_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, [&](int a, int b) { return height_m(a) > height_m(b); });
    return order;
  }

  double height_m(int k) const { return double{heights_m_.values()[static_cast<std::size_t>(k)]}; }

  void pass_on(int k) {
    // Falls end in a terminal speed, some 20 m/s of rolling blocks: a head of v^2 / 2g.
    constexpr double most_head_m = 20.0, freeman = 1.1;
    const double line = math::tan(radians(27.5));
    struct Lower {
      std::size_t to;
      double drop_m, distance_m, weight;
    };
    std::array<Lower, 8> lower{};
    std::size_t count = 0;
    double weights = 0.0;
    const int i = k % samples_, j = k / samples_;
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di) {
        if (std::min(i + di, j + dj) < 0 || std::max(i + di, j + dj) >= samples_) continue;
        const int to = k + dj * samples_ + di;
        const double drop_m = height_m(k) - height_m(to);
        if (drop_m <= 0.0) continue;
        const double distance_m = step_m_ * (di != 0 && dj != 0 ? std::numbers::sqrt2 : 1.0);
        const double weight = math::pow(drop_m / distance_m, freeman);
        lower[count++] = {static_cast<std::size_t>(to), drop_m, distance_m, weight};
        weights += weight;
      }
    const auto from = static_cast<std::size_t>(k);
    for (std::size_t n = 0; n < count; ++n) {
      const Lower& way = lower[n];
      if (head_m_[from] >= 0.0) width_m_[way.to] += width_m_[from] * way.weight / weights;
      head_m_[way.to] = std::min(most_head_m, std::max(head_m_[way.to], head_m_[from] + way.drop_m -
                                                                            way.distance_m * line));
    }
  }

  const Heightfield& heights_m_;
  int samples_;
  double step_m_;
  std::vector<double> width_m_, head_m_;
};

/// By the energy line, and by how much rock there is above.
double likely_share(double head_m, double rock_m) {
  constexpr double covering_rock_m = 40.0;  // a modelling choice
  constexpr double deviation_m = 4.0;       // of the energy line, which no two blocks share
  return normal_cdf(head_m / deviation_m) * (1.0 - math::exp(-rock_m / covering_rock_m));
}

FactorMap likely_shares(const Heightfield& heights_m, double rock_slope_deg) {
  const FactorMap rock = rock_shares(heights_m, rock_slope_deg);
  Fall fall(heights_m, rock);
  fall.run();
  FactorMap likely(heights_m.samples(), heights_m.square());
  for (std::size_t k = 0; k < likely.values().size(); ++k)
    likely.values()[k] = static_cast<float>(likely_share(fall.head_m(k), fall.rock_m(k)));
  return likely;
}

}  // namespace

Scree::Scree(const Heightfield& heights_m, double rock_slope_deg, std::uint64_t seed)
    : key_(random_bits({seed, key_of("ground"), 0, key_of("scree")})),
      likely_(likely_shares(thinned(heights_m), rock_slope_deg)) {}

Scree::Patches::Patches(const Scree& scree, double step_m)
    : scree_(scree),
      field_(scree.key_, {150.0, 0.3}, /*hurst=*/0.25, step_m),
      softness_(std::sqrt(std::max(1.0 - field_.shown(), 0.01))) {}

double Scree::Patches::share(const glm::dvec2& at_m, double slope_deg, double exposure) const {
  constexpr double by_exposure = 0.5, repose_deg = 38.0, strip_deg = 4.0, least = 0.005;
  const double likely{scree_.likely_.sample(at_m.x, at_m.y)};
  if (likely < least || slope_deg >= repose_deg) return 0.0;
  const double lies = 1.0 - glm::smoothstep(repose_deg - strip_deg, repose_deg, slope_deg);
  const double field = std::sqrt(1.0 - by_exposure * by_exposure) * field_.at(at_m) +
                       by_exposure * std::clamp(exposure, -2.0, 2.0);
  return lies * normal_cdf((normal_quantile(std::min(likely, 1.0 - least)) - field) / softness_);
}

}  // namespace wold::terrain
