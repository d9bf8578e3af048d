#pragma once

#include <filesystem>
#include <span>

#include "exporter/film_settings.h"

namespace wold::povray {

/// By which a scene of one's own finds a frame.
using exporter::FrameMoment;

/// Writes data/frames.inc below `folder`, `#declare Wold_frames = array[COUNT][3] { ... }`: number,
/// degree and time of the frames of a film, at least one. It lists frames that have not been made,
/// too: its bytes depend on the film alone, whoever writes it and when. Throws FileError.
void write_frame_index(std::span<const FrameMoment> film, const std::filesystem::path& folder);

}  // namespace wold::povray
