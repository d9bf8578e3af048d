#include "grass/mechanics/wall.h"

#include <algorithm>

namespace wold::grass {

void dry(Wall& wall, const std::array<double, vein_segments>& turns, double water_lost,
         double stiffening) {
  const double dried = water_lost - wall.most_lost;
  if (dried <= 0.0) return;
  const double rate = stiffening / (1.0 + stiffening * wall.most_lost) + wall_creep;
  const double share = std::min(rate * dried, 1.0);
  for (std::size_t k = 0; k < turns.size(); ++k) wall.set[k] += share * (turns[k] - wall.set[k]);
  wall.most_lost = water_lost;
}

}  // namespace wold::grass
