#pragma once

#include "film/assemble.h"

namespace wold::test {

/// The looks of what does not grow.
inline film::PatchLookup no_grass() {
  return {.volume = [](const meadow::CellChoice&) { return landscape::Volume{}; },
          .blades = [](const meadow::CellChoice&) { return landscape::BladeMesh{}; },
          .far = [](int, const grass::PatchState&) { return meadow::PatchAppearance({}); }};
}

}  // namespace wold::test
