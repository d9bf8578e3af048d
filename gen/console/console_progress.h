#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "core/progress.h"

namespace wold::console {

/// How progress is shown: a bar that is redrawn, lines for logs, or not at all.
enum class ProgressStyle { bar, lines, none };

/// A bar when stderr is a terminal, lines otherwise, nothing when quiet.
ProgressStyle progress_style(bool quiet);

/// Shows on stderr how far the work is and how long it will take. advance() throws
/// InterruptedError once the user asked to stop, whatever the style. Thread-safe.
class ConsoleProgress final : public Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// `now` tells the time; tests have another clock.
  explicit ConsoleProgress(ProgressStyle style, std::function<Clock::time_point()> now = Clock::now)
      : style_(style), now_(std::move(now)) {}
  /// Leaves an unfinished bar on a line of its own, so that a message can follow.
  ~ConsoleProgress() override;
  ConsoleProgress(const ConsoleProgress&) = delete;
  ConsoleProgress& operator=(const ConsoleProgress&) = delete;
  void begin(std::string_view stage, std::size_t units) override;
  void advance(std::size_t units, std::string_view detail) override;
  void end() override;
  void say(std::string_view message) override;

 private:
  double fraction() const;
  std::string text(std::string_view detail) const;
  void show(std::string_view detail);

  const ProgressStyle style_;
  const std::function<Clock::time_point()> now_;
  std::mutex mutex_;
  std::string stage_;
  std::size_t units_ = 0;
  std::size_t done_ = 0;
  bool bar_open_ = false;
  int tenths_shown_ = 0;  ///< of the stage, for lines
  Clock::time_point start_;
  Clock::time_point shown_;  ///< when the bar was drawn last
};

}  // namespace wold::console
