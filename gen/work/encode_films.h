#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "work/frame_choice.h"

namespace wold::work {

/// Which pictures of an output folder become films.
struct EncodingOptions {
  std::filesystem::path out;   ///< the output folder with the frames
  std::filesystem::path film;  ///< .mp4; empty: out/film_<renderer>.mp4 for each renderer
  std::string renderer;        ///< "blender" or "povray"; empty: those that have all frames
  FrameChoice frames;          ///< without gaps
  std::optional<double> frames_per_second;  ///< more than 0; none: what the folder's scene says
  /// Share of the time between frames in which the shutter is open, in [0, 1]; 0 leaves pictures
  /// sharp, none: film.shutter of the folder's scene.
  std::optional<double> shutter;
};

/// A film that is there.
struct EncodedFilm {
  std::filesystem::path file;
  int frames = 0;  ///< at least 1
  double frames_per_second = 0.0;
};

/// Is given each film once it is there.
using FilmMade = std::function<void(const EncodedFilm& film)>;

/// Encodes the pictures of an output folder as films, .mp4 and a .webp that loops beside it, for
/// each renderer that has all frames; under a name of its own for the first of them alone, of which
/// Blender is asked before POV-Ray. Throws FileError where pictures are missing or differ in size,
/// and what BlurredPictures and render::encode() do.
void encode_films(const EncodingOptions& options, const FilmMade& made, Progress& progress);

}  // namespace wold::work
