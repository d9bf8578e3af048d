#include "povray/probe.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "core/df3.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "render/short_run.h"

namespace wold::povray {
namespace fs = std::filesystem;
namespace {

constexpr int width_px = 16;
constexpr int height_px = 8;

constexpr std::string_view scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -2> right 4*x up 2*y look_at 0 }
#declare Box = box { <-0.6, -0.6, -0.6>, <0.6, 0.6, 0.6> hollow pigment { rgbt 1 } }
#declare Glow = media { emission 4 method 3 intervals 1 samples 4 }
#declare Voxel = density { density_file df3 "voxel.df3" translate -0.5 }
object { Box interior { media { Glow density { Voxel } } } translate -x }
object { Box interior { media { Glow } } translate x }
)";

/// A folder of its own that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "wold_probe_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw FileError(fmt::format("cannot make the folder {}: {}", pattern, std::strerror(errno)));
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::vector<std::string> command_line(const fs::path& program) {
  return {program.string(),
          "+Iprobe.pov",
          "+Oprobe.png",
          "+FN8",
          fmt::format("+W{}", width_px),
          fmt::format("+H{}", height_px),
          "-D",
          "-P"};
}

bool is_bright(const Image& image, int x, int y) {
  constexpr float min = 0.5F;
  return image.pixel(x, y)[0] > min;
}

}  // namespace

std::string_view probe_scene() { return scene; }

render::Capabilities probe(const render::RendererProgram& program,
                           const render::Interrupted& interrupted) {
  const TemporaryFolder folder;
  write_file(folder.path() / "probe.pov", scene);
  write_file(folder.path() / "voxel.df3", [](std::ostream& out) {
    write_df3(out, {1, 1, 1}, std::array{1.0F}, 1.0F, 8);
  });
  const render::Answer answer =
      render::ask(command_line(program.found.path), folder.path(), interrupted);
  const fs::path picture = folder.path() / "probe.png";
  if (!has_succeeded(answer) || !fs::exists(picture))
    throw RendererError(fmt::format(
        "{} does not make a picture of one voxel: {}; see `wold doctor`, or name another build by "
        "--povray{}",
        described(program), how_it_ended(answer), last_lines(answer)));
  const Image image = read_image(picture);
  const bool is_dark_between = !is_bright(image, width_px / 2, 0);
  render::Capabilities capabilities;
  capabilities.version = program.version;
  capabilities.volumes = is_dark_between && is_bright(image, width_px / 4, height_px / 2);
  capabilities.fog = is_dark_between && is_bright(image, 3 * width_px / 4, height_px / 2);
  capabilities.threads = static_cast<int>(std::thread::hardware_concurrency());
  return capabilities;
}

}  // namespace wold::povray
