#include "work/file_sizes.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/elementary.h"
#include "meadow/cells.h"
#include "meadow/light_grids.h"
#include "place/cell_window.h"
#include "place/ground_grids.h"
#include "scene/key_frames.h"
#include "scene/species.h"
#include "sky/blowing_snow.h"
#include "sky/cloud_boxes.h"

namespace wold::work {
namespace {

constexpr double volume_header_bytes =
    20e3;  // names, tree and what else does not grow with its voxels

double squared(double number) { return number * number; }

/// Of a baked texel with its light for so many quarter-turns.
double baked_bytes(const VolumeSize& size, int turns) {
  constexpr double density_bytes = 2.1, emission_bytes = 2.7;  // per voxel with grass
  return volume_header_bytes + size.filled * (density_bytes + turns * emission_bytes);
}

/// Of the texel itself, which has fibres and colours in place of light.
double unlit_bytes(const VolumeSize& finest) {
  constexpr double voxel_bytes = 12.7;
  return volume_header_bytes + finest.filled * voxel_bytes;
}

/// Texels of painted grass are of the coarsest level, in all variants.
void add_painted(const scene::Scene& scene, const film::FilmDemand& demand,
                 std::set<std::tuple<int, grass::PatchState, int>>& lods) {
  const int coarsest = static_cast<int>(scene.grass.lods.size()) - 1;
  for (const auto& [frame, shown] : demand.frames()) {
    if (!shown.has_distance) continue;
    std::set<grass::PatchState> states;
    for (const film::ShownVolume& volume : shown.volumes) states.insert(volume.state);
    for (const grass::PatchState& state : states)
      for (const int mixture : demand.mixtures())
        for (int variant = 0; variant < scene.grass.variants; ++variant)
          lods.insert({scene::patch_number(scene, mixture, variant), state, coarsest});
  }
}

/// Whether snow gives the ground of a frame its own shape.
bool has_own_terrain(const scene::Scene& scene, const film::FrameDemand& shown) {
  return shown.has_snow && scene.snow_cover.cover == scene::CoverModel::depth;
}

/// Of the finer maps of the light near the eye. A usual camera looks over a square of about half
/// the width that they reach.
double light_detail_samples(const scene::Scene& scene, double cells_across_m) {
  double samples = 0.0;
  for (const double step_m : meadow::light_detail_steps_m(scene))
    samples += squared(std::min(cells_across_m / step_m, meadow::light_detail_reach_steps));
  return samples;
}

/// Of the largest of the maps that multiply the grass, which the others are brought to. On a large
/// terrain they are where cells are, and there are finer ones.
double light_samples(const scene::Scene& scene, const film::FrameDemand& shown) {
  const GroundGrid tint = place::tint_grid(scene);
  if (!place::is_large(scene)) return squared(tint.samples);
  const int samples = std::max(tint.samples, place::window_grid(scene).samples);
  const bool has_cells = shown.across_m > 0.0;
  return squared(samples * (has_cells ? std::min(1.0, shown.across_m / tint.square.size_m) : 1.0)) +
         light_detail_samples(scene, shown.across_m);
}

double volume_bytes(const scene::Scene& scene, const exporter::FileCosts& costs,
                    const VolumeSize& size) {
  return costs.shared_volume + density_bytes(scene, costs.shared_density_grids) * size.voxels +
         costs.shared_filled_voxel * size.filled;
}

double volumes_bytes(const scene::Scene& scene, const exporter::FileCosts& costs,
                     const film::FilmDemand& demand) {
  const VolumeSizes sizes(scene);
  double bytes = 0.0;
  for (const film::ShownVolume& volume : demand.volumes())
    bytes += volume_bytes(scene, costs, sizes.of(volume.variant, volume.state, volume.lod));
  for (const film::ShownVolume& texel : without_turns(demand.volumes()))
    bytes += density_bytes(scene, costs.shared_texel_grids) *
             sizes.of(texel.variant, texel.state, texel.lod).voxels;
  return bytes;
}

/// Light, what multiplies the grass, cells and sky of a frame.
double frame_bytes(const scene::Scene& scene, const exporter::FileCosts& costs,
                   const film::FrameDemand& shown) {
  double terrain_sample = costs.frame_terrain_sample;
  if (has_own_terrain(scene, shown)) terrain_sample += costs.shared_terrain_sample;
  return costs.frame + terrain_sample * squared(scene.terrain.samples) +
         costs.frame_ground_sample * ground_samples(scene, shown) +
         costs.frame_light_sample * light_samples(scene, shown) +
         costs.frame_part * static_cast<double>(shown.parts) +
         costs.frame_cloud_voxel * cloud_voxels(scene) +
         costs.frame_haze_voxel * sky::blowing_snow_voxels(scene);
}

/// The top of a patch's blades over their feet: leaves bow, stalks of flowers differ in length.
double standing_m(const SpeciesPatch& patch, double weathering, double snow) {
  const double length_m = patch.grass.height_m;
  if (patch.flower.petals > 0)
    return length_m * (1.0 + patch.grass.height_spread) + patch.flower.length_m;
  return length_m * std::max(1.15 - 0.62 * weathering, 0.73) * (1.0 - 0.5 * snow);
}

}  // namespace

VolumeSize volume_size(const SpeciesPatch& patch, int lod, double weathering, double snow) {
  const scene::Grass& grass = patch.grass;
  const scene::Flower& flower = patch.flower;
  const double side = grass.lods[static_cast<std::size_t>(lod)];
  const double voxel_m = grass.patch_m / side;
  const auto voxels_under = [&](double snow_fraction) {
    return side * side *
           ((grass.crown_m + standing_m(patch, weathering, snow_fraction)) / voxel_m + 2.0);
  };
  // A blade fills voxels along its length, as many beside each other as it is wide and, at its
  // borders, some more; a flower is a disc.
  constexpr double border = 2.5;
  const double length_m = grass.height_m * (1.17 - 0.3 * weathering);
  const double of_flower =
      flower.petals > 0 ? border * squared(2.0 * flower.length_m / voxel_m + border) : 0.0;
  const double of_blades =
      grass.blades * (length_m / voxel_m * squared(grass.width_m / voxel_m + border) + of_flower);
  // Blades stand in clumps and share voxels more often than by chance: the share that is empty is
  // that of a negative binomial distribution, not of Poisson's. Snow presses them down, and what
  // lies on them fills as many voxels as they lose.
  constexpr double clumping = 0.3;
  const double without_snow = voxels_under(0.0), voxels = voxels_under(snow);
  const double empty = math::pow(1.0 + of_blades / without_snow / clumping, -clumping);
  return {voxels, std::min(voxels, without_snow * (1.0 - empty))};
}

VolumeSizes::VolumeSizes(const scene::Scene& scene)
    : variants_(scene.grass.variants), key_frames_(scene::key_frames(scene)) {
  const std::vector<scene::Species> species = scene::species_of(scene);
  for (const scene::Mixture& mixture : scene::mixtures_of(scene)) {
    const std::vector<int> blades = scene::blades_of(scene, mixture);
    std::vector<SpeciesPatch>& alone = species_.emplace_back();
    for (std::size_t i = 0; i < mixture.size(); ++i) {
      const scene::Species& one = species[static_cast<std::size_t>(mixture[i])];
      SpeciesPatch& patch = alone.emplace_back(SpeciesPatch{scene.grass, one.flower});
      static_cast<scene::Plant&>(patch.grass) = one.plant;
      patch.grass.blades = blades[i];
    }
  }
}

VolumeSize VolumeSizes::of(int variant, const grass::PatchState& state, int lod) const {
  VolumeSize size;
  for (const SpeciesPatch& patch : species_.at(static_cast<std::size_t>(variant / variants_))) {
    const VolumeSize alone =
        volume_size(patch, lod, key_frames_.at(static_cast<std::size_t>(state.key_frame)),
                    state.snow_fraction());
    size.voxels = std::max(size.voxels, alone.voxels);
    size.filled += alone.filled;
  }
  size.filled = std::min(size.filled, size.voxels);
  return size;
}

std::set<film::ShownVolume> without_turns(const std::set<film::ShownVolume>& volumes) {
  std::set<film::ShownVolume> texels;
  for (film::ShownVolume volume : volumes) {
    volume.turn = 0;
    texels.insert(volume);
  }
  return texels;
}

double density_bytes(const scene::Scene& scene, double grids) {
  return grids * scene.render.df3_bits / 8.0;
}

double ground_samples(const scene::Scene& scene, const film::FrameDemand& shown) {
  const bool is_white_everywhere =
      !place::is_large(scene) || scene.snow_cover.cover == scene::CoverModel::paper;
  return shown.has_snow && is_white_everywhere ? squared(place::snow_grid(scene).samples)
                                               : ground_samples(scene);
}

double ground_samples(const scene::Scene& scene) {
  if (!place::is_large(scene)) return squared(place::picture_grid(scene).samples);
  double samples = squared(place::whole_grid(scene).samples);
  for (const GroundGrid& grid : place::detail_grids(scene, {})) samples += squared(grid.samples);
  return samples;
}

double cloud_voxels(const scene::Scene& scene) {
  const auto layers = static_cast<double>(
      std::ranges::count(scene.clouds, scene::CloudBody::volume, &scene::CloudLayer::body));
  const glm::dvec3 voxels(sky::cloud_box_voxels);
  return layers * voxels.x * voxels.y * voxels.z;
}

double texel_bytes(const scene::Scene& scene, const film::FilmDemand& demand, bool with_unlit) {
  std::set<std::tuple<int, grass::PatchState, int>> lods;
  for (const film::ShownVolume& volume : demand.volumes())
    lods.insert({volume.variant, volume.state, volume.lod});
  add_painted(scene, demand, lods);
  std::set<film::BladePatchState> unlit;
  const VolumeSizes sizes(scene);
  double bytes = 0.0;
  for (const auto& [variant, state, lod] : lods) {
    unlit.insert({variant, state.unlit()});
    bytes += baked_bytes(sizes.of(variant, state, lod), meadow::turns_of_lod(scene, lod));
  }
  if (with_unlit)
    for (const auto& [variant, state] : unlit) bytes += unlit_bytes(sizes.of(variant, state, 0));
  return bytes;
}

double cloud_picture_bytes(const scene::Scene& scene) {
  return 2e6 * static_cast<double>(scene.clouds.size());
}

SceneBytes scene_bytes(const scene::Scene& scene, const exporter::FileCosts& costs,
                       const film::FilmDemand& demand) {
  const bool some_is_bare = std::ranges::any_of(
      demand.frames(), [&](const auto& one) { return !has_own_terrain(scene, one.second); });
  double shared = volumes_bytes(scene, costs, demand);
  if (some_is_bare) shared += costs.shared_terrain_sample * squared(scene.terrain.samples);
  for (const auto& [variant, state] : demand.patches())
    shared += costs.shared_blade * static_cast<double>(scene::drawn_of(scene, variant));
  double looked_at = 0.0;
  for (const auto& [frame, shown] : demand.frames()) looked_at += frame_bytes(scene, costs, shown);
  return {shared, looked_at / static_cast<double>(demand.frames().size())};
}

double pass_bytes(const scene::Scene& scene, std::span<const passes::Pass> passes) {
  constexpr double packed = 0.5;  // what packing by run lengths leaves
  double pixel_bytes = 0.0;
  for (const passes::Pass pass : passes)
    pixel_bytes += packed * passes::bytes_per_pixel(pass, scene::species_of(scene).size() + 2);
  return pixel_bytes * scene.render.size_px[0] * scene.render.size_px[1];
}

double picture_bytes(const scene::Scene& scene) {
  constexpr double pixel_bytes = 2.0;  // of a PNG
  return pixel_bytes * scene.render.size_px[0] * scene.render.size_px[1];
}

}  // namespace wold::work
