#pragma once

#include <filesystem>
#include <vector>

#include "film/exporters.h"

namespace wold::test {

/// Writes a landscape, and what a film has once that has no other frame, into a folder. Returns the
/// frame's files.
inline std::vector<std::filesystem::path> export_all(const exporter::Exporter& exporter,
                                                     const landscape::Landscape& landscape,
                                                     const std::filesystem::path& folder) {
  const exporter::FilmSettings film = {
      .frames = {{landscape.frame, landscape.weathering, landscape.time_s}},
      .size_px = {landscape.width_px, landscape.height_px},
      .samples = landscape.samples};
  auto files = exporter.export_frame(landscape, film, folder);
  if (exporter.export_film) exporter.export_film(film, folder);
  return files;
}

/// Those of the table whose files Wold makes pictures of.
inline std::vector<const exporter::Exporter*> exporters_with_a_renderer() {
  std::vector<const exporter::Exporter*> some;
  for (const exporter::Exporter* one : film::exporters())
    if (one->renderer) some.push_back(one);
  return some;
}

}  // namespace wold::test
