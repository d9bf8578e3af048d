#pragma once

#include <vector>

#include "core/ground_map.h"
#include "landscape/landscape.h"
#include "scene/scene.h"

namespace wold::place {

/// The grid of the picture of the ground of a terrain that is not large (is_large()): steps of 3
/// cm, finer ones, down to 5 mm, where the scene's picture is large enough to show them; at most
/// 4097 samples along a side.
GroundGrid picture_grid(const scene::Scene& scene);

/// The grid of the picture of the ground where snow lies on all of the terrain at once: that of
/// picture_grid(), or steps of 2 cm where those are finer, for white spots have sharp edges.
GroundGrid snow_grid(const scene::Scene& scene);

/// The grids of the pictures of a large terrain's ground.
///
/// The whole terrain, and about the camera squares of half of the side of the one before; below 150
/// m, where grass covers most of the ground, of a quarter; down to steps of 1 cm. These squares
/// have one and a half samples per pixel and radian along a side, the whole terrain has two, at
/// most 2049. The eye stands at a fifth of a square's side from its rear. So what lies before it
/// beyond a square is at least two fifths of the next coarser one's side away, where a step
/// covers 1.7 pixels at most, below 150 m 3.4; at 1920 pixels and 55 degrees, where 2049 are too
/// few, 2.3 and 4.5.
GroundGrid whole_grid(const scene::Scene& scene);

/// Coarse to fine, all with as many samples; they lie on their own steps, whole numbers of them
/// apart when the camera moves. They may reach beyond the terrain. None for terrains that are not
/// large.
std::vector<GroundGrid> detail_grids(const scene::Scene& scene, const landscape::Camera& camera);

/// Of the light on a large terrain's grass, in the CellWindow.
GroundGrid window_grid(const scene::Scene& scene);

/// The grid of the grass's tint from place to place, in the CellWindow: eight steps a patch, at
/// most 4097 samples along a side, of large terrains 2049.
GroundGrid tint_grid(const scene::Scene& scene);

/// Along a side of the squares of snow about the camera: one per pixel and radian, at most 1024.
int cover_samples(const scene::Scene& scene);

}  // namespace wold::place
