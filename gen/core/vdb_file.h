#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "core/vdb.h"

namespace wold {

/// Writes grids and file metadata (active values only), whole or not at all. The random id that
/// OpenVDB puts into every header is overwritten by one made from the content, so the same grids
/// give the same bytes. Throws FileError.
void write_vdb(const std::filesystem::path& path, const openvdb::GridPtrVec& grids,
               const openvdb::MetaMap& metadata = {});

/// Reads every grid of a file. Throws FileError when it is missing or damaged.
openvdb::GridPtrVecPtr read_vdb(const std::filesystem::path& path);

/// Reads one grid by name. Throws FileError that lists the grids there are when it is absent.
openvdb::GridBase::Ptr read_vdb_grid(const std::filesystem::path& path, const std::string& name);

/// The same of a grid whose type is known. Throws FileError where it has another one, too.
template <class Grid>
typename Grid::Ptr read_vdb_grid_as(const std::filesystem::path& path, const std::string& name) {
  auto grid = openvdb::gridPtrCast<Grid>(read_vdb_grid(path, name));
  if (!grid) throw FileError(path.string() + ": grid \"" + name + "\" has an unexpected type");
  return grid;
}

/// Reads the file's metadata alone.
openvdb::MetaMap::Ptr read_vdb_metadata(const std::filesystem::path& path);

}  // namespace wold
