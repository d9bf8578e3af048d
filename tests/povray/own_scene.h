#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/files.h"
#include "core/image.h"
#include "povray/export.h"
#include "support/povray_film.h"
#include "support/temporary_folder.h"

namespace wold::povray {

/// Scenes of one's own that include wold.inc, run by POV-Ray beside an exported landscape.
class OwnScene : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v povray > /dev/null") != 0)
      GTEST_SKIP() << "povray is not installed: apt-get install povray";
  }

  /// Runs POV-Ray on `scene` in a folder beside the landscape's.
  Image run(const landscape::Landscape& landscape, const std::filesystem::path& scene) const {
    const std::filesystem::path here = folder.path() / "mine";
    make_folder(here);
    const std::string command =
        fmt::format("cd {} && povray +L../povray {} +W{} +H{} -A -D +Opicture.png > log 2>&1",
                    here.string(), scene.string(), landscape.width_px, landscape.height_px);
    if (std::system(command.c_str()) != 0) ADD_FAILURE() << read_file(here / "log");
    return read_image(here / "picture.png");
  }
  /// Runs a scene of version 3.7 that goes on with `text` after wold.inc and its settings.
  Image run_text(const landscape::Landscape& landscape, const std::string& text) const {
    return run_whole(landscape,
                     "#version 3.7;\n#include \"wold.inc\"\n"
                     "global_settings { Wold_Settings(0) }\n" +
                         text);
  }
  Image run_whole(const landscape::Landscape& landscape, const std::string& text) const {
    write_file(folder.path() / "my.pov", text);
    return run(landscape, folder.path() / "my.pov");
  }
  void export_all(const landscape::Landscape& landscape) const {
    export_frame(landscape, folder.path() / "povray");
    export_scene(test::film_of(landscape), folder.path() / "povray");
  }

  const test::TemporaryFolder folder{"own_scene"};
};

}  // namespace wold::povray
