#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "exporter/exporter.h"
#include "passes/pass.h"
#include "phenology/film_season.h"
#include "scene/scene.h"

namespace wold::film {

/// Which pictures' files are to be made, and where.
struct Request {
  scene::Scene scene;                                ///< a checked one, after phenology::as_film()
  std::vector<int> frames;                           ///< from 1, rising, all within the scene
  std::filesystem::path out;                         ///< the output folder
  std::vector<const exporter::Exporter*> exporters;  ///< who writes scene files: wanted_exporters()
  std::vector<passes::Pass> passes = {};             ///< to be made beside the pictures
  /// phenology::film_season() of the scene, nullptr where that is none.
  std::shared_ptr<const phenology::FilmSeason> season = {};
};

/// Whether anybody reads texels without light: exporters that need materials, and passes.
bool reads_unlit_texels(const Request& request);

}  // namespace wold::film
