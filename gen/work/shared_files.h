#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "work/task_record.h"

namespace wold::work {

/// How many frames' scene files are made of each file: terrain, volumes and flakes are shared.
class SharedFiles {
 public:
  /// By the records of all frames of an output folder, also of other jobs' frames. Those whose
  /// files were removed count none.
  explicit SharedFiles(const TaskRecords& records);

  /// Of a record that is written, and of one that is replaced.
  void add(const TaskRecord& frame);
  void take_away(const TaskRecord& frame);

  /// By its name relative to the output folder.
  bool is_used(const std::string& name) const { return frames_.contains(name); }

 private:
  std::map<std::string, std::size_t> frames_;  ///< by file; no file has none
};

}  // namespace wold::work
