#include "grass/mechanics/wall.h"

#include <algorithm>

namespace wold::grass {

void dry(Wall& wall, const std::array<double, vein_segments>& turns, double water_lost,
         double stiffening) {
  const double dried = water_lost - wall.max_lost;
  if (dried <= 0.0) return;
  const double rate = stiffening / (1.0 + stiffening * wall.max_lost) + wall_creep;
  const double fraction = std::min(rate * dried, 1.0);
  for (std::size_t k = 0; k < turns.size(); ++k) wall.set[k] += fraction * (turns[k] - wall.set[k]);
  wall.max_lost = water_lost;
}

}  // namespace wold::grass
