#include "grass/geometry/crown.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/random.h"

namespace wold::grass {
namespace {

constexpr double radius_over_crown = 0.55;  ///< of the highest cushion
constexpr double coverage = 2.5;            ///< cushions over ground
constexpr double max_margin = 0.3;          ///< of the patch, for leaves
constexpr double lowest = 0.55;             ///< cushion over the highest
constexpr double max_cushions = 1000.0;
constexpr double hollow = 1.0 / 3.0;  ///< of a radius, without twigs

}  // namespace

Crown::Crown(const Size& size, std::uint64_t seed, int variant) {
  const double margin_m = std::min(size.leaf_m, max_margin * size.patch_m);
  const double inner_m = size.patch_m - 2.0 * margin_m;
  const double max_radius_m = std::min(radius_over_crown * size.crown_m, 0.5 * inner_m);
  const double one_m2 = std::numbers::pi * max_radius_m * max_radius_m;
  const auto count =
      std::lround(std::clamp(coverage * inner_m * inner_m / one_m2, 1.0, max_cushions));
  for (long number = 0; number < count; ++number) {
    const auto drawn = [&](const char* what) {
      const auto index =
          (static_cast<std::uint64_t>(variant) << 32) | static_cast<std::uint64_t>(number);
      return random_uniform({seed, key_of("cushion"), index, key_of(what)});
    };
    // One reaches the whole height, so that the crown is as high as it says.
    const double part = number == 0 ? 1.0 : std::lerp(lowest, 1.0, drawn("height"));
    const double radius_m = part * max_radius_m;
    const glm::dvec2 place(drawn("x"), drawn("y"));
    cushions_.push_back(
        {margin_m + radius_m + (inner_m - 2.0 * radius_m) * place, radius_m, part * size.crown_m});
  }
}

Crown::Twig Crown::twig(const glm::dvec4& picks) const {
  const auto count = static_cast<double>(cushions_.size());
  const Cushion& cushion =
      cushions_[static_cast<std::size_t>(std::min(picks.x * count, count - 1.0))];
  // Even on half a sphere, and as volume is from the hollow to the surface.
  const double up = picks.y, level = std::sqrt(1.0 - up * up);
  const double turn = 2.0 * std::numbers::pi * picks.z;
  const glm::dvec2 heading(math::cos(turn), math::sin(turn));
  const double inner = hollow * hollow * hollow;
  const double radii = math::cbrt(std::lerp(inner, 1.0, picks.w));
  const glm::dvec2 place_m = cushion.middle_m + radii * cushion.radius_m * level * heading;
  const glm::dvec3 gradient(heading * (level / cushion.radius_m), up / cushion.height_m);
  return {glm::vec2(place_m), static_cast<float>(radii * cushion.height_m * up),
          glm::vec3(glm::normalize(gradient)), static_cast<float>(0.5 * cushion.radius_m)};
}

Crown crown_of(const scene::Plant& shrub, double patch_m, std::uint64_t seed, int variant) {
  return {{shrub.crown_m, patch_m, shrub.height_m * (1.0 + shrub.height_spread)}, seed, variant};
}

}  // namespace wold::grass
