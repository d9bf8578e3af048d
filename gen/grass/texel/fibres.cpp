#include "grass/texel/fibres.h"

#include <algorithm>
#include <array>

#include "grass/geometry/axis.h"

namespace wold::grass {
namespace {

/// Of the petals of a flower, which together have about the area of a blade, the first alone.
std::vector<std::size_t> standing_for_others(const std::vector<Blade>& blades) {
  std::vector<std::size_t> standing;
  for (std::size_t i = 0; i < blades.size(); ++i)
    if (!sits_on_stalk(blades[i]) || !sits_on_stalk(blades[i - 1])) standing.push_back(i);
  return standing;
}

}  // namespace

std::vector<Fibre> representative_fibres(const BladePatch& patch, const MeadowModel& model,
                                         int count) {
  // A cone has the fraction 1 - (1 - u)^2 of its area below u: these are the middles of thirds.
  constexpr std::array<float, 3> places = {0.087F, 0.293F, 0.592F};
  const std::vector<std::size_t> standing = standing_for_others(patch.blades);
  const std::size_t step =
      std::max(std::size_t{1}, standing.size() * places.size() / static_cast<std::size_t>(count));
  std::vector<Fibre> fibres;
  for (std::size_t number = 0; number < standing.size(); number += step) {
    const std::size_t i = standing[number];
    const BladeAxis axis(patch.blades[i], patch.poses[i]);
    const float length_m = patch.blades[i].length_m * patch.poses[i].length_scale;
    for (const float along : places) {
      const AxisPoint at = axis.at(along * length_m);
      const SeenPlace seen = seen_place(patch, model, i, double{along}, at);
      fibres.push_back({from_plane(patch.blades[i], at.tangent), seen.albedo, seen.transmittance,
                        seen.specular, along});
    }
  }
  return fibres;
}

}  // namespace wold::grass
