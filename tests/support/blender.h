#pragma once

#include <cstdlib>
#include <string>

namespace wold::test {

/// Blender, or a Python with the package bpy: $WOLD_BLENDER, else `blender`.
inline std::string blender_program() {
  const char* chosen = std::getenv("WOLD_BLENDER");
  return chosen != nullptr && *chosen != '\0' ? chosen : "blender";
}

inline bool succeeds(const std::string& command) {
  return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

inline bool is_python(const std::string& program) {
  return succeeds("'" + program + "' --version | grep -q ^Python");
}

inline bool has_blender() { return succeeds("'" + blender_program() + "' --version"); }

/// The command that runs a Python script in Blender without a window; arguments of the script's own
/// follow a "--". It fails when the script does.
inline std::string blender_script(const std::string& script) {
  const std::string program = "'" + blender_program() + "'";
  return is_python(blender_program())
             ? program + " -B '" + script + "'"
             : program + " -b --factory-startup --python-exit-code 1 -P '" + script + "'";
}

/// The command that renders a frame of an exported folder.
inline std::string blender_render(const std::string& folder, int frame) {
  return blender_script(WOLD_TEMPLATES_DIR "/blender/wold_render.py") + " -- '" + folder +
         "' " + std::to_string(frame);
}

}  // namespace wold::test
