#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/progress.h"
#include "report/report_facts.h"

namespace wold::report {

/// One renderer's pictures in a page.
struct EmbeddedPictures {
  std::string renderer;                ///< its folder's name
  std::string display_name;            ///< for people
  std::vector<std::string> data_uris;  ///< one for each frame; empty: there is none
};

/// A film as a page shows it.
struct EmbeddedFilm {
  std::vector<int> frames;    ///< that are shown, rising
  glm::ivec2 size_px{16, 9};  ///< of the first picture, before it is shrunk
  std::vector<EmbeddedPictures> renderers;
  std::vector<std::string> warnings;  ///< pictures that are damaged, frames that are left out
};

/// Embeds the pictures, as large as lets all of them together stay below about 27 MB. Throws
/// InterruptedError from `progress`.
EmbeddedFilm embedded_film(const ReportFacts& facts, Progress& progress);

}  // namespace wold::report
