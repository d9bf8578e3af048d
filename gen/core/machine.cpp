#include "core/machine.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

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

double memory_of_process_bytes(pid_t process) {
  std::ifstream status(fmt::format("/proc/{}/status", process));
  for (std::string word; status >> word;)
    if (double kilobytes = 0.0; word == "VmData:" && status >> kilobytes) return kilobytes * 1024.0;
  return 0.0;
}

void limit_own_memory(double bytes) {
  rlimit limit{};
  ::getrlimit(RLIMIT_DATA, &limit);
  limit.rlim_cur = std::min(static_cast<rlim_t>(bytes), limit.rlim_max);
  ::setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace wold
