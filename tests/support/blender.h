#pragma once

#include <filesystem>
#include <string>

namespace wold::test {

/// Whether a shell command ends with exit code 0; what it says is not shown.
bool succeeds(const std::string& command);

/// Whether there is a Blender, or a Python with the package bpy: $WOLD_BLENDER, else `blender`.
bool has_blender();

/// Whether it should show volumes, as grass is drawn by: Debian's Blender does not from 5.0 on. An
/// older one that says so is at fault.
bool shows_volumes();

/// The command that runs a Python script in Blender without a window; arguments of the script's own
/// follow a "--". It fails when the script does.
std::string blender_script(const std::filesystem::path& script);

/// The command that renders a frame (from 1) of an exported folder; its options may follow.
std::string blender_render(const std::filesystem::path& folder, int frame);

}  // namespace wold::test
