#include "render/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "render/command.h"
#include "render/log.h"
#include "render/missing_things.h"
#include "render/picture_check.h"
#include "render/process.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

/// Turns fractions into units of a 100-unit stage that never goes back.
class Percent {
 public:
  explicit Percent(Progress& progress) : progress_(progress) {}
  void reach(double fraction) {
    const auto percent = static_cast<std::size_t>(std::floor(100.0 * fraction));
    if (percent <= done_) return;
    progress_.advance(percent - done_, {});
    done_ = percent;
  }

 private:
  Progress& progress_;
  std::size_t done_ = 0;
};

/// Reads what the program says: progress to one side, everything else to the log.
class Listener {
 public:
  Listener(const Renderer& kind, Percent& percent, Log& log)
      : kind_(kind), percent_(percent), log_(log) {}
  void hear(std::string_view bytes, bool at_end = false) {
    lines_.add(bytes);
    for (std::string line; lines_.next(line, at_end);) {
      if (const auto fraction = progress_fraction(kind_, line))
        percent_.reach(*fraction);
      else
        log_.add(line);
    }
  }

 private:
  const Renderer& kind_;
  Percent& percent_;
  Log& log_;
  LineSplitter lines_;
};

/// Renderers say in many ways that there was too little, some only by crashing.
std::string memory_advice(double memory_bytes) {
  if (memory_bytes <= 0.0) return {};
  return fmt::format(" (it was allowed {:.0f} MB of memory: if that was too little, allow more)",
                     memory_bytes / 1e6);
}

RendererError failure(const Job& job, const Log& log, std::string_view reason) {
  return RendererError(fmt::format(
      "{} failed on frame {}: {}{}; its log is {}{}", display_name(*job.program.kind), job.frame,
      reason, memory_advice(job.memory_bytes), log.path().string(), log.last_lines()));
}

/// Runs the program to its end; leaving by an exception ends it too.
ProcessEnd watch(const Job& job, const Command& command, Listener& listener, const Log& log,
                 const std::function<bool()>& interrupted) {
  const auto hear = [&](std::string_view bytes) { listener.hear(bytes); };
  const auto end = run_to_end(command.arguments, command.folder, {job.timeout, job.memory_bytes},
                              hear, interrupted);
  if (!end) throw failure(job, log, fmt::format("no picture after {} s", job.timeout.count()));
  listener.hear({}, /*at_end=*/true);
  return *end;
}

/// Leaves nothing but the pixels: renderers note in their pictures when they made them and how long
/// it took, and the same picture would have other bytes every time.
void drop_notes(const fs::path& output) {
  if (output.extension() == ".png") write_image(output, read_image(output), PixelFormat::uint8);
}

/// What is wrong with a finished picture; empty when nothing is.
std::string problem_of(const fs::path& output, const Job& job, const ExpectedPicture& expected) {
  const std::string problem = picture_problem(output, job.size_px);
  return problem.empty() ? missing_things(output, expected, *job.program.kind) : problem;
}

double render_to(const fs::path& output, const Job& job, Progress& progress,
                 const std::function<bool()>& interrupted) {
  const ExpectedPicture expected =
      job.expected.empty() ? ExpectedPicture{} : read_expected_picture(job.expected);
  Log log(job.log);
  const Command command = render_command(job, output);
  log.add(fmt::format("{}", fmt::join(command.arguments, " ")));
  Percent percent(progress);
  Listener listener(*job.program.kind, percent, log);
  const ProcessEnd end = watch(job, command, listener, log, interrupted);
  if (end.code != 0 || end.signal != 0) throw failure(job, log, to_string(end));
  if (const std::string problem = problem_of(output, job, expected); !problem.empty())
    throw failure(job, log, problem);
  drop_notes(output);
  percent.reach(1.0);
  return end.max_memory_bytes;
}

/// Removes what a stopped renderer leaves beside its output. By its name: the folder, which has a
/// film's pictures, may be long.
class Leftovers {
 public:
  Leftovers(fs::path output, const Renderer& renderer)
      : state_(renderer.state_extension.empty()
                   ? fs::path()
                   : output.replace_extension(renderer.state_extension)) {}
  ~Leftovers() {
    std::error_code ignored;
    if (!state_.empty()) fs::remove(state_, ignored);
  }
  Leftovers(const Leftovers&) = delete;
  Leftovers& operator=(const Leftovers&) = delete;

 private:
  fs::path state_;
};

/// Finds out before the long work whether its result can be kept.
void require_writable(const fs::path& output) {
  std::error_code ignored;
  if (!std::ofstream(output)) throw FileError("the folder cannot be written");
  fs::remove(output, ignored);
}

}  // namespace

double run(const Job& job, Progress& progress, const std::function<bool()>& interrupted) {
  const fs::path picture = fs::absolute(job.picture);
  make_folder(picture.parent_path());
  std::error_code ignored;
  fs::remove(picture, ignored);
  progress.begin(fmt::format("{} frame {}", display_name(*job.program.kind), job.frame), 100);
  double max_memory_bytes = 0.0;
  write_file_by_path(picture, [&](const fs::path& output) {
    require_writable(output);
    const Leftovers leftovers(output, *job.program.kind);
    max_memory_bytes = render_to(output, job, progress, interrupted);
  });
  progress.end();
  return max_memory_bytes;
}

}  // namespace wold::render
