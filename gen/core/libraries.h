#pragma once

#include <string>
#include <vector>

namespace wold {

/// A library that this program runs with.
struct LibraryVersion {
  std::string name;     ///< as its makers write it: "OpenVDB"
  std::string version;  ///< "10.0.1"
};

/// The libraries that read, write or compute what is in files. The versions are those of the
/// libraries that are loaded; of OpenVDB and fmt, whose names say their versions, those the program
/// was built with.
std::vector<LibraryVersion> library_versions();

}  // namespace wold
