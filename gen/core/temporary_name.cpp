#include "core/temporary_name.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/random.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/files.h"
#include "core/number_text.h"

namespace wold {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::hours longest_task{24 * 8};  // render.timeout is a week at most

constexpr std::size_t seal_digits = 8;
constexpr std::size_t longest_stem = 80;  ///< bytes: the whole name may have 255

std::uint64_t random_number() {
  std::uint64_t number = 0;
  if (::getentropy(&number, sizeof number) != 0)
    throw FileError(fmt::format("the system gives no random numbers: {}", std::strerror(errno)));
  return number;
}

/// By which a name of this program is told from any other.
std::string seal_of(std::string_view text) { return content_hash(text).substr(0, seal_digits); }

/// The name between its first dot and ".tmp" without the seal; nothing when that is another.
std::optional<std::string_view> sealed_part(std::string_view name) {
  const std::size_t mark = name.rfind(".tmp");
  if (!name.starts_with('.') || mark == std::string_view::npos || mark < 1 + seal_digits)
    return std::nullopt;
  const std::string_view sealed = name.substr(1, mark - 1 - seal_digits);
  if (seal_of(sealed) != name.substr(mark - seal_digits, seal_digits)) return std::nullopt;
  return sealed;
}

/// An earlier process of the same number has ended, too.
bool has_ended(pid_t process) {
  return process == ::getpid() || (::kill(process, 0) != 0 && errno == ESRCH);
}

}  // namespace

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

fs::path temporary_name(const fs::path& path) {
  const std::string sealed =
      fmt::format("{}.{}.{}.{:016x}", path.stem().string().substr(0, longest_stem), host_name(),
                  ::getpid(), random_number());
  return path.parent_path() /
         fmt::format(".{}{}.tmp{}", sealed, seal_of(sealed), path.extension().string());
}

bool is_left_behind(const fs::path& path) {
  const std::string name = path.filename().string();
  const auto sealed = sealed_part(name);
  if (!sealed) return false;
  const std::string_view before = sealed->substr(0, sealed->rfind('.'));  // the random number
  const std::size_t dot = before.rfind('.');
  const auto process = number_in<pid_t>(before.substr(dot + 1));
  if (!process || *process < 1) return false;
  if (before.substr(0, dot).ends_with(fmt::format(".{}", host_name()))) return has_ended(*process);
  std::error_code gone;
  const auto touched = fs::last_write_time(path, gone);
  return !gone && touched < fs::file_time_type::clock::now() - longest_task;
}

}  // namespace wold
