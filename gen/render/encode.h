#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>

#include "core/progress.h"
#include "render/program.h"

namespace wold::render {

/// A film to make from numbered pictures.
struct Encoding {
  std::filesystem::path pictures;  ///< folder of 0001.png, 0002.png, ...
  int first = 1;                   ///< number of the first
  int count = 1;                   ///< all numbers from `first` on have to be there
  glm::ivec2 size_px{0};           ///< of every picture
  double frames_per_second = 24.0;
  std::chrono::seconds timeout{0};  ///< longer than 0
  std::filesystem::path film;       ///< ends in .mp4 or .webp
  std::filesystem::path log;        ///< FFmpeg's own words, kept in any case
};

/// FFmpeg: $WOLD_FFMPEG or `ffmpeg` on the PATH. Throws RendererError when there is none.
FoundProgram find_ffmpeg();

/// Encodes a film with FFmpeg ($WOLD_FFMPEG or `ffmpeg` on the PATH). An .mp4 is H.264 that every
/// player knows: yuv420p by BT.709, what is odd of its size filled up with the pictures' edge, its
/// index at the front. A .webp runs in a loop and is at most 640 pixels wide. The same pictures
/// give the same bytes with the same FFmpeg. The film appears whole or not at all.
///
/// Throws RendererError (FFmpeg is missing, failed or took too long; it names the log and its last
/// lines), FileError and InterruptedError, for which `interrupted` is asked several times a second.
void encode(const Encoding& encoding, Progress& progress, const std::function<bool()>& interrupted);

}  // namespace wold::render
