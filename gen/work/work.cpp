#include "work/work.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/error.h"
#include "core/file_list.h"
#include "core/files.h"
#include "core/interrupt.h"
#include "film/exporters.h"
#include "render/run.h"
#include "scene/write.h"
#include "work/build_hash.h"
#include "work/folder_format.h"
#include "work/manifest.h"
#include "work/own_folder.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

/// Of the shipped files that pictures depend on, by exporter.
std::map<std::string_view, std::string> hashes_of_programs(exporter::Exporters exporters) {
  std::map<std::string_view, std::string> hashes;
  for (const exporter::Exporter* one : exporters)
    if (one->renderer)
      hashes[one->name] =
          hash_of_programs_below(shipped_file(std::string(one->renderer->templates)));
  return hashes;
}

render::Job picture_job(const Job& job, const Task& task, const RendererLimits& limits,
                        Renderers& renderers) {
  const scene::Render& settings = job.scene.render;
  const std::string number = fmt::format("{:04}", task.index);
  render::Job picture;
  picture.program = renderers.program(*task.stage.exporter);
  picture.scene_folder = job.out / name_of(task.stage);
  picture.frame = task.index;
  picture.size_px = {settings.size_px[0], settings.size_px[1]};
  picture.samples = settings.samples;
  picture.device = scene::word_of(settings.device);
  picture.threads = limits.threads;
  picture.memory_bytes = limits.memory_bytes;
  picture.timeout = std::chrono::seconds(std::lround(settings.timeout_minutes * 60.0));
  picture.picture = picture_path(job, task);
  picture.expected =
      picture.scene_folder / "data" / fmt::format("frame_{}", number) / "expected.json";
  picture.log = job.out / "logs" / fmt::format("{}_{}.log", name_of(task.stage), number);
  return picture;
}

/// Whether such a task makes a file of that name: a record that somebody has edited may name
/// others.
bool may_make(const Stage& stage, const fs::path& name) {
  const std::string first = name.begin()->string();
  const std::string extension = name.extension().string();
  switch (stage.step) {
    case Step::texels:
      return first == "texels" && extension == ".vdb";
    case Step::clouds:
      return first == "clouds" && extension == ".png";
    case Step::passes:
      return first == "passes" && extension == ".exr";
    case Step::scenes:
      return std::ranges::any_of(film::exporters(), [&](const exporter::Exporter* one) {
        return exporter::writes(*one, first);
      });
    case Step::pictures:
      return name == fs::path("frames") / name_of(stage) / name.filename() && extension == ".png";
  }
  return false;
}

/// The files of a record that such a task makes, relative to the output folder.
std::vector<fs::path> files_of(const Task& task, const TaskRecord& record) {
  std::vector<fs::path> files;
  for (const auto& [name, state] : record.outputs)
    if (const fs::path file = fs::path(name).lexically_normal(); may_make(task.stage, file))
      files.push_back(file);
  return files;
}

/// "camera.eye, camera.target and 3 more"
std::string listed(const std::vector<std::string>& keys) {
  constexpr std::size_t max = 4;
  const std::size_t shown = std::min(keys.size(), max);
  const std::string text =
      fmt::format("{}", fmt::join(keys.begin(), keys.begin() + static_cast<long>(shown), ", "));
  return shown == keys.size() ? text : fmt::format("{} and {} more", text, keys.size() - shown);
}

}  // namespace

fs::path picture_path(const Job& job, const Task& task) {
  return job.out / "frames" / name_of(task.stage) / fmt::format("{:04}.png", task.index);
}

Work::Work(const Job& job, Renderers* renderers)
    : job_(job),
      renderers_(renderers),
      facts_(facts_of(job.scene)),
      facts_hash_(hash_of(facts_)),
      build_(hash_of_build()),
      programs_(hashes_of_programs(job.exporters)),
      states_(job.out),
      records_(job.out) {}

Verdict Work::verdict(const Task& task) {
  const std::lock_guard lock(mutex_);
  if (task.stage != Stage::scenes) return judge(task);
  if (const auto known = scenes_.find(task.index); known != scenes_.end()) return known->second;
  return scenes_[task.index] = judge(task);
}

Verdict Work::judge(const Task& task) {
  const auto record = records_.read(task);
  if (!record) return {Need::yes, "never made"};
  if (record->removed) return judge_removed(task, *record);
  for (const auto& [name, state] : record->outputs)
    if (!fs::exists(job_.out / name)) return {Need::yes, fmt::format("{} is missing", name)};
  if (makes_pictures(task.stage) && !are_scenes_right(task.index))
    return {Need::perhaps, "its scene files will be made anew; runs if they change"};
  if (!is_made_from_this(task, *record)) return outdated(task, *record);
  for (const auto& [name, state] : record->outputs)
    if (!states_.is_still(name, state))
      return {Need::yes, fmt::format("{} is not what was written", name)};
  return {};
}

Verdict Work::judge_removed(const Task& task, const TaskRecord& record) {
  if (task.stage == Stage::scenes && !is_made_from_this(task, record))
    return outdated(task, record);
  if (task.stage == Stage::scenes ? are_pictures_made(task.index) : are_texels_read()) return {};
  return {Need::yes, "removed when nothing needed it"};
}

/// For all frames: what reads texels needs them no more.
bool Work::are_texels_read() {
  const auto is_done = [&](const Stage& stage) {
    return std::ranges::all_of(job_.frames, [&](int frame) {
      return verdict({stage, frame}).need == Need::no;
    });
  };
  if (!texels_are_read_)
    texels_are_read_ = (job_.exporters.empty() || is_done(Stage::scenes)) &&
                       (job_.passes.empty() || is_done(Stage::passes));
  return *texels_are_read_;
}

/// Whether nobody needs the frame's scene files any more. Never where they are what is wanted: by
/// the job, or as of an exporter without a renderer.
bool Work::are_pictures_made(int frame) {
  const auto is_made = [&](const exporter::Exporter* one) {
    return one->renderer && verdict({Stage{Step::pictures, one}, frame}).need == Need::no;
  };
  return job_.has_pictures && std::ranges::all_of(job_.exporters, is_made);
}

/// Whether pictures are to be made of the frame's scene files as they are, or were when removed.
bool Work::are_scenes_right(int frame) {
  const Task scenes = {Stage::scenes, frame};
  const auto known = scenes_.find(frame);  // spares a read
  if (known != scenes_.end() && known->second.need == Need::no) return true;
  if (const auto record = records_.read(scenes); record && record->removed)
    return is_made_from_this(scenes, *record);
  return verdict(scenes).need == Need::no;
}

Verdict Work::outdated(const Task& task, const TaskRecord& record) {
  if (makes_pictures(task.stage))
    return {Need::yes, "made from other scene files or with other settings"};
  const auto [known, is_new] = changes_.try_emplace(record.facts);
  std::string& why = known->second;
  if (is_new) {
    const SceneFacts then = records_.read_facts(record.facts);
    why = record.facts == facts_hash_ || then.empty()
              ? "made for other frames, renderers or passes, or by another build of wold"
              : fmt::format("{} changed", listed(changed_keys(facts_, then)));
  }
  if (task.stage != Stage::texels) return {Need::yes, why};
  return {Need::perhaps, why + "; texels that are right stay"};
}

bool Work::is_made_from_this(const Task& task, const TaskRecord& record) {
  if (record.source == source(task)) return true;
  return task.stage == Stage::passes && job_.is_blur_alone &&
         record.source == source(task, passes::passes_of("all"));
}

std::string Work::source(const Task& task) { return source(task, job_.passes); }

std::string Work::source(const Task& task, std::span<const passes::Pass> passes) {
  if (makes_pictures(task.stage)) return picture_source(task);
  std::string text = fmt::format("{} {} {} ", text_of(task), facts_hash_, build_);
  if (task.stage == Stage::passes) text += passes::text_of(passes);
  if (task.stage == Stage::texels) {
    text += ranges_text(job_.frames);
    if (film::reads_unlit_texels(job_)) text += " unlit";
  }
  if (task.stage == Stage::scenes)
    for (const exporter::Exporter* one : job_.exporters)
      text += fmt::format("{}{}", one == job_.exporters.front() ? "" : " ", one->name);
  return content_hash(text);
}

std::string Work::picture_source(const Task& task) {
  const scene::Render& settings = job_.scene.render;
  std::string text =
      fmt::format("{} {}x{} {} {}", text_of(task), settings.size_px[0], settings.size_px[1],
                  settings.samples, scene_hashes(task.index).at(name_of(task.stage)));
  // Another device adds up in another order: the last bits differ.
  if (renderer_of(task.stage).has_devices)
    text += fmt::format(" {}", scene::word_of(settings.device));
  return content_hash(text);
}

const Work::SceneHashes& Work::scene_hashes(int frame) {
  const std::lock_guard lock(mutex_);
  SceneHashes& hashes = scene_hashes_[frame];
  if (!hashes.empty()) return hashes;
  const auto record = records_.read({Stage::scenes, frame});
  for (const auto& [exporter, program] : programs_) {
    const std::string folder = fmt::format("{}/", exporter);
    std::string text = program;
    if (record)
      for (const auto& [name, state] : record->outputs)
        if (name.starts_with(folder)) text += fmt::format("{} {}\n", name, state.hash);
    hashes[exporter] = content_hash(text);
  }
  return hashes;
}

film::FilmPipeline& Work::film() {
  if (!film_) {
    place::GrowingGround land = land_ ? std::move(*land_) : place::growing_ground(job_.scene);
    land_.reset();
    film_.emplace(job_, std::move(land));
  }
  return *film_;
}

const film::FilmDemand& Work::demand() {
  if (!demand_) {
    if (!land_) land_ = place::growing_ground(job_.scene);
    demand_.emplace(job_, *land_);
    if (film_) land_.reset();
  }
  return *demand_;
}

void Work::prepare(const Stage& stage, Progress& progress) {
  if (!makes_pictures(stage) && !film_) {
    progress.begin("ground", 1);  // takes most of it
    film();
    progress.end();
  }
  if (stage == Stage::texels && !demand_found_) {
    film().find_demand(progress);
    demand_found_ = true;
  }
  write_folder_format(job_.out);  // first: by its records an output folder is known
  records_.write_facts(facts_);
  update_file(job_.out / "scene.toml", scene::resolved_toml(job_.scene));
  if (stage.step >= Step::scenes) film::write_film_files(job_);
  // It lists files that will be others; `render` and `generate` write it when all is done.
  if (is_own_manifest(job_.out / "manifest.json")) fs::remove(job_.out / "manifest.json");
}

void Work::remove_scenes(std::span<const int> frames) {
  if (!shared_) shared_.emplace(records_);
  const std::lock_guard lock(mutex_);
  for (const int frame : frames) {
    const Task scenes = {Stage::scenes, frame};
    if (verdict(scenes).need != Need::no || !are_pictures_made(frame)) continue;
    remove_outputs(scenes);
    scenes_.erase(frame);
  }
}

void Work::remove_texels() {
  if (!are_texels_read()) return;
  for (const StageTasks& stage : stages_of(job_))
    if (stage.stage == Stage::texels)
      for (const int index : stage.indices) remove_outputs({stage.stage, index});
}

/// They go in the order of their names: where the last is gone, all are.
void Work::remove_outputs(const Task& task) {
  auto record = records_.read(task);
  if (!record) return;
  const bool was_removed = record->removed;
  if (!was_removed) {
    record->removed = true;
    write_record(task, *record);
  }
  const std::vector<fs::path> files =
      task.stage == Stage::scenes ? own_scene_files(task.index, *record) : files_of(task, *record);
  if (files.empty() || (was_removed && !fs::exists(job_.out / files.back()))) return;
  std::set<fs::path> folders;
  for (const fs::path& file : files) {
    remove_file(job_.out / file);
    folders.insert(file.parent_path());
  }
  for (fs::path folder : folders)
    for (; !folder.empty(); folder = folder.parent_path()) remove_empty_folder(job_.out / folder);
}

/// Those of a frame's scene files that no other frame shares.
std::vector<fs::path> Work::own_scene_files(int frame, const TaskRecord& record) const {
  const std::vector<fs::path> folders = folders_of_scene(job_, frame);
  const auto may_be_there = [&](const fs::path& file) {
    const fs::path folder = file.parent_path();
    return folder.empty() ? std::ranges::any_of(job_.exporters,
                                                [&](const exporter::Exporter* one) {
                                                  return exporter::writes(*one, file.string());
                                                })
                          : std::ranges::count(folders, folder) > 0;
  };
  std::vector<fs::path> files;
  for (const auto& [name, state] : record.outputs)
    if (const fs::path file = fs::path(name).lexically_normal();
        may_be_there(file) && !shared_->is_used(name))
      files.push_back(file);
  return files;
}

/// In place of the one that there may be.
void Work::write_record(const Task& task, const TaskRecord& record) {
  const bool may_share = shared_ && task.stage == Stage::scenes;
  if (may_share)
    if (const auto old = records_.read(task)) shared_->take_away(*old);
  records_.write(task, record);
  if (may_share) shared_->add(record);
}

void Work::finish() {
  forget_film();  // and its scratch files
  update_file(job_.out / "scene.toml", scene::resolved_toml(job_.scene));
  film::write_film_files(job_);
  write_manifest(job_.out, records_, states_);
}

void Work::forget_film() {
  film_.reset();
  land_.reset();
  demand_found_ = false;
}

void Work::run(const Task& task, const RendererLimits& limits, Progress& progress) {
  remove_damaged(task);
  const auto start = std::chrono::steady_clock::now();
  const Made made = make(task, limits, progress);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  TaskRecord record{source(task), facts_hash_, {}, took.count(), made.renderer_memory_bytes};
  for (const fs::path& file : made.files) {
    const std::string name = file.lexically_relative(job_.out).generic_string();
    record.outputs[name] = states_.of(name);
  }
  write_record(task, record);
  const std::lock_guard lock(mutex_);
  texels_are_read_.reset();
  if (task.stage != Stage::scenes) return;
  scenes_.erase(task.index);
  scene_hashes_.erase(task.index);
}

Work::Made Work::make(const Task& task, const RendererLimits& limits, Progress& progress) {
  switch (task.stage.step) {
    case Step::texels:
      return {film().make_texels(task.index - 1, progress)};
    case Step::clouds:
      return {film().make_cloud_pictures()};
    case Step::passes:
      return {film().make_passes(task.index, job_.passes, progress)};
    case Step::scenes:
      return {film().make_frame(task.index, progress)};
    case Step::pictures:
      return make_picture(task, limits, progress);
  }
  return {};
}

Work::Made Work::make_picture(const Task& task, const RendererLimits& limits, Progress& progress) {
  const Task scene_files = {Stage::scenes, task.index};
  if (const Verdict verdict = this->verdict(scene_files); verdict.need != Need::no)
    throw FileError(
        fmt::format("the task \"{}\" needs the files of \"{}\", which has to be run first: {}",
                    text_of(task), text_of(scene_files), verdict.why));
  const render::Job picture = picture_job(job_, task, limits, *renderers_);
  if (const auto& require = renderer_of(task.stage).require_data_only)
    require(picture.scene_folder, task.index);
  const double memory_bytes = render::run(picture, progress, interrupted);
  return {{picture.picture}, memory_bytes};
}

/// What was made from the same, but is not what was written: nobody else would notice.
void Work::remove_damaged(const Task& task) {
  const auto record = records_.read(task);
  if (!record || !is_made_from_this(task, *record)) return;
  for (const auto& [name, state] : record->outputs)
    if (const fs::path file = fs::path(name).lexically_normal();
        may_make(task.stage, file) && !states_.is_still(name, state)) {
      require_no_way_out(job_.out, std::array{file.parent_path()});
      fs::remove(job_.out / file);
    }
}

}  // namespace wold::work
