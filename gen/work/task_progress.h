#pragma once

#include <mutex>
#include <string>

#include "core/progress.h"

namespace wold::work {

/// One task's share of a stage, 100 units, while other tasks have theirs. The task's own stages are
/// not shown; its last unit is finish()'s. Thread-safe.
class TaskProgress final : public Progress {
 public:
  static constexpr std::size_t units = 100;

  TaskProgress(Progress& whole, std::string task) : whole_(whole), task_(std::move(task)) {}
  void begin(std::string_view stage, std::size_t parts) override;
  void advance(std::size_t parts, std::string_view detail) override;
  void end() override {}
  void say(std::string_view message) override { whole_.say(message); }
  /// All of it is done.
  void finish();

 private:
  Progress& whole_;
  const std::string task_;
  std::mutex mutex_;
  std::size_t parts_ = 0;
  std::size_t done_ = 0;      ///< of the parts
  std::size_t reported_ = 0;  ///< of the units
};

}  // namespace wold::work
