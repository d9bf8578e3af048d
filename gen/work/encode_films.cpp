#include "work/encode_films.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/image.h"
#include "core/interrupt.h"
#include "render/encode.h"
#include "work/blurred_pictures.h"
#include "work/folder_format.h"
#include "work/frame_pictures.h"
#include "work/job.h"
#include "work/own_folder.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

/// Those of the renderer that was asked for, or all.
std::vector<FramePictures> wanted_pictures(const EncodingOptions& options,
                                           std::vector<FramePictures> all) {
  if (!options.renderer.empty())
    std::erase_if(all, [&](const FramePictures& one) { return one.renderer != options.renderer; });
  if (all.empty())
    throw FileError(fmt::format("no pictures in {}; `wold render` makes them",
                                (options.out / "frames" / options.renderer).string()));
  return all;
}

/// Without gaps: what is asked for, or all that there should be.
std::vector<int> frames_to_encode(const EncodingOptions& options,
                                  const std::vector<FramePictures>& all) {
  if (options.frames == FrameChoice()) return expected_frames(options.out, all);
  std::vector<int> frames = options.frames.numbers;
  if (!options.frames.shots.empty()) frames = frames_of_shots(options.out, options.frames.shots);
  if (frames.back() - frames.front() + 1 != static_cast<int>(frames.size()))
    throw InputError(fmt::format("{}: found {}, expected frames without gaps, such as {}-{}",
                                 options.frames.shots.empty() ? "--frames" : "--shot",
                                 ranges_text(frames), frames.front(), frames.back()));
  return frames;
}

FileError incomplete(const EncodingOptions& options, const std::vector<FramePictures>& all,
                     const std::vector<int>& frames) {
  std::string text = fmt::format("frames are missing in {}:", (options.out / "frames").string());
  for (const FramePictures& one : all)
    text += fmt::format(" {}'s {};", display_name(one), ranges_text(missing_frames(one, frames)));
  return FileError(text + " `wold render` makes them, --frames 1-9 takes some of them");
}

/// The size that all pictures have.
glm::ivec2 common_size(const FramePictures& pictures, const std::vector<int>& frames) {
  std::optional<glm::ivec2> common;
  for (const int frame : frames) {
    const fs::path& picture = pictures.by_frame.at(frame);
    const ImageHeader header = read_image_header(picture);
    const glm::ivec2 size(header.width, header.height);
    if (common && size != *common)
      throw FileError(
          fmt::format("{} has {} x {} pixels, expected {} x {} as in frame {}; `wold "
                      "render` makes all frames of one size",
                      picture.string(), size.x, size.y, common->x, common->y, frames.front()));
    common = size;
  }
  return common.value();
}

void write_films(const EncodingOptions& options, const FramePictures& pictures,
                 const std::vector<int>& frames, const fs::path& film, const FilmMade& made,
                 Progress& progress) {
  render::Encoding encoding;
  encoding.pictures = pictures.folder;
  encoding.first = frames.front();
  encoding.count = static_cast<int>(frames.size());
  encoding.size_px = common_size(pictures, frames);
  const scene::FilmTiming timing = film_timing(options.out);
  encoding.frames_per_second = options.frames_per_second.value_or(timing.frames_per_second);
  // Far more than any machine needs; it is there for an FFmpeg that hangs.
  encoding.timeout = std::chrono::seconds(60 + 20 * encoding.count);
  render::find_ffmpeg();  // which is not to be missing after all the work
  std::optional<BlurredPictures> blurred;
  if (const double shutter = options.shutter.value_or(timing.shutter); shutter > 0.0) {
    blurred.emplace(options.out, pictures, frames, shutter, progress);
    encoding.pictures = blurred->folder();
  }
  for (const char* extension : {".mp4", ".webp"}) {
    encoding.film = fs::path(film).replace_extension(extension);
    encoding.log =
        options.out / "logs" / fmt::format("film_{}_{}.log", pictures.renderer, extension + 1);
    render::encode(encoding, progress, interrupted);
    made({encoding.film, encoding.count, encoding.frames_per_second});
  }
}

}  // namespace

void encode_films(const EncodingOptions& options, const FilmMade& made, Progress& progress) {
  require_no_way_out(options.out);
  require_known_format(options.out);
  const std::vector<FramePictures> all = frame_pictures(options.out);
  const std::vector<int> frames = frames_to_encode(options, all);
  const std::vector<FramePictures> wanted = wanted_pictures(options, all);
  std::vector<FramePictures> complete = wanted;
  std::erase_if(complete, [&](const FramePictures& one) {
    return frames.empty() || !missing_frames(one, frames).empty();
  });
  if (complete.empty()) throw incomplete(options, wanted, frames);
  for (const FramePictures& pictures : complete) {
    const fs::path film = options.film.empty()
                              ? options.out / fmt::format("film_{}.mp4", pictures.renderer)
                              : options.film;
    write_films(options, pictures, frames, film, made, progress);
    if (!options.film.empty()) break;
  }
}

}  // namespace wold::work
