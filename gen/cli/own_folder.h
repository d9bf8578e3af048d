#pragma once

#include <filesystem>

namespace wold::cli {

/// Refuses an output folder in which a link leads out of it: through a stranger's folder nothing
/// elsewhere is to be written, removed or locked. Throws FileError that names the link and where it
/// leads.
void require_no_way_out(const std::filesystem::path& folder);

}  // namespace wold::cli
