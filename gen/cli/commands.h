#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compare/differences.h"
#include "core/error.h"
#include "core/progress.h"
#include "place/wind_at.h"
#include "work/encode_films.h"
#include "work/job.h"

/// What the program can do: one function per command, free of the command line's syntax. Each
/// throws wold::Error; only run() in program.h prints errors.
namespace wold::cli {

/// How `plan` says what there is to do.
enum class PlanForm { text, why, json, openjd };

/// What `compare` is asked for.
struct CompareOptions {
  std::filesystem::path got;
  std::filesystem::path want;
  std::filesystem::path report;  ///< folder for page, pictures and metrics; empty: none
  compare::Limits limits;
};

/// What `curves` is asked for.
struct CurvesOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, applied after the scene file
  std::filesystem::path out;           ///< ends in .svg or .csv
  std::filesystem::path weather;       ///< daily weather, for the season's curves; may be empty
};

/// What `preview` is asked for.
struct PreviewOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, applied after the scene file
  std::filesystem::path out;           ///< ends in .png; empty: out/<scene name>/preview.png
};

/// What `wind` is asked for.
struct WindOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, applied after the scene file
  std::vector<place::WindPoint> points;
  bool json = false;
};

/// What `maps` is asked for.
struct MapsOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, applied after the scene file
  std::filesystem::path out;           ///< folder; empty: out/<scene name>/maps
  work::FrameChoice frames;
  bool json = false;
};

/// What `doctor` is asked for.
struct DoctorOptions {
  work::ChosenPrograms programs;
  bool json = false;
};

/// Generates everything the renderers need; as JSON, prints what there is then.
ExitCode run_generate(const work::RenderOptions& options, Progress& progress);

/// Generates, then runs the renderers, and prints the names of what they have made.
ExitCode run_render(const work::RenderOptions& options, Progress& progress);

/// Makes the passes of a scene's frames without pictures, all of them where the options name none,
/// and prints their names.
ExitCode run_passes(const work::RenderOptions& options, Progress& progress);

/// Prints what `render` would do, without doing or writing anything.
ExitCode run_plan(const work::RenderOptions& options, PlanForm form);

/// Does one task, unless it has been done.
ExitCode run_task(const work::RenderOptions& options, const std::string& stage, int index,
                  Progress& progress);

/// Prints the scene with every key filled in, as TOML or JSON.
ExitCode run_check(const std::filesystem::path& scene, const std::vector<std::string>& overrides,
                   bool json);

/// Prints what is in the files, and as JSON in one array. ExitCode::file when one is damaged.
ExitCode run_inspect(const std::vector<std::filesystem::path>& files, bool json);

/// Prints the metrics as JSON; ExitCode::different when the files differ by more than the limits.
ExitCode run_compare(const CompareOptions& options);

/// Writes the scene's ageing curves, or with daily weather or in a season those of its days, as a
/// figure (.svg) or a table (.csv).
ExitCode run_curves(const CurvesOptions& options);

/// Draws a contact sheet of a scene, without any renderer, and prints its name.
ExitCode run_preview(const PreviewOptions& options, Progress& progress);

/// Prints the wind at places, heights and times. Throws InputError where a place is not on the
/// terrain.
ExitCode run_wind(const WindOptions& options);

/// Writes maps of a scene's ground for geographic information systems, and prints their names.
ExitCode run_maps(const MapsOptions& options, Progress& progress);

/// Encodes a folder's frames as films, .mp4 and a .webp that loops beside it, and prints their
/// names. With a name of its own there is one film: that of the first renderer of the table that
/// has all frames.
ExitCode run_film(const work::EncodingOptions& options, Progress& progress);

/// Writes a page about an output folder, `out`/report.html unless `page` names another, and prints
/// its name.
ExitCode run_report(const std::filesystem::path& out, const std::filesystem::path& page,
                    Progress& progress);

/// Writes NAME.toml, one of scene::starter_kinds(), into the working folder; of an elevation model,
/// where `terrain` names one. Refuses to replace a file.
ExitCode run_new(const std::string& name, const std::string& kind,
                 const std::optional<std::string>& terrain);

/// Prints which renderers there are, what each can show and what to do, after probing them anew.
/// ExitCode::renderer when none shows all that a scene can have.
ExitCode run_doctor(const DoctorOptions& options);

/// Writes Blender's package as an installable archive into the folder `out`, and beside it the
/// script that renders without it being installed; prints both names.
ExitCode run_extension(const std::filesystem::path& out);

/// Prints what a key, or each key of a table, means and accepts; see scene::explanation().
ExitCode run_explain(const std::string& name, bool json);

/// Prints the scene file as JSON Schema.
ExitCode run_schema();

/// Prints the version, what the program was built from and with, and the renderers on this machine.
ExitCode run_version(bool json);

/// Prints all keys of a scene as markdown.
ExitCode run_help_keys();

}  // namespace wold::cli
