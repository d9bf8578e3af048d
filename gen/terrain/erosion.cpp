#include "terrain/erosion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::terrain {
namespace {

struct Offset {
  int i = 0;
  int j = 0;
  bool diagonal() const { return i != 0 && j != 0; }
};

constexpr std::array<Offset, 8> neighbours = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// One exchange between all pairs that lie `stride` grid steps apart. flow_m(drop_m, diagonal) is
/// what a sample loses to a neighbour that lies lower by drop_m; odd in the drop, hence conserving.
template <class Flow>
void exchange(GroundMap<double>& heights_m, int stride, const Flow& flow_m) {
  const GroundMap<double> old = heights_m;
  const int samples = old.samples();
  parallel_for(static_cast<std::size_t>(samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples; ++i) {
      double lost_m = 0.0;
      for (const Offset& to : neighbours) {
        const int ni = i + stride * to.i;
        const int nj = j + stride * to.j;
        if (std::min(ni, nj) < 0 || std::max(ni, nj) >= samples) continue;
        lost_m += flow_m(old.at(i, j) - old.at(ni, nj), to.diagonal());
      }
      heights_m.at(i, j) -= lost_m;
    }
  });
}

}  // namespace

void slide(GroundMap<double>& heights_m, double talus_deg, int steps) {
  // Below 1/8: a sample never gives more than its excess over all eight neighbours.
  constexpr double fraction = 0.11;
  const double slope = math::tan(radians(talus_deg));
  for (int step = 0; step < steps; ++step) {
    const int stride = 16 >> (5 * step / steps);
    const double stable_m = slope * stride * heights_m.step_m();
    exchange(heights_m, stride, [&](double drop_m, bool diagonal) {
      const double limit_m = stable_m * (diagonal ? std::numbers::sqrt2 : 1.0);
      return fraction * (drop_m - std::clamp(drop_m, -limit_m, limit_m));
    });
  }
}

}  // namespace wold::terrain
