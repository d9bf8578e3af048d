#include "wind/wave_sum.h"

#include "core/simd_turns.h"

namespace wold::wind {

void WaveSum::add(const glm::dvec2& per_m, double phase, double height) {
  const std::size_t lane = count_++ % lanes;
  if (lane == 0) groups_.emplace_back();
  Group& group = groups_.back();
  group.east_per_m[lane] = per_m.x;
  group.north_per_m[lane] = per_m.y;
  group.phase[lane] = off_whole(phase);
  group.height[lane] = static_cast<float>(height);
}

double WaveSum::at(const glm::dvec2& place_m) const {
  std::array<float, lanes> sums{};
  for (const Group& group : groups_)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double turns = group.east_per_m[lane] * place_m.x +
                           group.north_per_m[lane] * place_m.y + group.phase[lane];
      sums[lane] += group.height[lane] * cosine_of_turns(static_cast<float>(off_whole(turns)));
    }
  double sum = 0.0;
  for (const float one : sums) sum += double{one};
  return sum;
}

}  // namespace wold::wind
