#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "work/file_states.h"
#include "work/scene_facts.h"
#include "work/tasks.h"

namespace wold::work {

/// What a task that has been done says of itself: DIR/tasks/<stage>_<index>.json, one file for
/// each, so that tasks on many machines never write the same one.
struct TaskRecord {
  std::string source;  ///< hash of everything it was made from
  std::string facts;   ///< hash_of() the scene's facts, which stand in DIR/tasks/scene_<hash>.json
  std::map<std::string, FileState> outputs;  ///< by names relative to DIR
  double seconds = 0.0;                      ///< that it took
  double memory_bytes = 0.0;                 ///< that a renderer took; else 0, since tasks share it
  /// Its outputs may be gone: they were removed when nothing needed them any more.
  bool removed = false;
};

/// The records of an output folder.
class TaskRecords {
 public:
  explicit TaskRecords(const std::filesystem::path& out) : folder_(out / "tasks") {}

  /// Nothing when the task was never done, or its record is damaged.
  std::optional<TaskRecord> read(const Task& task) const;
  /// Throws FileError.
  void write(const Task& task, const TaskRecord& record) const;

  /// The facts of that hash; empty when they are not there.
  SceneFacts read_facts(const std::string& hash) const;
  /// Throws FileError.
  void write_facts(const SceneFacts& facts) const;

  /// Calls visit(stage's name, record) for the records of all tasks, also of other jobs.
  void for_each(const std::function<void(const std::string&, const TaskRecord&)>& visit) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace wold::work
