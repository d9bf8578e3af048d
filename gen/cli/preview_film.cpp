#include "cli/preview_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/progress.h"
#include "landscape/assemble.h"
#include "landscape/cell_window.h"
#include "landscape/cells.h"
#include "landscape/far_field.h"
#include "landscape/film_lights.h"

namespace wold::cli {
namespace fs = std::filesystem;
namespace {

constexpr int most_samples = 289;        ///< of terrain and ground, along a side
constexpr double most_blades = 40000.0;  ///< that stand before the camera
constexpr int widest_of_large_px = 176;
constexpr int voxels = 30;  ///< of the texel that far grass is looked up in

/// How low grass looks where so few blades stand nearer to the camera that they can be drawn: a
/// sector of the circle around it.
double standing_pixels(const scene::Scene& scene) {
  const double half_angle = 0.5 * scene.camera.field_of_view_deg * std::numbers::pi / 180.0;
  const double blades_per_m2 = scene.grass.blades / (scene.grass.patch_m * scene.grass.patch_m);
  const double radius_m = std::sqrt(most_blades / blades_per_m2 / half_angle);
  const double pixels_per_radian = 0.5 * scene.render.size_px[0] / std::tan(half_angle);
  return scene.grass.height_m * pixels_per_radian / radius_m;
}

}  // namespace

scene::Scene simplified(scene::Scene scene, int width_px) {
  // The pictures of a large terrain's ground are as fine as the camera's picture.
  if (landscape::is_large(scene)) width_px = std::min(width_px, widest_of_large_px);
  const double aspect = static_cast<double>(scene.render.size_px[1]) / scene.render.size_px[0];
  scene.render.size_px = {width_px, std::max(1, static_cast<int>(std::lround(aspect * width_px)))};
  scene.render.grass = "blades";
  scene.terrain.samples = std::min(scene.terrain.samples, most_samples);
  scene.grass.levels = {voxels};
  scene.grass.variants = std::min(scene.grass.variants, 2);
  scene.grass.far_pixels = std::max(scene.grass.far_pixels, standing_pixels(scene));
  for (scene::CloudLayer& layer : scene.clouds) layer.body = "sheet";
  return scene;
}

PreviewFilm::PreviewFilm(const scene::Scene& scene, const std::vector<int>& frames,
                         const fs::path& scratch)
    : scene_(scene),
      site_(landscape::make_site(scene, scratch / "snow", most_samples)),
      texels_(scene, landscape::film_lights(scene, site_), scratch / "texels") {
  grass::TexelDemand demand;
  for (const int frame : frames)
    for (const grass::PatchState& state : landscape::far_states(scene, *site_.withering, frame))
      demand[0][state][0] = {0};
  SilentProgress silent;
  texels_.generate(demand, silent);
}

landscape::PatchLook PreviewFilm::far_look(const grass::PatchState& state) const {
  landscape::Volume volume;
  volume.vdb = texels_.volume_path(0, state, 0);
  volume.emission_grid = "emission_q0";
  volume.voxels = {voxels, voxels, texels_.level_shape(0).height};
  volume.voxel_m = scene_.grass.patch_m / voxels;
  return landscape::PatchLook(std::span(&volume, 1));
}

Tubes PreviewFilm::blades(int variant, const grass::PatchState& state) const {
  constexpr double pixels_of_shadows = 128.0;  // along a patch
  return texels_.blades(variant, state, scene_.grass.patch_m / pixels_of_shadows);
}

landscape::BladeMesh PreviewFilm::mesh(int variant, const grass::PatchState& state) {
  landscape::BladeMesh& mesh = meshes_[{variant, state}];
  if (!mesh.tubes)
    mesh = {fmt::format("v{}_{}", variant, state.name()),
            std::make_shared<const Tubes>(blades(variant, state))};
  return mesh;
}

landscape::Landscape PreviewFilm::assembled(const scene::Scene& scene, int frame) {
  const auto cells = landscape::choose_cells(
      scene, site_.terrain, landscape::growth_of_cells(site_), *site_.withering, frame);
  return landscape::assemble(
      scene, landscape::site_of_frame(scene, site_, frame), frame, cells,
      {{},
       [&](const landscape::CellChoice& cell) { return mesh(cell.variant, cell.state()); },
       [&](const grass::PatchState& state) { return far_look(state); }});
}

landscape::Landscape PreviewFilm::landscape(int frame) { return assembled(scene_, frame); }

landscape::Landscape PreviewFilm::overview(int frame, const scene::Camera& camera,
                                           const glm::ivec2& size_px) {
  scene::Scene scene = scene_;
  scene.camera = camera;
  scene.render.size_px = {size_px.x, size_px.y};
  scene.sky.visual_range_m = 1e6;
  scene.grass.far_pixels = 1e9;
  landscape::Landscape landscape = assembled(scene, frame);
  landscape.fog.reset();
  landscape.flakes.flakes.clear();
  landscape.backdrop.reset();
  return landscape;
}

}  // namespace wold::cli
