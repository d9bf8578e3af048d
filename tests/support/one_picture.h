#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "blender/export.h"
#include "core/files.h"
#include "core/image.h"
#include "povray/export.h"
#include "support/blender.h"
#include "support/povray_film.h"

/// One landscape's picture from both renderers.
namespace wold::test {

/// Runs a command in a folder and reads the picture.png that it makes there.
inline Image run(const std::string& command, const std::filesystem::path& folder) {
  if (std::system(fmt::format("cd '{}' && {} > log 2>&1", folder.string(), command).c_str()) != 0)
    ADD_FAILURE() << read_file(folder / "log");
  return read_image(folder / "picture.png");
}

/// A landscape as Blender shows it.
inline Image blender_picture(const landscape::Landscape& landscape,
                             const std::filesystem::path& folder) {
  blender::export_frame(landscape, folder);
  return run(blender_render(folder, 1) + " --out picture.png", folder);
}

/// A landscape as POV-Ray shows it, not dithered: tests read single pixels.
inline Image povray_picture(const landscape::Landscape& landscape,
                            const std::filesystem::path& folder) {
  povray::export_frame(landscape, folder);
  povray::export_scene(film_of(landscape), folder);
  return run("povray data/frame_0001.ini +Opicture.png Dither=Off", folder);
}

/// Says so where a renderer is missing.
class OnePicture : public testing::Test {
 protected:
  void SetUp() override {
    if (!shows_volumes() || !succeeds("povray --version"))
      GTEST_SKIP()
          << "no Blender that shows volumes or no POV-Ray on this machine: the pictures are "
             "not compared";
  }
};

}  // namespace wold::test
