#include "cli/command_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/option_faults.h"
#include "console/console_progress.h"
#include "film/exporters.h"
#include "passes/pass.h"
#include "scene/registry.h"
#include "scene/renderers.h"
#include "scene/starter.h"

namespace wold::cli {
namespace {

using Action = std::function<ExitCode()>;
using Overrides = std::vector<std::string>;

void add_scene(CLI::App& app, std::filesystem::path& scene) {
  app.add_option("SCENE", scene, "the scene file (TOML)")->required();
}

void add_overrides(CLI::App& app, Overrides& overrides) {
  app.add_option("--set", overrides, "change a key of the scene; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

/// An option that is another spelling of --set KEY=value.
void add_shorthand(CLI::App& app, const std::string& option, const std::string& type,
                   const std::string& key, Overrides& overrides) {
  app.add_option_function<std::string>(
         option,
         [&overrides, key](const std::string& value) { overrides.push_back(key + "=" + value); },
         "sets " + key)
      ->type_name(type);
}

/// The same with a path, which may have any characters.
void add_file_shorthand(CLI::App& app, const std::string& option, const std::string& key,
                        Overrides& overrides) {
  app.add_option_function<std::string>(
         option,
         [&overrides, key](const std::string& file) {
           overrides.push_back(key + "=" + scene::toml_text(file));
         },
         "sets " + key)
      ->type_name("FILE");
}

/// The scene and what changes its keys; shorthands are kept apart because CLI11 replaces the list
/// of
/// --set when it is done. `Options` has `scene` and `overrides`.
template <class Options>
struct SceneArguments {
  Options options;
  Overrides shorthands;
};
using RenderArguments = SceneArguments<work::RenderOptions>;

/// Takes one word of render.renderer, or several with commas between them.
void add_renderers(CLI::App& app, Overrides& overrides) {
  app.add_option_function<std::string>(
         "--renderer",
         [&overrides](const std::string& text) {
           const bool is_list = text.find(',') != std::string::npos;
           overrides.push_back("render.renderer=" +
                               (is_list ? scene::toml_text(CLI::detail::split(text, ',')) : text));
         },
         "sets render.renderer")
      ->type_name(fmt::format("{}", fmt::join(scene::renderer_words(), "|")));
}

/// All but --weather, which `curves` has for itself.
void add_shorthands(CLI::App& app, Overrides& overrides) {
  add_renderers(app, overrides);
  add_shorthand(app, "--samples", "N", "render.samples", overrides);
  add_shorthand(app, "--grass", "texels|blades|auto|points", "render.grass", overrides);
  add_file_shorthand(app, "--terrain", "terrain.elevation", overrides);
  app.add_option_function<std::string>(
         "--size",
         [&overrides](const std::string& size) { overrides.push_back(size_override(size)); },
         "sets render.size")
      ->type_name("WxH");
}

void add_weather(CLI::App& app, Overrides& overrides) {
  add_file_shorthand(app, "--weather", "season.table", overrides);
}

/// What every command that reads a scene takes.
template <class Options>
void add_scene_arguments(CLI::App& app, SceneArguments<Options>& arguments) {
  add_scene(app, arguments.options.scene);
  add_shorthands(app, arguments.shorthands);
  add_weather(app, arguments.shorthands);
  add_overrides(app, arguments.options.overrides);
}

void add_frames(CLI::App& app, work::FrameChoice& frames, const std::string& doc) {
  CLI::Option* numbers =
      app.add_option_function<std::string>(
             "--frames",
             [&frames](const std::string& text) { frames.numbers = parse_frames(text); }, doc)
          ->type_name("1,5,9-12");
  app.add_option("--shot", frames.shots, "frames of the shot of that name; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->excludes(numbers);
}

/// The programs that make pictures, by name or path.
void add_programs(CLI::App& app, work::ChosenPrograms& programs) {
  for (const exporter::Exporter* one : film::exporters()) {
    if (!one->renderer) continue;
    const render::ExternalProgram& program = one->renderer->program;
    app.add_option(program.option, programs[std::string(one->name)],
                   fmt::format("{}; {}'s without it", one->renderer->option_doc, program.variable))
        ->type_name("PROGRAM");
  }
}

auto one_of(const std::vector<std::string>& words) {
  return [words](const std::string& text) { return word_fault(text, words); };
}

/// Everything that says which files are made.
void add_job_options(CLI::App& app, RenderArguments& arguments) {
  work::RenderOptions& options = arguments.options;
  add_scene_arguments(app, arguments);
  add_frames(app, options.frames, "frames to make, from 1; all without it");
  app.add_option("--out", options.out, "output folder; out/<scene name> without it")
      ->type_name("DIR");
  app.add_option("--passes", options.passes,
                 "ground truth to write beside the pictures, DIR/passes/0001.exr and on: all, or "
                 "some of " +
                     passes::names_of_all())
      ->type_name("LIST");
  app.add_option("--threads", options.threads, "threads to use; the scene's without it")
      ->type_name("N")
      ->check([](const std::string& text) { return whole_number_fault(text, 1, 1024); });
  app.add_option("--memory", options.memory_bytes,
                 "memory to keep to, renderers included, such as 8G; no limit without it")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(false).description(""))
      ->transform(CLI::Validator([](const std::string& text) { return size_fault(text); }, ""));
}

/// `has_pictures`: whether the command makes pictures, which may stay alone.
CLI::Option* add_keep(CLI::App& app, work::Keep& keep, bool has_pictures) {
  std::vector<std::string> words(work::keep_words.begin(), work::keep_words.end());
  std::string doc = "what stays: all; scenes, without the texels that scene files are made from";
  if (has_pictures)
    doc += "; or pictures, without either";
  else
    words.resize(static_cast<std::size_t>(work::Keep::pictures));
  return app
      .add_option_function<std::string>(
          "--keep",
          [&keep, words](const std::string& word) {
            keep = static_cast<work::Keep>(std::ranges::find(words, word) - words.begin());
          },
          doc)
      ->type_name(fmt::format("{}", fmt::join(words, "|")))
      ->check(one_of(words));
}

void add_json(CLI::App& app, bool& json, const std::string& doc) {
  app.add_flag("--json", json, doc);
}

void add_quiet(CLI::App& app, bool& quiet) { app.add_flag("--quiet", quiet, "no progress"); }

/// The options with the shorthands among the overrides.
template <class Options>
Options resolved(const SceneArguments<Options>& arguments) {
  Options options = arguments.options;
  options.overrides.insert(options.overrides.end(), arguments.shorthands.begin(),
                           arguments.shorthands.end());
  return options;
}

template <class Run>
Action generate_like(CLI::App& app, const std::shared_ptr<RenderArguments>& arguments, Run run,
                     bool has_pictures = false) {
  add_job_options(app, *arguments);
  add_keep(app, arguments->options.keep, has_pictures);
  app.add_flag("--dry-run", arguments->options.dry_run,
               "check the scene, say what is to do and what it takes, stop");
  add_json(app, arguments->options.json, "print what has been made, or is to do, as JSON");
  add_quiet(app, arguments->options.quiet);
  return [arguments, run] {
    console::ConsoleProgress progress(console::progress_style(arguments->options.quiet));
    return run(resolved(*arguments), progress);
  };
}

void add_programs(CLI::App& app, work::RenderOptions& options) {
  add_programs(app, options.programs);
}

Action declare_generate(CLI::App& app) {
  return generate_like(app, std::make_shared<RenderArguments>(), run_generate);
}

Action declare_render(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  add_programs(app, arguments->options);
  return generate_like(app, arguments, run_render, /*has_pictures=*/true);
}

Action declare_passes(CLI::App& app) {
  return generate_like(app, std::make_shared<RenderArguments>(), run_passes);
}

Action declare_plan(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  auto form = std::make_shared<PlanForm>(PlanForm::text);
  add_job_options(app, *arguments);
  add_programs(app, arguments->options);
  const auto add_form = [&](const std::string& option, PlanForm value, const std::string& doc) {
    return app.add_flag_callback(
        option, [form, value] { *form = value; }, doc);
  };
  CLI::Option* json = add_form("--json", PlanForm::json, "as JSON");
  CLI::Option* why = add_form("--why", PlanForm::why, "say why tasks are to do");
  CLI::Option* openjd =
      add_form("--openjd", PlanForm::openjd, "as a job template of Open Job Description");
  json->excludes(why)->excludes(openjd);
  why->excludes(openjd);
  add_keep(app, arguments->options.keep, /*has_pictures=*/true);
  return [arguments, form] { return run_plan(resolved(*arguments), *form); };
}

Action declare_task(CLI::App& app) {
  struct Options {
    RenderArguments arguments;
    std::string stage;
    int index = 1;
  };
  auto options = std::make_shared<Options>();
  add_job_options(app, options->arguments);
  add_programs(app, options->arguments.options);
  app.add_option("STAGE", options->stage, "one that `wold plan` lists")->required();
  app.add_option("INDEX", options->index, "one that `wold plan` lists for it")->required();
  add_quiet(app, options->arguments.options.quiet);
  return [options] {
    console::ConsoleProgress progress(console::progress_style(options->arguments.options.quiet));
    return run_task(resolved(options->arguments), options->stage, options->index, progress);
  };
}

Action declare_check(CLI::App& app) {
  auto arguments = std::make_shared<RenderArguments>();
  add_scene_arguments(app, *arguments);
  add_json(app, arguments->options.json, "print JSON instead of TOML");
  return [arguments] {
    const work::RenderOptions options = resolved(*arguments);
    return run_check(options.scene, options.overrides, options.json);
  };
}

Action declare_inspect(CLI::App& app) {
  struct Options {
    std::vector<std::filesystem::path> files;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  app.add_option("FILE", options->files, "pictures, .vdb or .df3 files")->required();
  add_json(app, options->json, "print one JSON array");
  return [options] { return run_inspect(options->files, options->json); };
}

void add_limit(CLI::App& app, const std::string& option, double& limit, const std::string& doc) {
  app.add_option(option, limit, doc)
      ->check([](const std::string& text) {
        return number_fault(text, 0.0, std::numeric_limits<double>::infinity());
      })
      ->capture_default_str();
}

Action declare_compare(CLI::App& app) {
  auto options = std::make_shared<CompareOptions>();
  compare::Limits& limits = options->limits;
  app.add_option("GOT", options->got, "the file or folder to judge")->required();
  app.add_option("WANT", options->want, "the file or folder it should equal")->required();
  app.add_option("--report", options->report,
                 "folder for a page that shows both and how they differ")
      ->type_name("DIR");
  add_limit(app, "--rmse", limits.rmse, "root mean square difference allowed");
  add_limit(app, "--soft", limits.soft, "difference that some pixels or voxels may exceed");
  add_limit(app, "--share", limits.allowed_fraction, "share of them that may");
  add_limit(app, "--hard", limits.hard, "difference that none may exceed");
  add_limit(app, "--flip", limits.flip, "mean FLIP allowed, of pictures");
  add_limit(app, "--ssim", limits.ssim, "least structural similarity of pictures");
  return [options] { return run_compare(*options); };
}

Action declare_curves(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments<CurvesOptions>>();
  CurvesOptions& options = arguments->options;
  add_scene(app, options.scene);
  add_shorthands(app, arguments->shorthands);
  // Not ->required(): the command itself says what a missing name should look like.
  app.add_option("--out", options.out, "the figure or table to write; its ending says which")
      ->type_name("FILE.svg|FILE.csv");
  app.add_option("--weather", options.weather,
                 "daily weather (date, tmin_c, tmax_c, precipitation_mm): draws what the season "
                 "makes of it instead: greenness, weathering degree, snow")
      ->type_name("FILE.csv");
  add_overrides(app, options.overrides);
  return [arguments] { return run_curves(resolved(*arguments)); };
}

void add_output_folder(CLI::App& app, std::filesystem::path& out) {
  app.add_option("DIR", out, "an output folder of `wold render`")->required();
}

/// Of the exporters whose pictures Wold makes.
std::vector<std::string> names_of_renderers() {
  std::vector<std::string> names;
  for (const exporter::Exporter* one : film::exporters())
    if (one->renderer) names.emplace_back(one->name);
  return names;
}

Action declare_film(CLI::App& app) {
  auto options = std::make_shared<work::EncodingOptions>();
  auto quiet = std::make_shared<bool>(false);
  add_output_folder(app, options->out);
  app.add_option("--out", options->film,
                 "the film; DIR/film_<renderer>.mp4 without it, for each that has all frames")
      ->type_name("FILE.mp4");
  app.add_option("--renderer", options->renderer, "whose frames; Blender's rather than POV-Ray's")
      ->check(one_of(names_of_renderers()))
      ->type_name(fmt::format("{}", fmt::join(names_of_renderers(), "|")));
  add_frames(app, options->frames, "frames to take, without gaps; all without it");
  app.add_option("--fps", options->frames_per_second,
                 "frames per second; as film.frames_per_second says without it")
      ->type_name("N")
      ->check([](const std::string& text) { return number_fault(text, 0.1, 240.0); });
  app.add_option("--shutter", options->shutter,
                 "motion blur by the passes depth and motion in DIR/passes: the share of the time "
                 "between frames in which the shutter is open, such as 0.5; as film.shutter says "
                 "without it")
      ->type_name("SHARE")
      ->check([](const std::string& text) { return number_fault(text, 0.0, 1.0); });
  add_quiet(app, *quiet);
  return [options, quiet] {
    console::ConsoleProgress progress(console::progress_style(*quiet));
    return run_film(*options, progress);
  };
}

Action declare_preview(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments<PreviewOptions>>();
  add_scene_arguments(app, *arguments);
  app.add_option("--out", arguments->options.out,
                 "the picture; out/<scene name>/preview.png without it")
      ->type_name("FILE.png");
  auto quiet = std::make_shared<bool>(false);
  add_quiet(app, *quiet);
  return [arguments, quiet] {
    console::ConsoleProgress progress(console::progress_style(*quiet));
    return run_preview(resolved(*arguments), progress);
  };
}

Action declare_wind(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments<WindOptions>>();
  WindOptions& options = arguments->options;
  add_scene_arguments(app, *arguments);
  app.add_option_function<std::vector<std::string>>(
         "--at",
         [&options](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) options.points.push_back(parse_wind_point(text));
         },
         "where and when: metres east and north on the terrain, metres above the ground, seconds "
         "since the first frame; may be repeated")
      ->type_name("X,Y,Z,T")
      ->required()
      ->allow_extra_args(false);
  app.add_flag("--json", options.json, "print one JSON array");
  return [arguments] { return run_wind(resolved(*arguments)); };
}

Action declare_maps(CLI::App& app) {
  auto arguments = std::make_shared<SceneArguments<MapsOptions>>();
  add_scene_arguments(app, *arguments);
  app.add_option("--out", arguments->options.out, "the folder; out/<scene name>/maps without it")
      ->type_name("DIR");
  add_frames(app, arguments->options.frames, "frames, counted from 1; all without it");
  app.add_flag("--json", arguments->options.json, "print what is in the files, as JSON");
  auto quiet = std::make_shared<bool>(false);
  add_quiet(app, *quiet);
  return [arguments, quiet] {
    console::ConsoleProgress progress(console::progress_style(*quiet));
    return run_maps(resolved(*arguments), progress);
  };
}

Action declare_report(CLI::App& app) {
  struct Options {
    std::filesystem::path out;
    std::filesystem::path page;
    bool quiet = false;
  };
  auto options = std::make_shared<Options>();
  add_output_folder(app, options->out);
  app.add_option("--out", options->page, "the page; DIR/report.html without it")
      ->type_name("FILE.html");
  add_quiet(app, options->quiet);
  return [options] {
    console::ConsoleProgress progress(console::progress_style(options->quiet));
    return run_report(options->out, options->page, progress);
  };
}

Action declare_new(CLI::App& app) {
  struct Options {
    std::string name;
    std::string kind = scene::starter_kinds().front();
    std::optional<std::string> terrain;
  };
  auto options = std::make_shared<Options>();
  app.add_option("NAME", options->name, "names the scene and its file")->required();
  app.add_option("--kind", options->kind, "what it shows")
      ->check(one_of(scene::starter_kinds()))
      ->type_name(fmt::format("{}", fmt::join(scene::starter_kinds(), "|")))
      ->capture_default_str();
  app.add_option("--terrain", options->terrain,
                 "elevation model of a real place, which the scene shows from where it looks well")
      ->type_name("FILE");
  return [options] { return run_new(options->name, options->kind, options->terrain); };
}

Action declare_explain(CLI::App& app) {
  struct Options {
    std::string name;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  app.add_option(
      "KEY", options->name,
      "a key, such as sun.elevation, or a table, such as sun; without it, the names of all");
  add_json(app, options->json, "print JSON");
  return [options] { return run_explain(options->name, options->json); };
}

Action declare_schema(CLI::App& /*app*/) { return run_schema; }

Action declare_doctor(CLI::App& app) {
  auto options = std::make_shared<DoctorOptions>();
  add_programs(app, options->programs);
  add_json(app, options->json, "print JSON");
  return [options] { return run_doctor(*options); };
}

Action declare_extension(CLI::App& app) {
  auto out = std::make_shared<std::filesystem::path>();
  app.add_option("--out", *out, "folder to write to")->type_name("DIR")->required();
  return [out] { return run_extension(*out); };
}

}  // namespace

const std::vector<Command>& command_table() {
  static const std::vector<Command> commands = {
      {"render", "generate the scene's data and make its pictures",
       "wold render meadow.toml --renderer povray --frames 1-3 --size 480x270", declare_render},
      {"generate", "everything but running the renderers",
       "wold generate meadow.toml --out sparse --set grass.blades=200", declare_generate},
      {"passes",
       "write the ground truth of a scene's frames, without pictures: depth, ids and more",
       "wold passes meadow.toml --passes depth,species --frames 1-3 --size 480x270",
       declare_passes},
      {"plan", "list the tasks that render does, which of them are to do, and what they take",
       "wold plan meadow.toml --frames 1-3 --why", declare_plan},
      {"task", "do one of the plan's tasks, unless it has been done",
       "wold task meadow.toml texels 1 --out shared/meadow", declare_task},
      {"preview", "draw a contact sheet of a scene in seconds, without any renderer",
       "wold preview meadow.toml --out meadow.png --set sun.elevation=12", declare_preview},
      {"maps", "write maps of the ground as GeoTIFFs: height, slope, growth, weathering, snow",
       "wold maps meadow.toml --out maps --frames 1-3", declare_maps},
      {"check", "check a scene and print it with every key filled in",
       "wold check meadow.toml --set sun.elevation=20", declare_check},
      {"inspect", "say what is in pictures, .vdb and .df3 files, and what is wrong with them",
       "wold inspect out/meadow/frames/povray/0001.png --json", declare_inspect},
      {"compare", "compare two pictures, grids or folders of them, print the metrics as JSON",
       "wold compare got.png want.png --report differences --rmse 0.01", declare_compare},
      {"curves", "draw or tabulate a scene's ageing: pigments, water, shrinkage, droop, colour",
       "wold curves meadow.toml --out ageing.svg --set ageing.water=cold", declare_curves},
      {"wind", "say how the wind blows at places, heights and times of a scene",
       "wold wind meadow.toml --at 21,20,0.3,0 --at 21,20,10,0", declare_wind},
      {"film", "encode frames as a film (.mp4) and as a picture that loops (.webp)",
       "wold film out/meadow --renderer povray --fps 25", declare_film},
      {"report",
       "make one web page of an output folder: frames over time, times, curves, parameters",
       "wold report out/meadow", declare_report},
      {"new", "write a commented starter scene", "wold new meadow --kind season", declare_new},
      {"explain", "say what a key of a scene means, what it accepts and what it is without a value",
       "wold explain sun.elevation", declare_explain},
      {"schema", "print the scene file's JSON Schema, for editors that complete and check TOML",
       "wold schema >scene.schema.json", declare_schema},
      {"doctor", "list the renderers on this machine, what each can show, and what to do",
       "wold doctor --blender ~/blender-5.2/blender", declare_doctor},
      {"extension", "write Blender's add-on as an installable archive",
       "wold extension --out blender_add_on", declare_extension},
  };
  return commands;
}

}  // namespace wold::cli
