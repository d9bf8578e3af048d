#pragma once

#include <string>

namespace wold::work {

/// Hash of the program and the models and templates that came with it: files that two builds of
/// the same hash make of a scene are the same. Throws FileError.
std::string hash_of_build();

}  // namespace wold::work
