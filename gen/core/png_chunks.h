#pragma once

#include <string>

namespace wold {

/// A PNG file without its ancillary chunks: the picture alone. What libraries say beside it, such
/// as empty lists of metadata, differs between their versions. Throws FileError for what is no PNG
/// file.
std::string without_ancillary_chunks(const std::string& png);

}  // namespace wold
