#include "core/machine.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace wold {
namespace {

/// The limit of the control group, version 2; none is written "max" or not at all.
double group_limit_bytes() {
  std::ifstream file("/sys/fs/cgroup/memory.max");
  double bytes = 0.0;
  return file >> bytes ? bytes : std::numeric_limits<double>::infinity();
}

}  // namespace

double machine_memory_bytes() {
  const double physical =
      static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::min(physical, group_limit_bytes());
}

}  // namespace wold
