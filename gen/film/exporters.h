#pragma once

#include <vector>

#include "exporter/exporter.h"
#include "scene/scene.h"

namespace wold::film {

/// The table: every exporter there is, in the order of pictures, stages and options.
exporter::Exporters exporters();

/// Those that a scene asks for by render.renderer, in the table's order.
std::vector<const exporter::Exporter*> wanted_exporters(const scene::Scene& scene);

/// What a landscape has to be for these exporters. Limits are those of all exporters of the table:
/// which of them a scene asks for changes no picture.
landscape::Needs needs_of(exporter::Exporters wanted);

/// What exporters are told of the scene's film.
exporter::FilmSettings film_settings(const scene::Scene& scene);

}  // namespace wold::film
