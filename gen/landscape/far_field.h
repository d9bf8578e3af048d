#pragma once

#include <map>

#include "core/ground_map.h"
#include "landscape/patch_look.h"
#include "landscape/view.h"
#include "scene/scene.h"

namespace wold::landscape {

/// How far grass at a place is painted on the ground instead of standing on it: 0 near, 1 where it
/// looks lower than three quarters of grass.far_pixels, rising smoothly from five quarters on, so
/// that no line shows.
double far_share(const scene::Grass& grass, const View& view, const glm::dvec3& at_m);

/// Whether any of the terrain's grass is painted, seen so.
bool has_far_field(const scene::Scene& scene, const Heightfield& terrain, const View& view);

/// The key frames whose looks paint_far_grass() needs in a frame (from 1), ascending.
std::vector<int> far_key_frames(const scene::Scene& scene, int frame);

/// Paints the far grass over the ground's radiance by its share: what the key frames' looks,
/// `looks` by key frame, show along the line of sight, under the light there, over the ground.
void paint_far_grass(ColourMap& ground, const scene::Scene& scene, const Heightfield& terrain,
                     const FactorMap& growth, const ColourMap& light, const View& view, int frame,
                     const std::map<int, PatchLook>& looks);

/// Factor on the extinction of the grass that stands: its growth without the far share, over the
/// slope's cosine, which keeps the density per square metre of ground.
FactorMap standing_grass(const scene::Scene& scene, const Heightfield& terrain,
                         const FactorMap& growth, const View& view);

}  // namespace wold::landscape
