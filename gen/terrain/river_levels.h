#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace wold::terrain {

/// How high water stands in a river, of which a map of heights knows the ground, with the banks in
/// its cells and some metres of error.
///
/// `places`: cells that hang together by sides or corners, one at least, of which each is there
/// once; `heights_m`: measured in each; `step_m`: from a cell to the next. Levels are about those
/// heights or lower, even across the river, and rise on the way from the lowest place upstream, but
/// for centimetres. None where they rise by more than a tenth of all of that way, as water is no
/// mirror there, or where a tenth of it would have to be 25 m below what was measured: that is no
/// river's way.
std::optional<std::vector<double>> river_levels_m(std::span<const glm::ivec2> places,
                                                  std::span<const double> heights_m, double step_m);

}  // namespace wold::terrain
