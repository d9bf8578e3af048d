#pragma once

#include <vector>

#include "landscape/landscape.h"
#include "povray/frame_index.h"

namespace wold::test {

/// The index of a film that has no other frame than the landscape's.
inline std::vector<povray::FrameMoment> film_of(const landscape::Landscape& landscape) {
  return {{landscape.frame, landscape.weathering, landscape.time_s}};
}

}  // namespace wold::test
