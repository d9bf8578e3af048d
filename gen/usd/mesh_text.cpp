#include "usd/mesh_text.h"

#include <fmt/format.h>

#include "usd/text.h"

namespace wold::usd {

std::string extent_text(std::span<const glm::vec3> points_m) {
  glm::vec3 low = points_m.front(), high = low;
  for (const glm::vec3& point_m : points_m) {
    low = glm::min(low, point_m);
    high = glm::max(high, point_m);
  }
  return fmt::format("[{}, {}]", vector(low), vector(high));
}

std::string quad_counts(std::size_t quads) {
  std::string text = "[";
  text.reserve(3 * quads + 2);
  for (std::size_t i = 0; i < quads; ++i) text += i > 0 ? ", 4" : "4";
  return text + "]";
}

}  // namespace wold::usd
