#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <set>

#include "cli/commands.h"
#include "cli/film.h"
#include "cli/interrupt.h"
#include "cli/job.h"
#include "cli/manifest.h"
#include "cli/output.h"
#include "core/files.h"
#include "core/parallel.h"
#include "grass/time_varying_texel.h"
#include "render/run.h"
#include "scene/write.h"

namespace wold::cli {
namespace {

render::Renderer kind_of(const std::string& renderer) {
  return renderer == "blender" ? render::Renderer::blender : render::Renderer::povray;
}

render::Job picture_job(const Job& job, const std::string& renderer, int frame) {
  const scene::Render& settings = job.scene.render;
  const std::string number = fmt::format("{:04}", frame);
  render::Job picture;
  picture.kind = kind_of(renderer);
  picture.scene_folder = job.out / renderer;
  picture.frame = frame;
  picture.size_px = {settings.size_px[0], settings.size_px[1]};
  picture.samples = settings.samples;
  picture.threads = job.threads;
  picture.timeout = std::chrono::seconds(std::lround(settings.timeout_minutes * 60.0));
  picture.picture = job.out / "frames" / renderer / (number + ".png");
  picture.log = job.out / "logs" / fmt::format("{}_{}.log", renderer, number);
  return picture;
}

/// The renderer's own program: every script at the top of its folder.
std::string program_text(const std::filesystem::path& folder) {
  std::set<std::filesystem::path> scripts;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.') &&
        entry.path().extension() != ".ini")
      scripts.insert(entry.path());
  std::string text;
  for (const auto& script : scripts) text += read_file(script);
  return text;
}

/// What a picture is made from: the whole scene but what changes no pixel, the models, the frame
/// and the renderer's own program.
std::string picture_source(const Job& job, const std::string& renderer, int frame) {
  scene::Scene scene = job.scene;
  const scene::Render defaults;
  scene.render.threads = defaults.threads;
  scene.render.timeout_minutes = defaults.timeout_minutes;
  scene.render.renderer = renderer;
  return content_hash(scene::resolved_toml(scene) +
                      fmt::format("{} {} {}", renderer, frame, grass::texel_models()) +
                      program_text(job.out / renderer));
}

void render_picture(const render::Job& picture, const std::string& source,
                    const std::filesystem::path& out, Manifest& manifest, Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  render::run(picture, progress, interrupted);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  manifest.add_picture(picture.picture.lexically_relative(out), source, seconds.count());
}

}  // namespace

ExitCode run_render(const RenderOptions& options, Progress& progress) {
  const Job job = plan_job(options);
  const std::vector<std::string> renderers = wanted_renderers(job.scene);
  if (options.dry_run) {
    print_data(summary(job));
    return ExitCode::done;
  }
  // Before minutes are spent on what could not be rendered.
  for (const std::string& renderer : renderers) render::find_renderer(kind_of(renderer));
  const ThreadLimit limit(job.threads);
  Film(job).generate(progress);
  Manifest manifest(job.out);
  std::string pictures;
  for (const int frame : job.frames)
    for (const std::string& renderer : renderers) {
      const render::Job picture = picture_job(job, renderer, frame);
      const std::string source = picture_source(job, renderer, frame);
      if (!manifest.is_current(picture.picture.lexically_relative(job.out), source))
        render_picture(picture, source, job.out, manifest, progress);
      pictures += picture.picture.string() + "\n";
    }
  manifest.write();
  print_data(pictures);
  return ExitCode::done;
}

}  // namespace wold::cli
