#include "cli/film.h"

#include <fmt/format.h>

#include <algorithm>

#include "blender/export.h"
#include "cli/cloud_textures.h"
#include "core/files.h"
#include "landscape/assemble.h"
#include "landscape/far_field.h"
#include "landscape/film_lighting.h"
#include "landscape/lit_ground.h"
#include "landscape/view.h"
#include "povray/export.h"
#include "scene/write.h"

namespace wold::cli {
namespace {

int coarsest_level(const scene::Grass& grass) { return static_cast<int>(grass.levels.size()) - 1; }

void export_program(const std::string& renderer, const std::filesystem::path& folder) {
  renderer == "blender" ? blender::export_scene(folder) : povray::export_scene(folder);
}

void export_frame(const std::string& renderer, const landscape::Landscape& landscape,
                  const std::filesystem::path& folder) {
  if (renderer == "blender") {
    blender::export_frame(landscape, folder);
  } else {
    povray::export_frame(landscape, folder);
  }
}

}  // namespace

std::vector<std::string> wanted_renderers(const scene::Scene& scene) {
  if (scene.render.renderer == "both") return {"blender", "povray"};
  return {scene.render.renderer};
}

Film::Film(const Job& job)
    : job_(job),
      site_(landscape::make_site(job.scene, job.out / "snow")),
      texels_(job.scene, landscape::film_lighting(job.scene, site_), job.out / "texels") {}

void Film::generate(Progress& progress) {
  make_folder(job_.out);
  write_file(job_.out / "scene.toml", scene::resolved_toml(job_.scene));
  choose_cells(progress);
  make_texels(progress);
  if (site_.clouds) write_cloud_textures(*site_.clouds, job_.out / "clouds");
  export_frames(progress);
}

void Film::choose_cells(Progress& progress) {
  progress.begin("cells", job_.frames.size());
  for (const int frame : job_.frames) {
    cells_.push_back(landscape::choose_cells(job_.scene, site_.terrain,
                                             landscape::growth_of_cells(site_), frame));
    for (const landscape::CellChoice& cell : cells_.back())
      if (!cell.blades) demand_[cell.variant][cell.state()][cell.level].insert(cell.turn);
    demand_far_field(frame);
    progress.advance(1, fmt::format("frame {}: {} cells", frame, cells_.back().size()));
  }
  progress.end();
}

void Film::demand_far_field(int frame) {
  const scene::Scene& scene = job_.scene;
  const landscape::Camera camera = landscape::resolved_camera(
      scene.camera, site_.terrain, landscape::time_of_frame(scene, frame));
  if (!landscape::shows_distance(scene, site_, camera)) return;
  for (const grass::PatchState& state : landscape::far_states(scene, frame))
    for (int variant = 0; variant < scene.grass.variants; ++variant)
      demand_[variant][state][coarsest_level(scene.grass)].insert(0);
}

void Film::make_texels(Progress& progress) { texels_.generate(demand_, progress); }

landscape::Volume Film::volume(const landscape::CellChoice& cell) const {
  const int side = job_.scene.grass.levels[static_cast<std::size_t>(cell.level)];
  const auto& turns = demand_.at(cell.variant).at(cell.state()).at(cell.level);
  landscape::Volume volume;
  volume.name = fmt::format("v{}_{}_q{}_{:03}", cell.variant, cell.state().name(), cell.turn, side);
  volume.vdb = texels_.volume_path(cell.variant, cell.state(), cell.level);
  volume.emission_grid = fmt::format("emission_q{}", cell.turn);
  volume.content = texels_.volume_content(cell.variant, cell.state(), cell.level, turns);
  volume.voxels = {side, side, texels_.level_shape(cell.level).height};
  volume.voxel_m = job_.scene.grass.patch_m / side;
  return volume;
}

landscape::BladeMesh Film::blades(const landscape::CellChoice& cell) {
  landscape::BladeMesh& mesh = blades_[{cell.variant, cell.state()}];
  if (mesh.tubes) return mesh;
  const bool points = job_.scene.render.grass == "points";
  mesh.name = fmt::format("{}{}_{}_{}", points ? 'p' : 'v', cell.variant, cell.state().name(),
                          texels_.content(cell.variant, cell.state()));
  mesh.tubes = std::make_shared<const Tubes>(points ? texels_.points(cell.variant, cell.state())
                                                    : texels_.blades(cell.variant, cell.state()));
  return mesh;
}

std::vector<landscape::Volume> Film::far_volumes(const grass::PatchState& state) const {
  std::vector<landscape::Volume> volumes;
  landscape::CellChoice choice;
  choice.key_frame = state.key_frame;
  choice.snow = state.snow;
  choice.level = coarsest_level(job_.scene.grass);
  for (; choice.variant < job_.scene.grass.variants; ++choice.variant)
    volumes.push_back(volume(choice));
  return volumes;
}

void Film::export_frames(Progress& progress) {
  const std::vector<std::string> renderers = wanted_renderers(job_.scene);
  const landscape::PatchLookup lookup = {
      [&](const landscape::CellChoice& cell) { return volume(cell); },
      [&](const landscape::CellChoice& cell) { return blades(cell); },
      [&](const grass::PatchState& state) { return far_volumes(state); }};
  for (const std::string& renderer : renderers) export_program(renderer, job_.out / renderer);
  progress.begin("scene files", job_.frames.size() * renderers.size());
  for (std::size_t i = 0; i < job_.frames.size(); ++i) {
    const landscape::Landscape landscape =
        landscape::assemble(job_.scene, site_, job_.frames[i], cells_[i], lookup);
    for (const std::string& renderer : renderers) {
      export_frame(renderer, landscape, job_.out / renderer);
      progress.advance(1, fmt::format("{} frame {}", renderer, job_.frames[i]));
    }
  }
  progress.end();
  // POV-Ray takes its settings from where it is started: `povray povray/scene.pov` from here, too.
  if (std::find(renderers.begin(), renderers.end(), "povray") != renderers.end())
    write_file(job_.out / "povray.ini", read_file(job_.out / "povray" / "povray.ini"));
}

}  // namespace wold::cli
