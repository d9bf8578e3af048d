#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace wold::phenology {
class FilmSeason;
}

namespace wold::advice {

/// What will look wrong in a film's pictures, one sentence for each: what, and which key to change
/// to what. Worked out in a moment, from the scene, its tables and the elevation model's header:
/// the ground is taken for the plane under eye and target. `film` is phenology::as_film()'s with
/// `season`. Throws InputError or FileError when the season's table or the elevation model cannot
/// be read.
std::vector<std::string> scene_warnings(const scene::Scene& film,
                                        const phenology::FilmSeason* season);

/// Those that are about grass.
std::vector<std::string> grass_warnings(const scene::Scene& film);

/// Those that are about its season: [[season_keys]] that do other than it seems.
std::vector<std::string> season_warnings(const scene::Scene& film);

/// Those that are about keys that were given and change nothing.
std::vector<std::string> unused_key_warnings(const scene::Scene& film);

}  // namespace wold::advice
