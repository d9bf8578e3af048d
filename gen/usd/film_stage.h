#pragma once

#include <filesystem>
#include <span>

#include "exporter/film_settings.h"

namespace wold::usd {

/// Writes scene.usda below `folder`: a stage that plays the film. Each frame's layer is a payload
/// that is seen at its own time code, which is the frame's number. A camera goes through the film
/// by value clips. It lists frames that have not been made, too: its bytes depend on the film
/// alone, whoever writes it and when. Throws FileError.
void write_film_stage(std::span<const exporter::FrameMoment> film,
                      const std::filesystem::path& folder);

}  // namespace wold::usd
