#pragma once

#include <fmt/format.h>

#include "core/files.h"
#include "exporter/exporter.h"

namespace wold::test {

/// A third exporter, for which Wold runs no renderer: a frame is a line of text.
inline const exporter::Exporter& file_only_exporter() {
  static const exporter::Exporter lines = {
      .name = "lines",
      .display_name = "Lines",
      .export_frame =
          [](const landscape::Landscape& landscape, const exporter::FilmSettings& film,
             const std::filesystem::path& folder) -> std::vector<std::filesystem::path> {
        make_folder(folder);
        const auto file = folder / fmt::format("{:04}.txt", landscape.frame);
        write_file(file, fmt::format("{} of {}, {} cells\n", landscape.frame, film.frames.size(),
                                     landscape.cells.size()));
        return {file};
      },
      .export_film =
          [](const exporter::FilmSettings& film, const std::filesystem::path& folder) {
            make_folder(folder);
            update_file(folder / "film.txt", fmt::format("{} frames\n", film.frames.size()));
          },
      .files_for_output_folder = {"film.txt"},
      .needs = {.max_flakes_on_a_ray = 50.0, .materials = true},
      .files = {.frame = 20.0}};
  return lines;
}

}  // namespace wold::test
