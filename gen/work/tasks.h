#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exporter/exporter.h"
#include "work/job.h"

namespace wold::work {

/// The steps of a film, in the order they are done.
enum class Step { texels, clouds, passes, scenes, pictures };

/// Tasks of one kind: a step, or of pictures those of one renderer.
struct Stage {
  static const Stage texels, clouds, passes, scenes;

  Step step = Step::texels;
  const exporter::Exporter* exporter = nullptr;  ///< of pictures: whose files its renderer shows

  bool operator==(const Stage&) const = default;
};
inline const Stage Stage::texels = {Step::texels};
inline const Stage Stage::clouds = {Step::clouds};
inline const Stage Stage::passes = {Step::passes};
inline const Stage Stage::scenes = {Step::scenes};

/// "texels", "clouds", "passes", "scenes" or an exporter's name: as on the command line and in
/// DIR/tasks.
std::string_view name_of(const Stage& stage);

inline bool makes_pictures(const Stage& stage) { return stage.step == Step::pictures; }

/// Who makes the pictures of a stage that makes some.
inline const render::Renderer& renderer_of(const Stage& stage) { return *stage.exporter->renderer; }

/// One unit of work: it makes whole files, the same bytes on any machine and in any order.
struct Task {
  Stage stage = {};
  int index = 1;  ///< of texels the variant, from 1; of clouds 1; else the frame
};

/// "scenes 7"
std::string text_of(const Task& task);

/// The tasks of a stage and what has to be done before them.
struct StageTasks {
  Stage stage = {};
  std::vector<int> indices;         ///< rising
  std::optional<Stage> after_all;   ///< every task of that stage
  std::optional<Stage> after_same;  ///< the task of the same index of that stage
};

/// The whole work of a job, in an order in which it can be done.
std::vector<StageTasks> stages_of(const Job& job);

/// The folders in which a frame's scene files lie, relative to the output folder. Some have other
/// frames' files, too.
std::vector<std::filesystem::path> folders_of_scene(const Job& job, int frame);

/// The folders that a task writes to, relative to the output folder. Their number does not grow
/// with the film.
std::vector<std::filesystem::path> folders_written(const Job& job, const Task& task);

/// A task of the job by its stage's name and index. Throws InputError that lists what there is.
Task find_task(const Job& job, const std::string& stage, int index);

}  // namespace wold::work
