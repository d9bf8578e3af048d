#include <fmt/format.h>

#include "cli/commands.h"
#include "console/output.h"

namespace wold::cli {
namespace {

void check(const work::EncodingOptions& options) {
  if (!options.film.empty() && options.film.extension() != ".mp4")
    throw InputError(fmt::format("--out: found {}, expected a file name that ends in .mp4",
                                 options.film.string()));
}

/// Films of few frames are over before one has looked.
void warn_if_short(const work::EncodedFilm& film) {
  constexpr double shortest_s = 1.0;
  const double duration_s = film.frames / film.frames_per_second;
  if (duration_s >= shortest_s || film.file.extension() != ".mp4") return;
  console::print_message(fmt::format(
      "warning: {} lasts {:.2g} s: {} frames at {:.4g} a second; --fps 2 shows each for half a "
      "second",
      film.file.string(), duration_s, film.frames, film.frames_per_second));
}

}  // namespace

ExitCode run_film(const work::EncodingOptions& options, Progress& progress) {
  check(options);
  const auto print = [&options](const work::EncodedFilm& film) {
    console::print_data(film.file.string() + "\n");
    if (!options.frames_per_second) warn_if_short(film);
  };
  work::encode_films(options, print, progress);
  return ExitCode::done;
}

}  // namespace wold::cli
