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

}  // namespace

ExitCode run_film(const work::EncodingOptions& options, Progress& progress) {
  check(options);
  const auto print = [](const std::filesystem::path& film) {
    console::print_data(film.string() + "\n");
  };
  work::encode_films(options, print, progress);
  return ExitCode::done;
}

}  // namespace wold::cli
