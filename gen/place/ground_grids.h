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

/// The grids of the pictures of a large terrain's ground.
///
/// The whole terrain, and about the camera squares of a quarter of the side of the one before, down
/// to steps of 1 cm. All have the same number of samples. The eye stands at a fifth of a square's
/// side from its rear, so that what lies beyond a square is at least a fifth of the next coarser
/// one's side away: with two samples per pixel and radian a step there covers 2.5 pixels at most.
GroundGrid whole_grid(const scene::Scene& scene);

/// Coarse to fine; they lie on their own steps, whole numbers of them apart when the camera moves.
/// They may reach beyond the terrain. None for terrains that are not large.
std::vector<GroundGrid> detail_grids(const scene::Scene& scene, const landscape::Camera& camera);

/// Of the maps that multiply the grass in the CellWindow.
GroundGrid window_grid(const scene::Scene& scene);

/// Along a side of the squares of snow about the camera: twice as coarse as the pictures' are.
int cover_samples(const scene::Scene& scene);

}  // namespace wold::place
