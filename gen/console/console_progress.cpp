#include "console/console_progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "console/output.h"
#include "core/duration_text.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/printable.h"

namespace wold::console {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr std::chrono::milliseconds redraw_interval{100};
constexpr int bar_width = 24;

std::string bar_text(double fraction) {
  const int full = static_cast<int>(fraction * bar_width);
  return fmt::format("[{:#<{}}{:.<{}}]", "", full, "", bar_width - full);
}

}  // namespace

ProgressStyle progress_style(bool quiet) {
  if (quiet) return ProgressStyle::none;
  return ::isatty(STDERR_FILENO) != 0 ? ProgressStyle::bar : ProgressStyle::lines;
}

ConsoleProgress::~ConsoleProgress() {
  if (bar_open_) print_progress("\n");
}

void ConsoleProgress::begin(std::string_view stage, std::size_t units) {
  const std::lock_guard lock(mutex_);
  stage_ = printable(stage);
  units_ = units;
  done_ = 0;
  tenths_shown_ = 0;
  start_ = now_();
  shown_ = {};
  if (style_ == ProgressStyle::lines) print_progress(stage_ + "\n");
  if (style_ == ProgressStyle::bar) show("");
}

void ConsoleProgress::advance(std::size_t units, std::string_view detail) {
  if (interrupted()) throw InterruptedError();
  const std::lock_guard lock(mutex_);
  done_ = std::min(done_ + units, units_);
  show(detail);
}

void ConsoleProgress::end() {
  const std::lock_guard lock(mutex_);
  bar_open_ = false;
  const std::string took = clock_text(Seconds(now_() - start_).count());
  if (style_ == ProgressStyle::bar)
    print_progress(fmt::format("\r\x1b[K{}: done in {}\n", stage_, took));
  if (style_ == ProgressStyle::lines) print_progress(fmt::format("{}: done in {}\n", stage_, took));
}

void ConsoleProgress::say(std::string_view message) {
  const std::lock_guard lock(mutex_);
  if (bar_open_) print_progress("\n");
  bar_open_ = false;
  print_message(message);
}

double ConsoleProgress::fraction() const {
  return units_ == 0 ? 1.0 : static_cast<double>(done_) / static_cast<double>(units_);
}

std::string ConsoleProgress::text(std::string_view detail) const {
  std::string line = fmt::format("{} {}/{} {:3.0f} %", stage_, done_, units_, 100.0 * fraction());
  if (done_ > 0 && done_ < units_) {
    const double elapsed_s = Seconds(now_() - start_).count();
    line += fmt::format(", {} left", clock_text(elapsed_s * (1.0 / fraction() - 1.0)));
  }
  return detail.empty() ? line : fmt::format("{}  {}", line, printable(detail));
}

void ConsoleProgress::show(std::string_view detail) {
  const int tenths = static_cast<int>(10.0 * fraction());
  if (style_ == ProgressStyle::lines && tenths > tenths_shown_) {
    tenths_shown_ = tenths;
    print_progress(text(detail) + "\n");
  }
  if (style_ == ProgressStyle::bar && now_() - shown_ >= redraw_interval) {
    shown_ = now_();
    bar_open_ = true;
    print_progress(fmt::format("\r\x1b[K{} {}", bar_text(fraction()), text(detail)));
  }
}

}  // namespace wold::console
