#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wold::render {

/// How a program ended: by itself with a code, or by a signal (then the code means nothing).
struct ProcessEnd {
  int code = 0;
  int signal = 0;  ///< 0: none
  /// That the program was seen to have, without its children; of run_to_end().
  double max_memory_bytes = 0.0;
};

/// What a program may take.
struct ProcessLimits {
  std::chrono::seconds time;
  double memory_bytes = 0.0;  ///< Process's
};

/// "exit code 1" or "killed by signal 11 (Segmentation fault)".
std::string to_string(const ProcessEnd& end);

/// A running program in a process group of its own, its standard output and error joined. When it
/// goes out of scope the whole group is gone: asked to terminate, then killed. It is killed, too,
/// when the thread that started it ends, as when this program is killed.
class Process {
 public:
  /// Starts arguments[0] in `folder`. It gets at most `memory_bytes` of its own, as does each of
  /// its children; 0: what this program may have. Throws RendererError with the system's reason.
  Process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
          double memory_bytes);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// New output; empty when there is none within `wait`.
  std::string read(std::chrono::milliseconds wait);

  /// How it ended, nothing while it runs.
  std::optional<ProcessEnd> ended() const;

  /// What the program, without its children, has now; see memory_of_process_bytes().
  double memory_bytes() const;

  /// Ends every process of the group that is left.
  void stop();

 private:
  pid_t group_ = 0;
  int output_ = -1;
};

/// Runs a program in `folder` to its end and hands on what it says; nothing when it took longer
/// than it may. `interrupted` is asked several times a second. The program and its children have
/// ended in every case. Throws RendererError when it cannot be started, InterruptedError, and what
/// `hear` throws.
std::optional<ProcessEnd> run_to_end(const std::vector<std::string>& arguments,
                                     const std::filesystem::path& folder,
                                     const ProcessLimits& limits,
                                     const std::function<void(std::string_view)>& hear,
                                     const std::function<bool()>& interrupted);

}  // namespace wold::render
