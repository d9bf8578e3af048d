#include "work/job.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/error.h"
#include "core/machine.h"
#include "film/exporters.h"
#include "film/machine_check.h"
#include "phenology/film_season.h"
#include "scene/parse.h"
#include "scene/renderers.h"
#include "scene/shots.h"
#include "work/folder_format.h"
#include "work/kept_inputs.h"
#include "work/own_folder.h"

namespace wold::work {

int threads_of(const Job& job) {
  const auto all = static_cast<int>(std::thread::hardware_concurrency());
  return std::max(1, job.threads > 0 ? job.threads : all);
}

double memory_of(const Job& job) {
  return job.memory_bytes > 0.0 ? job.memory_bytes : machine_memory_bytes();
}

namespace {

/// Those that are asked for, and those that motion blur is made by where the film has a shutter.
std::vector<passes::Pass> wanted_passes(const std::string& names, const scene::Scene& scene) {
  if (scene.film.shutter == 0.0)
    return names.empty() ? std::vector<passes::Pass>() : passes::passes_of(names);
  return passes::passes_of(names.empty() ? "depth,motion" : names + ",depth,motion");
}

/// Scene files that nobody shows are what is wanted of them.
void require_pictures(const exporter::Exporters& exporters) {
  for (const exporter::Exporter* one : exporters)
    if (!one->renderer)
      throw InputError(fmt::format(
          "--keep: found {}, expected {} or {} with render.renderer \"{}\", whose scene "
          "files wold makes no pictures of",
          word_of(Keep::pictures), word_of(Keep::scenes), word_of(Keep::all), one->name));
}

}  // namespace

Job plan_job(const RenderOptions& options) {
  Job job;
  scene::LocatedScene read = scene::read_located_scene(options.scene, options.overrides);
  film::require_files(read.scene, read.places);
  job.season = phenology::film_season(read.scene);
  job.scene = phenology::as_film(std::move(read.scene), job.season.get());
  job.places = std::move(read.places);
  job.text_warnings = std::move(read.warnings);
  job.frames = chosen_frames(options.frames, job.scene);
  job.out = options.out.empty() ? std::filesystem::path("out") / job.scene.name : options.out;
  require_own_folder(job.out);
  require_known_format(job.out);
  require_inputs_kept(job.out, input_files(options.scene, job.scene), job.scene);
  job.exporters = film::wanted_exporters(job.scene);
  job.passes = wanted_passes(options.passes, job.scene);
  job.is_blur_alone = options.passes.empty();
  job.programs = options.programs;
  job.threads = options.threads > 0 ? options.threads : job.scene.render.threads;
  job.memory_bytes = static_cast<double>(options.memory_bytes);
  job.keep = options.keep;
  if (job.keep == Keep::pictures) require_pictures(job.exporters);
  return job;
}

namespace {

/// "  shots: flight 1-36, gusts 37-60"; nothing where the film has none.
std::string shots_text(const scene::Scene& scene) {
  std::string text;
  for (std::size_t shot = 0; shot < scene.shots.size(); ++shot) {
    const scene::Take take = scene::takes_of(scene)[shot];
    text += fmt::format("{} {} {}", text.empty() ? "  shots:" : ",", scene.shots[shot].name,
                        take.count == 1 ? fmt::format("{}", take.first)
                                        : fmt::format("{}-{}", take.first, take.last()));
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string summary(const Job& job) {
  const scene::Render& render = job.scene.render;
  return fmt::format("{}: frames {} of {}, {} x {} px, {} samples, renderer {}, into {}\n",
                     job.scene.name, ranges_text(job.frames), job.scene.ageing.frames.size(),
                     render.size_px[0], render.size_px[1], render.samples,
                     scene::renderers_text(render.renderers), job.out.string()) +
         shots_text(job.scene);
}

}  // namespace wold::work
