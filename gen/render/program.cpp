#include "render/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>

#include "core/error.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

fs::path on_path(const std::string& program) {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders == nullptr ? "" : folders);
  for (std::string folder; std::getline(list, folder, ':');)
    if (const fs::path candidate = fs::path(folder) / program; is_program(candidate))
      return fs::absolute(candidate);
  return {};
}

}  // namespace

fs::path find_program(const ExternalProgram& known) {
  if (const char* chosen = std::getenv(known.variable); chosen != nullptr && *chosen != '\0') {
    if (is_program(chosen)) return fs::absolute(chosen);
    throw RendererError(
        fmt::format("{} is missing: {} names {}, which is no program; correct it, or unset it and "
                    "install {} with `apt-get install {}`",
                    known.display_name, known.variable, chosen, known.display_name, known.name));
  }
  if (fs::path found = on_path(known.name); !found.empty()) return found;
  throw RendererError(fmt::format(
      "{} is missing: no `{}` on the PATH; install it with `apt-get install {}` or set {}",
      known.display_name, known.name, known.name, known.variable));
}

}  // namespace wold::render
