#include "film/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/files.h"
#include "film/assemble.h"
#include "film/cloud_textures.h"
#include "film/exporters.h"
#include "film/ground_facts.h"
#include "film/machine_check.h"
#include "grass/texel/texel_file.h"
#include "ground/lit_ground.h"
#include "meadow/bent_cells.h"
#include "meadow/far_field.h"
#include "meadow/film_lights.h"
#include "passes/paint.h"
#include "place/view.h"
#include "scene/species.h"

namespace wold::film {
namespace fs = std::filesystem;
namespace {

int coarsest_lod(const scene::Grass& grass) { return static_cast<int>(grass.lods.size()) - 1; }

/// All that cells may use. Which of them do depends on the frames; a file must not.
std::set<int> turns_of(const scene::Scene& scene, int lod) {
  std::set<int> turns;
  for (int turn = 0; turn < meadow::turns_of_lod(scene, lod); ++turn) turns.insert(turn);
  return turns;
}

grass::TexelFiles texel_files(const Request& request) {
  return reads_unlit_texels(request) ? grass::TexelFiles::baked_and_unlit
                                     : grass::TexelFiles::baked;
}

/// Writes a frame into an exporter's folder, and what the output folder has of that.
void export_frame(const exporter::Exporter& exporter, const landscape::Landscape& landscape,
                  const exporter::FilmSettings& film, const fs::path& out,
                  std::vector<fs::path>& files) {
  const fs::path folder = out / exporter.name;
  for (const fs::path& file : exporter.export_frame(landscape, film, folder)) files.push_back(file);
  for (const std::string& name : exporter.files_for_output_folder) {
    files.push_back(out / name);
    update_file(files.back(), read_file(folder / name));
  }
}

/// Says what will be missing in pictures soon; throws InputError where something is.
void check_frame(const Request& request, const landscape::Landscape& landscape,
                 Progress& progress) {
  for (const exporter::Exporter* one : request.exporters) {
    const std::string warning = one->warning_of ? one->warning_of(landscape) : "";
    if (!warning.empty()) progress.say("warning: " + warning);
  }
}

}  // namespace

bool reads_unlit_texels(const Request& request) {
  return !request.passes.empty() || needs_of(request.exporters).materials;
}

void write_film_files(const Request& request) {
  const exporter::FilmSettings film = film_settings(request.scene);
  for (const exporter::Exporter* one : request.exporters)
    if (one->export_film) one->export_film(film, request.out / one->name);
}

FilmPipeline::FilmPipeline(const Request& request, place::GrowingGround land)
    : request_(request),
      snow_(request.out / "snow"),
      site_(place::make_site(request.scene, std::move(land), request.season, snow_.path())),
      texels_(request.scene, meadow::film_lights(request.scene, site_), request.out / "texels",
              texel_files(request)) {}

void FilmPipeline::find_demand(Progress& progress) {
  progress.begin("cells", request_.frames.size());
  for (const int frame : request_.frames) {
    const meadow::FrameGrass now = meadow::frame_grass(request_.scene, site_, frame);
    const std::vector<meadow::CellChoice> cells = cells_of(now);
    for (const meadow::CellChoice& cell : cells)
      if (!cell.blades) demand(cell.variant, cell.state(), cell.lod);
    demand_far_field(now);
    progress.advance(1, fmt::format("frame {}: {} cells", frame, cells.size()));
  }
  progress.end();
}

std::vector<meadow::CellChoice> FilmPipeline::cells_of(const meadow::FrameGrass& now) const {
  std::vector<meadow::CellChoice> cells =
      meadow::choose_cells(request_.scene, site_.terrain, place::growth_of_cells(site_),
                           *site_.mixtures, *site_.withering, now);
  meadow::bend_blades(request_.scene, site_.terrain, now.frame, cells);
  return cells;
}

void FilmPipeline::demand_far_field(const meadow::FrameGrass& now) {
  const scene::Scene& scene = request_.scene;
  if (!ground::shows_distance(scene, site_, now.frame)) return;
  for (const grass::PatchState& state : meadow::far_states(scene, *site_.withering, now))
    for (const int mixture : site_.mixtures->present())
      for (int variant = 0; variant < scene.grass.variants; ++variant)
        demand(scene::patch_number(scene, mixture, variant), state, coarsest_lod(scene.grass));
}

void FilmPipeline::demand(int variant, const grass::PatchState& state, int lod) {
  std::set<int>& turns = demand_[variant][state][lod];
  if (turns.empty()) turns = turns_of(request_.scene, lod);
}

std::vector<fs::path> FilmPipeline::make_texels(int variant, Progress& progress) const {
  const auto wanted = demand_.find(variant);
  if (wanted == demand_.end()) return {};
  texels_.generate({*wanted}, progress);
  std::set<fs::path> files;
  for (const auto& [state, lods] : wanted->second) {
    if (reads_unlit_texels(request_)) files.insert(texels_.texel_path(variant, state));
    for (const auto& lod : lods) files.insert(texels_.volume_path(variant, state, lod.first));
  }
  return {files.begin(), files.end()};
}

std::vector<fs::path> FilmPipeline::make_cloud_pictures() const {
  if (!site_.clouds) return {};
  return write_cloud_textures(*site_.clouds, request_.out / "clouds");
}

landscape::Volume FilmPipeline::volume(const meadow::CellChoice& cell) const {
  const int side = request_.scene.grass.lods[static_cast<std::size_t>(cell.lod)];
  landscape::Volume volume;
  volume.name = fmt::format("v{}_{}_q{}_{:03}", cell.variant, cell.state().name(), cell.turn, side);
  volume.vdb = texels_.volume_path(cell.variant, cell.state(), cell.lod);
  volume.emission_grid = fmt::format("emission_q{}", cell.turn);
  volume.texel = texels_.texel_path(cell.variant, cell.state());
  volume.content = texels_.volume_content(cell.variant, cell.state(), cell.lod,
                                          turns_of(request_.scene, cell.lod));
  volume.voxels = {side, side, texels_.lod_shape(cell.lod).height};
  volume.voxel_m = request_.scene.grass.patch_m / side;
  if (grass::file_content(volume.vdb) != volume.content)
    throw FileError(
        fmt::format("{} is missing, damaged or of another scene; expected that of this one: run "
                    "the task \"texels {}\" of these frames first",
                    volume.vdb.string(), cell.variant + 1));
  return volume;
}

Tubes FilmPipeline::straight_blades(const meadow::CellChoice& cell) const {
  if (request_.scene.render.grass == scene::GrassForm::points)
    return texels_.points(cell.variant, cell.state());
  Tubes tubes = texels_.blades(cell.variant, cell.state());
  if (needs_of(request_.exporters).materials)
    texels_.add_leaf_shades(cell.variant, cell.state(), tubes);
  return tubes;
}

/// Light and materials are those of the straight ones, which are made once for all bends.
Tubes FilmPipeline::bent_blades(meadow::CellChoice cell) {
  const grass::BladeBend bend = std::exchange(cell.bend, {});
  return texels_.bent_blades(cell.variant, cell.state(), bend, *blades(cell).tubes);
}

landscape::BladeMesh FilmPipeline::blades(const meadow::CellChoice& cell) {
  landscape::BladeMesh& mesh = blades_[{cell.variant, cell.state(), cell.bend}];
  if (mesh.tubes) return mesh;
  const bool points = request_.scene.render.grass == scene::GrassForm::points;
  mesh.name = fmt::format("{}{}_{}_{}{}", points ? 'p' : 'v', cell.variant, cell.state().name(),
                          texels_.content(cell.variant, cell.state()), suffix_of(cell.bend));
  mesh.tubes = std::make_shared<const Tubes>(cell.bend.is_none() ? straight_blades(cell)
                                                                 : bent_blades(cell));
  return mesh;
}

/// With their reflectance, which not all exporters ask for.
landscape::BladeMesh FilmPipeline::shaded_blades(const meadow::CellChoice& cell) {
  const landscape::BladeMesh mesh = blades(cell);
  if (!mesh.tubes->reflectance.empty()) return mesh;
  Tubes tubes = *mesh.tubes;
  texels_.add_leaf_shades(cell.variant, cell.state(), tubes);
  landscape::BladeMesh& kept = blades_[{cell.variant, cell.state(), cell.bend}];
  kept.tubes = std::make_shared<const Tubes>(std::move(tubes));
  return kept;
}

/// Kept from frame to frame: to measure one takes a tenth of a second.
meadow::PatchAppearance FilmPipeline::far_appearance(int mixture, const grass::PatchState& state) {
  const scene::Scene& scene = request_.scene;
  const std::pair key(mixture, state);
  if (const auto known = far_appearances_.find(key); known != far_appearances_.end())
    return known->second;
  std::vector<landscape::Volume> volumes;
  meadow::CellChoice choice;
  choice.key_frame = state.key_frame;
  choice.snow = state.snow;
  choice.light = state.light;
  choice.lod = coarsest_lod(scene.grass);
  for (int variant = 0; variant < scene.grass.variants; ++variant) {
    choice.variant = scene::patch_number(scene, mixture, variant);
    volumes.push_back(volume(choice));
  }
  return far_appearances_.emplace(key, volumes).first->second;
}

PatchLookup FilmPipeline::patch_lookup() {
  return {[this](const meadow::CellChoice& cell) { return volume(cell); },
          [this](const meadow::CellChoice& cell) { return blades(cell); },
          [this](int mixture, const grass::PatchState& state) {
            return far_appearance(mixture, state);
          }};
}

std::vector<fs::path> FilmPipeline::make_frame(int frame, Progress& progress) {
  const PatchLookup lookup = patch_lookup();
  const std::vector<const exporter::Exporter*>& exporters = request_.exporters;
  progress.begin(fmt::format("scene files of frame {}", frame), 1 + exporters.size());
  const meadow::FrameGrass now = meadow::frame_grass(request_.scene, site_, frame);
  const landscape::Landscape landscape =
      assemble(request_.scene, place::site_of_frame(request_.scene, site_, frame), now,
               cells_of(now), lookup, needs_of(exporters));
  progress.advance(1, fmt::format("frame {}", frame));
  check_frame(request_, landscape, progress);
  const exporter::FilmSettings film = film_settings(request_.scene);
  std::vector<fs::path> files;
  for (const exporter::Exporter* one : exporters) {
    export_frame(*one, landscape, film, request_.out, files);
    progress.advance(1, fmt::format("{} frame {}", one->name, frame));
  }
  progress.end();
  return files;
}

std::vector<fs::path> FilmPipeline::make_passes(int frame, std::span<const passes::Pass> passes,
                                                Progress& progress) {
  const scene::Scene& scene = request_.scene;
  if (scene.render.grass == scene::GrassForm::points)
    throw InputError(
        "--passes: found render.grass = \"points\", expected \"texels\", \"blades\" or "
        "\"auto\": points are no leaves");
  progress.begin(fmt::format("passes of frame {}", frame), 2);
  PatchLookup lookup = patch_lookup();
  lookup.blades = [this](const meadow::CellChoice& cell) { return shaded_blades(cell); };
  const meadow::FrameGrass now = meadow::frame_grass(scene, site_, frame);
  const place::Site site = place::site_of_frame(scene, site_, frame);
  const AssembledFrame assembled =
      assemble_frame(scene, site, now, cells_of(now), lookup, needs_of({}));
  progress.advance(1, fmt::format("frame {}", frame));
  const passes::GroundFacts facts = ground_facts(scene, site, now, assembled, lookup);
  const fs::path file = request_.out / "passes" / fmt::format("{:04}.exr", frame);
  make_folder(file.parent_path());
  write_layered_image(file, passes::paint(assembled.landscape, facts, passes));
  progress.advance(1, fmt::format("frame {}", frame));
  progress.end();
  return {file};
}

std::vector<fs::path> make_film(const Request& request, Progress& progress) {
  const int last = static_cast<int>(request.scene.ageing.frames.size());
  for (const int frame : request.frames)
    if (frame < 1 || frame > last)
      throw InputError(fmt::format("found frame {}, expected 1 to {}", frame, last));
  require_files(request.scene);
  require_texel_memory(request.scene);
  FilmPipeline film(request, place::growing_ground(request.scene));
  write_film_files(request);
  film.find_demand(progress);
  for (int variant = 0; variant < scene::patch_count(request.scene); ++variant)
    film.make_texels(variant, progress);
  film.make_cloud_pictures();
  std::set<fs::path> files;
  for (const int frame : request.frames)
    for (const fs::path& file : film.make_frame(frame, progress)) files.insert(file);
  return {files.begin(), files.end()};
}

}  // namespace wold::film
