#include "report/report_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "advice/scene_warnings.h"
#include "core/error.h"
#include "core/file_list.h"
#include "core/files.h"
#include "film/exporters.h"
#include "passes/pass.h"
#include "phenology/film_season.h"
#include "scene/parse.h"
#include "work/folder_format.h"
#include "work/job.h"
#include "work/task_record.h"
#include "work/tasks.h"

namespace wold::report {
namespace fs = std::filesystem;
namespace {

void read_scene(const fs::path& out, ReportFacts& facts) {
  try {
    facts.scene = scene::read_scene(out / "scene.toml");
    facts.name = facts.scene->name;
  } catch (const InputError& error) {
    facts.name = fs::absolute(out / "").parent_path().filename().string();
    facts.warnings.push_back(fmt::format(
        "The scene is not known: {}. Curves and parameters are left out.", error.what()));
  }
}

/// The frames may be old and the season's table gone: that is no reason for no page.
void read_scene_warnings(ReportFacts& facts) {
  if (!facts.scene) return;
  try {
    const auto season = phenology::film_season(*facts.scene);
    for (const std::string& warning : advice::scene_warnings(*facts.scene, season.get()))
      facts.warnings.push_back(fmt::format("Scene: {}.", warning));
  } catch (const Error& error) {
    facts.warnings.push_back(fmt::format("Scene: {}.", error.what()));
  }
}

void read_passes(const fs::path& out, ReportFacts& facts) {
  for (const int frame : facts.frames)
    if (const fs::path file = out / "passes" / fmt::format("{:04}.exr", frame); fs::exists(file))
      facts.passes[frame] = file;
}

void read_times(const fs::path& out, ReportFacts& facts) {
  if (!facts.scene) return;
  work::Job job;
  job.scene = *facts.scene;
  job.frames = facts.frames;
  job.exporters = film::wanted_exporters(job.scene);
  if (!facts.passes.empty()) job.passes = passes::passes_of("all");
  const work::TaskRecords records(out);
  for (const work::StageTasks& tasks : work::stages_of(job)) {
    StageTime time{std::string(work::name_of(tasks.stage)), 0,
                   static_cast<int>(tasks.indices.size())};
    for (const int index : tasks.indices) {
      const auto record = records.read({tasks.stage, index});
      if (!record) continue;
      ++time.done;
      time.seconds += record->seconds;
      if (work::makes_pictures(tasks.stage)) facts.seconds[time.stage][index] = record->seconds;
    }
    facts.stages.push_back(std::move(time));
  }
}

void warn_of_gaps(const fs::path& out, ReportFacts& facts) {
  if (facts.pictures.empty())
    facts.warnings.emplace_back("There are no pictures yet; `wold render` makes them.");
  for (const work::FramePictures& pictures : facts.pictures)
    if (const auto missing = work::missing_frames(pictures, facts.frames); !missing.empty())
      facts.warnings.push_back(fmt::format("{} has no pictures of the frames {}.",
                                           work::display_name(pictures),
                                           work::ranges_text(missing)));
  if (!fs::exists(out / "manifest.json"))
    facts.warnings.emplace_back(
        "There is no manifest.json: `wold render` has not finished this folder.");
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// What the renderers warned of, each once.
void read_log_warnings(const fs::path& out, ReportFacts& facts) {
  constexpr std::size_t max = 20;
  std::map<std::string, int> counts;
  for (const fs::path& path : files_below(out / "logs")) {
    std::istringstream lines(read_file(path));
    for (std::string line; std::getline(lines, line);)
      if (lower_case(line).find("warning:") != std::string::npos) ++counts[line];
  }
  std::size_t shown = 0;
  for (const auto& [line, count] : counts) {
    if (++shown > max) break;
    facts.warnings.push_back(count == 1 ? fmt::format("Log: {}", line)
                                        : fmt::format("Logs, {} times: {}", count, line));
  }
  if (counts.size() > max)
    facts.warnings.push_back(
        fmt::format("{} more kinds of warnings are in the logs.", counts.size() - max));
}

}  // namespace

ReportFacts report_facts(const fs::path& out) {
  work::require_known_format(out);
  ReportFacts facts;
  facts.pictures = work::frame_pictures(out);
  if (facts.pictures.empty() && !fs::exists(out / "scene.toml"))
    throw FileError(fmt::format(
        "found neither scene.toml nor frames in {}, expected a folder that `wold render` has made",
        out.string()));
  read_scene(out, facts);
  facts.frames = work::expected_frames(out, facts.pictures);
  read_passes(out, facts);
  read_scene_warnings(facts);
  warn_of_gaps(out, facts);
  read_times(out, facts);
  read_log_warnings(out, facts);
  return facts;
}

}  // namespace wold::report
