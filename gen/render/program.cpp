#include "render/program.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/error.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

bool is_program(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0;
}

std::vector<fs::path> folders_of_path() {
  const char* folders = std::getenv("PATH");
  std::istringstream list(folders == nullptr ? "" : folders);
  std::vector<fs::path> paths;
  for (std::string folder; std::getline(list, folder, ':');) paths.emplace_back(folder);
  return paths;
}

/// Empty when there is none.
fs::path on_path(const std::string& name) {
  for (const fs::path& folder : folders_of_path())
    if (const fs::path candidate = folder / name; is_program(candidate))
      return fs::absolute(candidate);
  return {};
}

/// Empty when there is none.
fs::path named(const std::string& program) {
  if (program.find('/') == std::string::npos) return on_path(program);
  return is_program(program) ? fs::absolute(program) : fs::path();
}

FoundProgram find_named(const ExternalProgram& known, const std::string& program,
                        const std::string& chosen_by) {
  if (fs::path found = named(program); !found.empty()) return {std::move(found), chosen_by};
  throw RendererError(fmt::format(
      "{0} is missing: {1} names {2}, which is no program; correct it, or leave {1} out and "
      "install {0} with `apt-get install {3}`",
      known.display_name, chosen_by, program, known.name));
}

}  // namespace

FoundProgram find_program(const ExternalProgram& known, const std::string& chosen) {
  if (!chosen.empty()) return find_named(known, chosen, known.option);
  if (const char* variable = std::getenv(known.variable); variable != nullptr && *variable != '\0')
    return find_named(known, variable, known.variable);
  if (fs::path found = on_path(known.name); !found.empty()) return {std::move(found), "PATH"};
  throw RendererError(fmt::format(
      "{} is missing: no `{}` on the PATH; install it with `apt-get install {}` or set {}",
      known.display_name, known.name, known.name, known.variable));
}

std::vector<fs::path> programs_on_path(std::string_view prefix) {
  std::vector<fs::path> programs;
  for (const fs::path& folder : folders_of_path()) {
    std::vector<fs::path> here;
    std::error_code unreadable;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, unreadable))
      if (entry.path().filename().string().starts_with(prefix) && is_program(entry.path()))
        here.push_back(fs::absolute(entry.path()));
    std::sort(here.begin(), here.end());
    programs.insert(programs.end(), here.begin(), here.end());
  }
  return programs;
}

}  // namespace wold::render
