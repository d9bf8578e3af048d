#pragma once

#include <filesystem>

namespace wold::povray {

/// Expects the include files and cells.txt of a frame, in data/ below the exported `folder`, to be
/// as export_frame() writes them: numbers, names that it gives, and strings that name nothing
/// elsewhere. POV-Ray would run whatever else stands in them, and a folder may come from a stranger
/// who edited its files and the records of them alike. Reads all that the scene program can
/// include: the frame's folder, those that frames share, and what the frame names of
/// data/. Throws FileError, which names file and line.
void require_data_only(const std::filesystem::path& folder, int frame);

}  // namespace wold::povray
