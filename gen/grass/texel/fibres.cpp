#include "grass/texel/fibres.h"

#include <algorithm>
#include <array>

#include "grass/geometry/axis.h"

namespace wold::grass {
namespace {

/// Of all leaves and stalks, in the order of the patch.
struct Standing {
  std::vector<std::size_t> blades;
  double mean_area = 0.0;  ///< of one, up to a factor
};

double posed_area(const BladePatch& patch, std::size_t i) {
  const Blade& blade = patch.blades[i];
  const BladePose& pose = patch.poses[i];
  return double{blade.length_m * pose.length_scale * blade.radius_m * pose.mesophyll_width};
}

Standing standing_blades(const BladePatch& patch) {
  Standing standing;
  double area = 0.0;
  for (std::size_t i = 0; i < patch.blades.size(); ++i) {
    if (sits_on_stalk(patch.blades[i])) continue;
    standing.blades.push_back(i);
    area += posed_area(patch, i);
  }
  standing.mean_area = area / static_cast<double>(standing.blades.size());
  return standing;
}

/// Petals and discs, one for as much of their area as `area`.
std::vector<std::size_t> parts_of_flowers(const BladePatch& patch, double area) {
  std::vector<std::size_t> chosen;
  double gathered = 0.5 * area;
  for (std::size_t i = 0; i < patch.blades.size(); ++i) {
    if (!sits_on_stalk(patch.blades[i])) continue;
    gathered += posed_area(patch, i);
    if (gathered < area) continue;
    chosen.push_back(i);
    gathered -= area;
  }
  return chosen;
}

}  // namespace

std::vector<Fibre> representative_fibres(const BladePatch& patch, const MeadowModel& model,
                                         int count) {
  // A cone has the fraction 1 - (1 - u)^2 of its area below u: these are the middles of thirds.
  constexpr std::array<float, 3> places = {0.087F, 0.293F, 0.592F};
  const Standing standing = standing_blades(patch);
  const std::size_t step = std::max(
      std::size_t{1}, standing.blades.size() * places.size() / static_cast<std::size_t>(count));
  std::vector<Fibre> fibres;
  const auto add = [&](std::size_t i) {
    const BladeAxis axis(patch.blades[i], patch.poses[i]);
    const float length_m = patch.blades[i].length_m * patch.poses[i].length_scale;
    for (const float along : places) {
      const AxisPoint at = axis.at(along * length_m);
      const SeenPlace seen = seen_place(patch, model, i, double{along}, at);
      fibres.push_back({from_plane(patch.blades[i], at.tangent), seen.albedo, seen.transmittance,
                        seen.specular, sits_on_stalk(patch.blades[i]) ? 1.0F : along});
    }
  };
  for (std::size_t number = 0; number < standing.blades.size(); number += step)
    add(standing.blades[number]);
  for (const std::size_t i :
       parts_of_flowers(patch, static_cast<double>(step) * standing.mean_area))
    add(i);
  return fibres;
}

}  // namespace wold::grass
