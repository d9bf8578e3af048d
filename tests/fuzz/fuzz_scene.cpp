#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "scene/parse.h"
#include "scene/write.h"

/// Any text is a scene or an InputError; a scene survives being written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const std::string_view text(reinterpret_cast<const char*>(bytes), count);
  try {
    const scene::Scene scene = scene::parse_scene(text, "fuzz.toml");
    const std::string written = scene::resolved_toml(scene);
    if (scene::resolved_toml(scene::parse_scene(written, "fuzz.toml")) != written) std::abort();
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}
