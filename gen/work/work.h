#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "core/progress.h"
#include "film/film.h"
#include "film/film_demand.h"
#include "place/growing_ground.h"
#include "work/file_states.h"
#include "work/job.h"
#include "work/renderers.h"
#include "work/scene_facts.h"
#include "work/shared_files.h"
#include "work/task_record.h"
#include "work/tasks.h"

namespace wold::work {

/// Whether a task has to be done. `perhaps`: it has to look, and may find that all is there, or its
/// scene files will be made anew and may turn out to be the same.
enum class Need { no, perhaps, yes };

struct Verdict {
  Need need = Need::no;
  std::string why;  ///< empty when it need not be done
};

/// What one renderer may take of the machine.
struct RendererLimits {
  int threads = 0;            ///< 0: all
  double memory_bytes = 0.0;  ///< 0: no limit
};

/// DIR/frames/<renderer>/0001.png of a task that makes one.
std::filesystem::path picture_path(const Job& job, const Task& task);

/// Does the tasks of a job and knows which have been done. A task is done when its record says that
/// it was made from what it would be made from now, and its files are as they were then. Pictures
/// are made from their scene files' bytes: a change of the scene that leaves those as they are
/// renders nothing again.
class Work {
 public:
  /// `job` has to outlive it, and so have `renderers`: without them run() makes no pictures. Throws
  /// FileError when a file that the scene names cannot be read.
  explicit Work(const Job& job, Renderers* renderers = nullptr);

  /// Without doing or writing anything.
  Verdict verdict(const Task& task);

  /// Has to be called before run(): what tasks share is made here. Throws what film::FilmPipeline
  /// does.
  void prepare(const Stage& stage, Progress& progress);

  /// Gives back the memory of what run() needs for all but pictures; prepare() makes it anew.
  void forget_film();

  /// Does a task, needed or not, and writes its record. `limits` is what the renderer may take.
  /// Tasks of texels may run at the same time, and pictures. Throws FileError, also when what the
  /// task depends on has not been done, RendererError and InterruptedError.
  void run(const Task& task, const RendererLimits& limits, Progress& progress);

  /// Removes the scene files of those of the frames whose pictures are all made, but what scenes of
  /// other frames share. Their tasks then count as done for as long as those of their pictures are,
  /// for jobs that want pictures. Records say so first, as in remove_texels(). For a process that
  /// has the folder to itself. Throws FileError.
  void remove_scenes(std::span<const int> frames);

  /// Removes the files of the job's texels, which no task needs as long as all scene files are
  /// done; does nothing when some are not. Their records say so first, so that a process which is
  /// killed here leaves nothing that looks damaged. For a process that has the folder to itself.
  /// Throws FileError.
  void remove_texels();

  /// When all is done: says in DIR/scene.toml and DIR/manifest.json what is there. For a process
  /// that has the folder to itself. Throws FileError.
  void finish();

  const TaskRecords& records() const { return records_; }

  /// Found when it is first asked for. Throws what FilmDemand does.
  const film::FilmDemand& demand();

  /// Equal for equal scenes, but for what changes no file.
  const std::string& scene_hash() const { return facts_hash_; }

 private:
  /// Hashes of a frame's scene files and the renderer's program, by exporter.
  using SceneHashes = std::map<std::string_view, std::string>;

  struct Made {
    std::vector<std::filesystem::path> files;
    double renderer_memory_bytes = 0.0;
  };

  std::string source(const Task& task);
  std::string source(const Task& task, std::span<const passes::Pass> passes);
  bool is_made_from_this(const Task& task, const TaskRecord& record);
  std::string picture_source(const Task& task);
  const SceneHashes& scene_hashes(int frame);
  Verdict judge(const Task& task);
  Verdict judge_removed(const Task& task, const TaskRecord& record);
  Verdict outdated(const Task& task, const TaskRecord& record);
  bool are_texels_read();
  bool are_pictures_made(int frame);
  bool are_scenes_right(int frame);
  Made make(const Task& task, const RendererLimits& limits, Progress& progress);
  Made make_picture(const Task& task, const RendererLimits& limits, Progress& progress);
  void remove_damaged(const Task& task);
  void remove_outputs(const Task& task);
  std::vector<std::filesystem::path> own_scene_files(int frame, const TaskRecord& record) const;
  void write_record(const Task& task, const TaskRecord& record);
  film::FilmPipeline& film();

  const Job& job_;
  Renderers* renderers_;
  SceneFacts facts_;
  std::string facts_hash_;
  std::string build_;  ///< hash of the program, its models and templates
  std::map<std::string_view, std::string> programs_;  ///< hash, by exporter with a renderer
  FileStates states_;
  TaskRecords records_;
  std::recursive_mutex mutex_;                  ///< of the four that follow
  std::map<int, Verdict> scenes_;               ///< verdicts, by frame
  std::map<int, SceneHashes> scene_hashes_;     ///< by frame
  std::optional<bool> texels_are_read_;         ///< until a task is run
  std::map<std::string, std::string> changes_;  ///< since facts of that hash, in words
  std::optional<SharedFiles> shared_;           ///< from remove_scenes() on
  std::optional<place::GrowingGround> land_;    ///< from demand() on, until film() takes it
  std::optional<film::FilmPipeline> film_;
  std::optional<film::FilmDemand> demand_;
  bool demand_found_ = false;
};

}  // namespace wold::work
