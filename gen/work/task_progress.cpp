#include "work/task_progress.h"

#include <algorithm>

namespace wold::work {

void TaskProgress::begin(std::string_view, std::size_t parts) {
  const std::lock_guard lock(mutex_);
  parts_ = parts;
  done_ = 0;
}

void TaskProgress::advance(std::size_t parts, std::string_view) {
  const std::lock_guard lock(mutex_);
  done_ = std::min(done_ + parts, parts_);
  const std::size_t reached = parts_ == 0 ? 0 : (units - 1) * done_ / parts_;
  const std::size_t more = std::max(reached, reported_) - reported_;
  reported_ += more;
  whole_.advance(more, task_);
}

void TaskProgress::finish() {
  const std::lock_guard lock(mutex_);
  whole_.advance(units - reported_, task_);
  reported_ = units;
}

}  // namespace wold::work
