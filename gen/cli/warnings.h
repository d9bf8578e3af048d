#pragma once

#include <span>

#include "core/error.h"
#include "phenology/film_season.h"

namespace wold::cli {

/// Says on stderr what advice::scene_warnings() has to say about a film and its season.
void print_warnings(const scene::Scene& film, const phenology::FilmSeason* season);

/// Says on stderr what scene::read_located_scene() has to say about a scene's text.
void print_warnings(std::span<const Problem> warnings);

}  // namespace wold::cli
