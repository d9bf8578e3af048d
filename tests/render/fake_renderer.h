#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "blender/renderer.h"
#include "core/files.h"
#include "core/image.h"
#include "render/run.h"

namespace wold::test {

namespace fs = std::filesystem;

/// A folder of its own for every test, with a shell script that plays the renderer.
class FakeRenderer : public ::testing::Test {
 protected:
  FakeRenderer() {
    std::string pattern = (fs::temp_directory_path() / "wold render XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    make_folder(folder_ / "scene");
    write_image(folder_ / "good.png", gradient(32, 18), PixelFormat::uint8);
  }
  ~FakeRenderer() override { fs::remove_all(folder_); }

  static Image gradient(int width, int height) {
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = static_cast<float>(i) / static_cast<float>(image.values.size());
    return image;
  }

  /// Writes a shell script that may be run.
  fs::path write_program(const std::string& name, const std::string& text) const {
    write_file(folder_ / name, text);
    fs::permissions(folder_ / name, fs::perms::owner_all);
    return folder_ / name;
  }

  /// Writes a script that is run as Blender; in it, $out is the wanted picture and $folder the
  /// test's folder.
  void play(const std::string& body) {
    write_program("fake.sh",
                  "#!/bin/sh\nfolder='" + folder_.string() +
                      "'\nwhile [ $# -gt 0 ]; do [ \"$1\" = --out ] && out=$2; shift; done\n" +
                      body + "\n");
  }

  /// The script of play(), which is not asked what it is.
  render::RendererProgram fake_program() const {
    return {&blender::renderer(),
            render::ProgramForm::itself,
            {folder_ / "fake.sh", "PATH"},
            "9.9.9",
            "",
            "",
            folder_ / "launcher.py"};
  }

  render::Job job() const {
    return {fake_program(),
            folder_ / "scene",
            3,
            {32, 18},
            4,
            "cpu",
            1,
            0.0,
            std::chrono::seconds(20),
            folder_ / "out/0003.png",
            folder_ / "logs/3.log"};
  }

  /// Runs a job that has to fail and returns what it says; checks that no picture is left.
  template <class Failure>
  std::string failure_of(const render::Job& job, const std::function<bool()>& interrupted = never) {
    std::string message = "nothing was thrown";
    SilentProgress progress;
    EXPECT_THROW(
        try { render::run(job, progress, interrupted); } catch (const Failure& error) {
          message = error.what();
          throw;
        },
        Failure);
    std::error_code ignored;
    const fs::path pictures = job.picture.parent_path();
    EXPECT_TRUE(!fs::is_directory(pictures, ignored) || fs::is_empty(pictures)) << message;
    return message;
  }

  static bool never() { return false; }

  fs::path folder_;
};

}  // namespace wold::test
