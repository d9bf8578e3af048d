#include "core/temporary_name.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <optional>
#include <string_view>

namespace wold {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::hours longest_task{24 * 8};  // render.timeout is a week at most

/// An earlier process of the same number has ended, too.
bool has_ended(pid_t process) {
  return process == ::getpid() || (::kill(process, 0) != 0 && errno == ESRCH);
}

std::optional<pid_t> whole_number(std::string_view text) {
  pid_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

}  // namespace

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

fs::path temporary_name(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.{}.tmp{}", path.stem().string(), host_name(),
                                          ::getpid(), path.extension().string());
}

bool is_left_behind(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::size_t mark = name.rfind(".tmp");
  if (!name.starts_with('.') || mark == std::string::npos) return false;
  const std::string_view before = std::string_view(name).substr(0, mark);
  const std::size_t dot = before.rfind('.');
  const auto process = whole_number(before.substr(dot + 1));
  if (!process) return false;
  if (before.substr(0, dot).ends_with(fmt::format(".{}", host_name()))) return has_ended(*process);
  std::error_code gone;
  const auto touched = fs::last_write_time(path, gone);
  return !gone && touched < fs::file_time_type::clock::now() - longest_task;
}

}  // namespace wold
