#include "meadow/blade_parts.h"

#include <utility>

namespace wold::meadow {
namespace {

/// In fractions of the patch.
glm::dvec2 root_of(const Tubes& tubes, std::size_t tube, double patch_m) {
  const auto corners = static_cast<std::size_t>(tubes.corners);
  const std::size_t first = tube * static_cast<std::size_t>(tubes.rings) * corners;
  glm::dvec2 sum_m(0.0);
  for (std::size_t corner = 0; corner < corners; ++corner)
    sum_m += glm::dvec2(tubes.vertices_m[first + corner]);
  return sum_m / (tubes.corners * patch_m);
}

/// A part's borders belong to its upper neighbours, the patch's own to the parts within.
bool stands_on(const landscape::Part& part, const glm::dvec2& fraction) {
  for (int axis = 0; axis < 2; ++axis) {
    if (part.low[axis] > 0.0 && fraction[axis] < part.low[axis]) return false;
    if (part.high[axis] < 1.0 && fraction[axis] >= part.high[axis]) return false;
  }
  return true;
}

template <class T>
void append(const std::vector<T>& from, std::size_t number, std::size_t per_tube,
            std::vector<T>& to) {
  const auto first = from.begin() + static_cast<std::ptrdiff_t>(number * per_tube);
  to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(per_tube));
}

}  // namespace

landscape::BladeMesh part_of(const landscape::BladeMesh& mesh, double patch_m,
                             const landscape::Part& part) {
  if (part.is_whole()) return mesh;
  const Tubes& all = *mesh.tubes;
  const auto rings = static_cast<std::size_t>(all.rings);
  Tubes tubes{all.rings, all.corners, {}, {}};
  for (std::size_t tube = 0; tube < all.count(); ++tube) {
    if (!stands_on(part, root_of(all, tube, patch_m))) continue;
    append(all.vertices_m, tube, rings * static_cast<std::size_t>(all.corners), tubes.vertices_m);
    append(all.radiance, tube, rings, tubes.radiance);
    if (all.reflectance.empty()) continue;
    append(all.reflectance, tube, rings, tubes.reflectance);
    append(all.transmittance, tube, rings, tubes.transmittance);
  }
  return {mesh.name + landscape::suffix_of(part), std::make_shared<const Tubes>(std::move(tubes))};
}

}  // namespace wold::meadow
