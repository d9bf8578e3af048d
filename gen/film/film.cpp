#include "film/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "blender/export.h"
#include "blender/volume_stack.h"
#include "core/error.h"
#include "core/files.h"
#include "film/assemble.h"
#include "film/cloud_textures.h"
#include "grass/texel/texel_file.h"
#include "ground/lit_ground.h"
#include "meadow/far_field.h"
#include "meadow/film_lights.h"
#include "mitsuba/export.h"
#include "place/view.h"
#include "povray/export.h"
#include "scene/calendar.h"

namespace wold::film {
namespace fs = std::filesystem;
namespace {

int coarsest_level(const scene::Grass& grass) { return static_cast<int>(grass.levels.size()) - 1; }

std::vector<fs::path> export_frame(const std::string& renderer,
                                   const landscape::Landscape& landscape, const fs::path& folder) {
  if (renderer == "mitsuba") return mitsuba::export_frame(landscape, folder);
  return renderer == "blender" ? blender::export_frame(landscape, folder)
                               : povray::export_frame(landscape, folder);
}

/// Whether an exporter asks for the landscape without light.
bool wants_unlit(const scene::Scene& scene) { return scene.render.renderer == "mitsuba"; }

/// Blender leaves volumes out where too many lie over each other, without a word: on sharply bent
/// ground, where a patch is laid in many parts, or behind many clouds.
void check_overlaps(const landscape::Landscape& landscape, Progress& progress) {
  const int deepest = blender::deepest_volume_stack(landscape);
  if (deepest < blender::many_volumes) return;
  const std::string found = fmt::format(
      "frame {}: {} volumes lie over one place before the camera, and Blender leaves out what is "
      "beyond {}; set grass.patch to less, render.grass = \"blades\" or render.renderer = "
      "\"povray\"",
      landscape.frame, deepest, blender::volumes_on_a_stack - 1);
  if (deepest >= blender::volumes_on_a_stack) throw InputError(found);
  progress.say("warning: " + found);
}

/// All that cells may use. Which of them do depends on the frames; a file must not.
std::set<int> turns_of(const scene::Scene& scene, int level) {
  std::set<int> turns;
  for (int turn = 0; turn < meadow::turns_of_level(scene, level); ++turn) turns.insert(turn);
  return turns;
}

std::vector<povray::FrameMoment> moments_of(const scene::Scene& scene) {
  std::vector<povray::FrameMoment> moments;
  for (const double weathering : scene.ageing.frames) {
    const int frame = static_cast<int>(moments.size()) + 1;
    moments.push_back({frame, weathering, scene::time_s(scene, frame)});
  }
  return moments;
}

}  // namespace

std::vector<std::string> wanted_renderers(const scene::Scene& scene) {
  if (scene.render.renderer == "both") return {"blender", "povray"};
  return {scene.render.renderer};
}

void write_programs(const scene::Scene& scene, const fs::path& out) {
  if (std::ranges::count(wanted_renderers(scene), "povray") == 0) return;
  const std::array<int, 2>& size_px = scene.render.size_px;
  povray::export_scene(moments_of(scene), out / "povray");
  povray::export_settings({size_px[0], size_px[1]}, scene.render.samples, out / "povray");
}

Film::Film(const Request& request)
    : request_(request),
      snow_(request.out / "snow"),
      site_(place::make_site(request.scene, snow_.path())),
      texels_(request.scene, meadow::film_lights(request.scene, site_), request.out / "texels") {}

void Film::find_demand(Progress& progress) {
  progress.begin("cells", request_.frames.size());
  for (const int frame : request_.frames) {
    const std::vector<meadow::CellChoice> cells = cells_of(frame);
    for (const meadow::CellChoice& cell : cells)
      if (!cell.blades) demand(cell.variant, cell.state(), cell.level);
    demand_far_field(frame);
    progress.advance(1, fmt::format("frame {}: {} cells", frame, cells.size()));
  }
  progress.end();
}

std::vector<meadow::CellChoice> Film::cells_of(int frame) const {
  return meadow::choose_cells(request_.scene, site_.terrain, place::growth_of_cells(site_),
                              *site_.withering, frame);
}

void Film::demand_far_field(int frame) {
  const scene::Scene& scene = request_.scene;
  if (!ground::shows_distance(scene, site_, frame)) return;
  for (const grass::PatchState& state : meadow::far_states(scene, *site_.withering, frame))
    for (int variant = 0; variant < scene.grass.variants; ++variant)
      demand(variant, state, coarsest_level(scene.grass));
}

void Film::demand(int variant, const grass::PatchState& state, int level) {
  std::set<int>& turns = demand_[variant][state][level];
  if (turns.empty()) turns = turns_of(request_.scene, level);
}

std::vector<fs::path> Film::make_texels(int variant, Progress& progress) const {
  const auto wanted = demand_.find(variant);
  if (wanted == demand_.end()) return {};
  texels_.generate({*wanted}, progress);
  std::vector<fs::path> files;
  for (const auto& [state, levels] : wanted->second) {
    if (const fs::path texel = texels_.texel_path(variant, state);
        files.empty() || std::ranges::count(files, texel) == 0)
      files.push_back(texel);
    for (const auto& level : levels)
      files.push_back(texels_.volume_path(variant, state, level.first));
  }
  return files;
}

std::vector<fs::path> Film::make_cloud_pictures() const {
  if (!site_.clouds) return {};
  return write_cloud_textures(*site_.clouds, request_.out / "clouds");
}

landscape::Volume Film::volume(const meadow::CellChoice& cell) const {
  const int side = request_.scene.grass.levels[static_cast<std::size_t>(cell.level)];
  landscape::Volume volume;
  volume.name = fmt::format("v{}_{}_q{}_{:03}", cell.variant, cell.state().name(), cell.turn, side);
  volume.vdb = texels_.volume_path(cell.variant, cell.state(), cell.level);
  volume.emission_grid = fmt::format("emission_q{}", cell.turn);
  if (wants_unlit(request_.scene)) volume.texel = texels_.texel_path(cell.variant, cell.state());
  volume.content = texels_.volume_content(cell.variant, cell.state(), cell.level,
                                          turns_of(request_.scene, cell.level));
  volume.voxels = {side, side, texels_.level_shape(cell.level).height};
  volume.voxel_m = request_.scene.grass.patch_m / side;
  if (grass::file_content(volume.vdb) != volume.content)
    throw FileError(
        fmt::format("{} is missing, damaged or of another scene; expected that of this one: run "
                    "the task \"texels {}\" of these frames first",
                    volume.vdb.string(), cell.variant + 1));
  return volume;
}

landscape::BladeMesh Film::blades(const meadow::CellChoice& cell) {
  landscape::BladeMesh& mesh = blades_[{cell.variant, cell.state()}];
  if (mesh.tubes) return mesh;
  const bool points = request_.scene.render.grass == "points";
  mesh.name = fmt::format("{}{}_{}_{}", points ? 'p' : 'v', cell.variant, cell.state().name(),
                          texels_.content(cell.variant, cell.state()));
  Tubes tubes = points ? texels_.points(cell.variant, cell.state())
                       : texels_.blades(cell.variant, cell.state());
  if (wants_unlit(request_.scene) && !points)
    texels_.add_leaf_shades(cell.variant, cell.state(), tubes);
  mesh.tubes = std::make_shared<const Tubes>(std::move(tubes));
  return mesh;
}

/// Kept from frame to frame: to measure one takes a tenth of a second.
meadow::PatchLook Film::far_look(const grass::PatchState& state) {
  if (const auto known = far_looks_.find(state); known != far_looks_.end()) return known->second;
  std::vector<landscape::Volume> volumes;
  meadow::CellChoice choice;
  choice.key_frame = state.key_frame;
  choice.snow = state.snow;
  choice.light = state.light;
  choice.level = coarsest_level(request_.scene.grass);
  for (; choice.variant < request_.scene.grass.variants; ++choice.variant)
    volumes.push_back(volume(choice));
  return far_looks_.emplace(state, volumes).first->second;
}

std::vector<fs::path> Film::make_frame(int frame, Progress& progress) {
  const PatchLookup lookup = {[&](const meadow::CellChoice& cell) { return volume(cell); },
                              [&](const meadow::CellChoice& cell) { return blades(cell); },
                              [&](const grass::PatchState& state) { return far_look(state); }};
  const std::vector<std::string> renderers = wanted_renderers(request_.scene);
  progress.begin(fmt::format("scene files of frame {}", frame), 1 + renderers.size());
  const landscape::Landscape landscape =
      assemble(request_.scene, place::site_of_frame(request_.scene, site_, frame), frame,
               cells_of(frame), lookup, wants_unlit(request_.scene));
  progress.advance(1, fmt::format("frame {}", frame));
  std::vector<fs::path> files;
  if (std::ranges::count(renderers, "blender") > 0) check_overlaps(landscape, progress);
  for (const std::string& renderer : renderers) {
    for (const fs::path& file : export_frame(renderer, landscape, request_.out / renderer))
      files.push_back(file);
    progress.advance(1, fmt::format("{} frame {}", renderer, frame));
  }
  // POV-Ray takes its settings from where it is started: `povray povray/scene.pov` from here, too.
  if (const fs::path settings = request_.out / "povray" / "povray.ini"; fs::exists(settings)) {
    files.push_back(request_.out / settings.filename());
    update_file(files.back(), read_file(settings));
  }
  progress.end();
  return files;
}

std::vector<fs::path> make_film(const Request& request, Progress& progress) {
  const int last = static_cast<int>(request.scene.ageing.frames.size());
  for (const int frame : request.frames)
    if (frame < 1 || frame > last)
      throw InputError(fmt::format("found frame {}, expected 1 to {}", frame, last));
  Film film(request);
  write_programs(request.scene, request.out);
  film.find_demand(progress);
  for (int variant = 0; variant < request.scene.grass.variants; ++variant)
    film.make_texels(variant, progress);
  film.make_cloud_pictures();
  std::set<fs::path> files;
  for (const int frame : request.frames)
    for (const fs::path& file : film.make_frame(frame, progress)) files.insert(file);
  return {files.begin(), files.end()};
}

}  // namespace wold::film
