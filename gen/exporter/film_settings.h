#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace wold::exporter {

/// By which people find a frame of a film.
struct FrameMoment {
  int frame = 1;            ///< from 1
  double weathering = 0.0;  ///< mean weathering degree, 0 to 1
  double time_s = 0.0;      ///< since the film's first frame
};

/// What an exporter is told of a film beside its landscapes.
struct FilmSettings {
  std::vector<FrameMoment> frames;  ///< all of the film, whether they are made or not
  glm::ivec2 size_px{0};            ///< of a picture
  int samples = 1;                  ///< per pixel
  int density_bits = 8;  ///< depth of density files where an exporter has a choice: 8, 16
};

}  // namespace wold::exporter
