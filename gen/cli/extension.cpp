#include <fmt/format.h>

#include "cli/commands.h"
#include "console/output.h"
#include "core/file_list.h"
#include "core/files.h"
#include "core/version.h"
#include "core/zip_archive.h"

namespace wold::cli {
namespace fs = std::filesystem;
namespace {

constexpr const char* package = "wold_blender";
constexpr const char* launcher = "wold_render.py";

/// Blender's package in one folder of its name, which add-ons and extensions may have.
std::string packed() {
  const fs::path folder = shipped_file(fmt::format("templates/blender/{}", package));
  std::vector<ArchivedFile> files;
  for (const fs::path& file : programs_below(folder))
    files.push_back(
        {(package / file.lexically_relative(folder)).generic_string(), read_file(file)});
  return zip_archive(files);
}

std::string how_to_use(const fs::path& archive, const fs::path& script) {
  return fmt::format(
      "Blender 4.2 and newer: blender --command extension install-file -r user_default -e {0}\n"
      "  or Edit > Preferences > Get Extensions > Install from Disk\n"
      "Blender 3.4 to 4.1: Edit > Preferences > Add-ons > Install, then enable \"Wold landscape\"\n"
      "Without installing it, a frame of a folder that wold has written:\n"
      "  blender -b --factory-startup --python-exit-code 1 -P {1} -- out/NAME/blender 1 --out "
      "1.png\n"
      "  python {1} -- out/NAME/blender 1 --out 1.png     with the package bpy",
      archive.string(), script.string());
}

}  // namespace

ExitCode run_extension(const fs::path& out) {
  const fs::path archive = out / fmt::format("{}-{}.zip", package, version);
  const fs::path script = out / launcher;
  make_folder(out);
  update_file(archive, packed());
  update_file(script, read_file(shipped_file(fmt::format("templates/blender/{}", launcher))));
  console::print_data(fmt::format("{}\n{}\n", archive.string(), script.string()));
  console::print_message(how_to_use(archive, script));
  return ExitCode::done;
}

}  // namespace wold::cli
