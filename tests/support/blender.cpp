#include "support/blender.h"

#include <fmt/format.h>

#include <cstdlib>

#include "support/places.h"

namespace wold::test {
namespace {

std::filesystem::path launcher() { return templates_folder() / "blender/wold_render.py"; }

std::string program() {
  const char* chosen = std::getenv("WOLD_BLENDER");
  return chosen != nullptr && *chosen != '\0' ? chosen : "blender";
}

bool is_python() { return succeeds(fmt::format("'{}' --version | grep -q ^Python", program())); }

}  // namespace

bool succeeds(const std::string& command) {
  return std::system(fmt::format("({}) > /dev/null 2>&1", command).c_str()) == 0;
}

bool has_blender() { return succeeds(fmt::format("'{}' --version", program())); }

bool shows_volumes() {
  static const bool lacks_them =
      succeeds(blender_script(launcher()) +
               R"( -- --probe | grep -q '"version": "[5-9][.].*"volumes": false')");
  return has_blender() && !lacks_them;
}

std::string blender_script(const std::filesystem::path& script) {
  const char* options = is_python() ? "-B" : "-b --factory-startup --python-exit-code 1 -P";
  return fmt::format("'{}' {} '{}'", program(), options, script.string());
}

std::string blender_render(const std::filesystem::path& folder, int frame) {
  return fmt::format("{} -- '{}' {}", blender_script(launcher()), folder.string(), frame);
}

}  // namespace wold::test
