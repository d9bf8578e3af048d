#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/image.h"
#include "landscape/landscape.h"

namespace wold::preview {

/// A terrain from straight above as a map shows it, north up, in encoded sRGB: relief in the light
/// of the north-west, green below and brown above, contour lines, of which each fifth is strong,
/// paths (terrain::Paths::lines_m()), and where a camera stands and how wide it looks. Corners are
/// labelled with their places, in metres or kilometres, unless `font` is empty.
Image relief_map(const Heightfield& terrain, const landscape::Camera& camera,
                 const std::vector<std::vector<glm::dvec2>>& paths_m, int width_px,
                 const std::filesystem::path& font);

/// Metres between its contour lines: 1, 2 or 5 times a power of ten, 8 to 20 lines between the
/// lowest and the highest place. 0 where the terrain is level.
double contour_interval_m(const Heightfield& terrain);

}  // namespace wold::preview
