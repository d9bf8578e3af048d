#include "work/blurred_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/colour.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "core/interrupt.h"
#include "shutter/motion_blur.h"
#include "shutter/motion_field.h"
#include "work/frame_choice.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

void require_passes(const fs::path& out, const std::vector<int>& frames) {
  std::vector<int> missing = frames;
  std::erase_if(missing, [&](int frame) {
    std::error_code unreachable;
    return fs::exists(passes_path(out, frame), unreachable);
  });
  if (missing.empty()) return;
  throw FileError(fmt::format(
      "found no {}, expected passes for the blur of frames {}; `wold passes {} --passes "
      "depth,motion --out {}` makes them",
      passes_path(out, missing.front()).string(), ranges_text(missing),
      (out / "scene.toml").string(), out.string()));
}

void require_sizes(const fs::path& out, const FramePictures& pictures,
                   const std::vector<int>& frames) {
  for (const int frame : frames) {
    const fs::path passes = passes_path(out, frame);
    const ImageHeader got = read_image_header(passes);
    const ImageHeader want = read_image_header(pictures.by_frame.at(frame));
    if (got.width != want.width || got.height != want.height)
      throw FileError(fmt::format(
          "{} has {} x {} pixels, expected {} x {} as in its picture; `wold passes` with the "
          "picture's --size makes it anew",
          passes.string(), got.width, got.height, want.width, want.height));
  }
}

void apply(double (*curve)(double), Image& picture) {
  for (float& value : picture.values) value = static_cast<float>(curve(double{value}));
}

/// Light adds up where it is linear; pictures are sRGB.
Image blurred(Image picture, const fs::path& passes, double shutter) {
  const shutter::MotionField field = shutter::read_motion_field(passes);
  apply(srgb_decoded, picture);
  Image blurred = shutter::motion_blurred(picture, field, shutter);
  apply(srgb_encoded, blurred);
  return blurred;
}

}  // namespace

BlurredPictures::BlurredPictures(const fs::path& out, const FramePictures& pictures,
                                 const std::vector<int>& frames, double shutter, Progress& progress)
    : folder_(pictures.folder) {
  require_passes(out, frames);
  require_sizes(out, pictures, frames);
  make_folder(folder());
  progress.begin("motion blur", frames.size());
  for (const int frame : frames) {
    if (interrupted()) throw InterruptedError();
    const fs::path& picture = pictures.by_frame.at(frame);
    write_image(folder() / picture.filename(),
                blurred(read_image(picture), passes_path(out, frame), shutter), PixelFormat::uint8);
    progress.advance(1, picture.filename().string());
  }
  progress.end();
}

}  // namespace wold::work
