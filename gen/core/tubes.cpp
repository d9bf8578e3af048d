#include "core/tubes.h"

namespace wold {

std::vector<std::uint32_t> quad_corners(const Tubes& tubes) {
  const auto rings = static_cast<std::uint32_t>(tubes.rings);
  const auto corners = static_cast<std::uint32_t>(tubes.corners);
  std::vector<std::uint32_t> quads;
  for (std::uint32_t tube = 0; tube < tubes.count(); ++tube)
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      const std::uint32_t lower = (tube * rings + ring) * corners;
      const std::uint32_t upper = lower + corners;
      for (std::uint32_t corner = 0; corner < corners; ++corner) {
        const std::uint32_t next = (corner + 1) % corners;
        quads.insert(quads.end(), {lower + corner, lower + next, upper + next, upper + corner});
      }
    }
  return quads;
}

}  // namespace wold
