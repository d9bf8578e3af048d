#include "core/temporary_name.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>

namespace wold {
namespace fs = std::filesystem;

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

fs::path temporary_name(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}.{}.tmp{}", path.stem().string(), host_name(),
                                          ::getpid(), path.extension().string());
}

bool is_temporary_name(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with('.') &&
         (name.ends_with(".tmp") || path.stem().string().ends_with(".tmp"));
}

}  // namespace wold
