#include "core/vdb_file.h"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/io/GridDescriptor.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>

#include "core/error.h"
#include "core/files.h"

namespace wold {
namespace fs = std::filesystem;
namespace {

// Header of a .vdb file (openvdb/io/Archive.cc): magic (8 bytes), format version (4), library
// major and minor (4 + 4), "has grid offsets" (1), then the id as 36 characters of text.
constexpr std::size_t versions_offset = 8;
constexpr std::size_t id_offset = versions_offset + 4 + 4 + 4 + 1;
constexpr std::size_t id_length = 36;

using Versions = std::array<std::uint32_t, 3>;  ///< of the format; of the library, major and minor

/// The oldest library that writes these bytes, whichever does. Format 225 (OpenVDB 13) differs from
/// 224 in grids of half floats alone, which are not written here.
constexpr Versions oldest_writer = {224, 10, 0};
constexpr std::uint32_t last_like_oldest = 225;

/// An id of the usual 8-4-4-4-12 form from the content's hash.
std::string content_id(std::string_view bytes) {
  const std::string a = content_hash(bytes);
  const std::string b = content_hash(a);
  return fmt::format("{}-{}-{}-{}-{}", a.substr(0, 8), a.substr(8, 4), a.substr(12, 4),
                     b.substr(0, 4), b.substr(4, 12));
}

/// The same header from every version of the library: its own version, and the random id, which is
/// replaced by one made from everything else in the file.
void overwrite_header(const fs::path& path) {
  std::string bytes = read_file(path);
  if (bytes.size() < id_offset + id_length) throw FileError("file is too short");
  Versions versions{};
  std::memcpy(versions.data(), &bytes[versions_offset], sizeof versions);
  if (versions[0] >= oldest_writer[0] && versions[0] <= last_like_oldest)
    std::memcpy(&bytes[versions_offset], oldest_writer.data(), sizeof versions);
  std::fill_n(bytes.begin() + id_offset, id_length, '0');
  bytes.replace(id_offset, id_length, content_id(bytes));
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.write(bytes.data(), id_offset + id_length);
  file.flush();
  if (!file) throw FileError("cannot write the header");
}

/// Passes over parts of a file whose lengths stand before them, as openvdb::MetaMap and
/// openvdb::io::GridDescriptor read them: OpenVDB takes the memory for what a damaged length says
/// before it finds that nothing is there.
class Passing {
 public:
  explicit Passing(std::istream& in)
      : in_(in), begin_(in.tellg()), end_(in.seekg(0, std::ios::end).tellg()) {
    in.seekg(begin_);
  }
  /// Back to where it began.
  void end() { in_.seekg(begin_); }

  void text() { in_.seekg(length(), std::ios::cur); }
  void texts(int count) {
    for (int i = 0; i < count; ++i) text();
  }
  /// Name, type and value of each.
  void metadata() {
    for (auto left = number(); left > 0; --left) {
      text();
      value_of(word());
    }
  }
  std::streamoff number() {
    std::uint32_t value = 0;
    in_.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }

 private:
  /// Of what follows.
  std::streamoff length() {
    const auto bytes = number();
    if (bytes > end_ - in_.tellg()) throw std::runtime_error("it ends too early");
    return bytes;
  }
  std::string word() {
    std::string text(static_cast<std::size_t>(length()), ' ');
    in_.read(text.data(), static_cast<std::streamsize>(text.size()));
    return text;
  }
  /// Whatever length stands before it, OpenVDB reads a value of a type of one size as that.
  void value_of(const std::string& type) {
    const auto bytes = length();
    if (openvdb::Metadata::isRegisteredType(type))
      if (const auto of_type = std::streamoff{openvdb::Metadata::createMetadata(type)->size()};
          of_type > 0 && bytes != of_type)
        throw std::runtime_error(
            fmt::format("found {} bytes of a value of type {}, expected {}", bytes, type, of_type));
    in_.seekg(bytes, std::ios::cur);
  }

  std::istream& in_;
  std::streampos begin_, end_;
};

/// Reads a file from a stream that throws at its end. OpenVDB 10 does not look at the stream, so a
/// damaged length or count makes it work for hours on what is not there. Its own reader of streams
/// looks for a grid where it lost the one before: here each begins where the list of grids has it.
class Reader : public openvdb::io::Archive {
 public:
  /// Whether all grids are there. Throws what the stream does, and std::runtime_error.
  void check(const fs::path& path) {
    each_grid(path, [](const Grid&) {});
  }
  /// What is said of the file as a whole.
  openvdb::MetaMap::Ptr metadata(const fs::path& path) {
    check(path);
    return metadata_;
  }
  /// The first grid of that name, whole. Throws FileError, which names those that are there, when
  /// there is none.
  openvdb::GridBase::Ptr grid(const fs::path& path, const std::string& name) {
    openvdb::GridBase::Ptr wanted;
    std::string there;
    bool has_anothers_tree = false;
    each_grid(path, [&](const Grid& found) {
      there += " " + found.descriptor.gridName();
      if (wanted || found.descriptor.gridName() != name) return;
      wanted = found.grid;
      has_anothers_tree = found.descriptor.isInstance();
      if (!has_anothers_tree) readGrid(wanted, found.descriptor, found.in);
    });
    if (!wanted)
      throw FileError(fmt::format("{} has no grid \"{}\"; it has:{}", path.string(), name, there));
    if (!has_anothers_tree) return wanted;
    const openvdb::GridPtrVecPtr all = grids(path);
    return *std::ranges::find_if(*all, [&](const auto& one) { return one->getName() == name; });
  }
  /// All grids, whole.
  openvdb::GridPtrVecPtr grids(const fs::path& path) {
    auto all = std::make_shared<openvdb::GridPtrVec>();
    NamedGridMap by_name;
    each_grid(path, [&](const Grid& found) {
      readGrid(found.grid, found.descriptor, found.in);
      by_name.emplace(found.descriptor.uniqueName(), found.grid);
      connectInstance(found.descriptor, by_name);
      all->push_back(found.grid);
    });
    return all;
  }

 private:
  struct Grid {
    const openvdb::io::GridDescriptor& descriptor;
    openvdb::GridBase::Ptr grid;  ///< without its contents
    std::istream& in;             ///< where these begin
  };

  template <class Visit>
  void each_grid(const fs::path& path, const Visit& visit) {
    std::ifstream in(path, std::ios::binary);
    in.exceptions(std::ios::failbit | std::ios::badbit);
    check_version(in);
    readHeader(in);
    setFormatVersion(in);
    setLibraryVersion(in);
    check_lengths_of_file(in);
    metadata_ = std::make_shared<openvdb::MetaMap>();
    metadata_->readMeta(in);
    for (int grids_left = readGridCount(in); grids_left > 0; --grids_left) {
      constexpr int names = 3;  // the grid's, its type's, and that of another with the same tree
      Passing passing(in);
      passing.texts(names);
      passing.end();
      openvdb::io::GridDescriptor descriptor;
      const openvdb::GridBase::Ptr empty = descriptor.read(in);
      check_lengths_of_grid(in);
      // Where a grid ends is written last: 0 when there was no room for that any more.
      if (descriptor.getEndPos() <= in.tellg()) throw std::runtime_error("a grid has no end");
      visit(Grid{descriptor, empty, in});
      descriptor.seekToEnd(in);
    }
    // Seeking succeeds beyond the end, so the last grid may still be cut off.
    const auto expected = in.tellg();
    if (in.seekg(0, std::ios::end).tellg() < expected)
      throw std::runtime_error("it ends too early");
  }

  static void check_lengths_of_file(std::istream& in) {
    Passing passing(in);
    passing.metadata();
    passing.end();
  }

  static void check_lengths_of_grid(std::istream& in) {
    Passing passing(in);
    passing.number();  // of its compression
    passing.metadata();
    passing.text();  // kind of its transform
    passing.end();
  }

  /// Of a newer format OpenVDB says on the terminal what it thinks, and tries all the same. Grids
  /// of formats before 2013 are laid out otherwise, so that lengths in them could not be checked.
  static void check_version(std::istream& in) {
    constexpr std::uint32_t least = openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION;
    constexpr std::uint32_t most = openvdb::OPENVDB_FILE_VERSION;
    std::uint32_t version = 0;
    in.seekg(sizeof(std::uint64_t));  // behind the magic number
    in.read(reinterpret_cast<char*>(&version), sizeof version);
    if (version < least || version > most)
      throw std::runtime_error(
          fmt::format("found version {} of the format, expected {} to {}", version, least, most));
    in.seekg(0);
  }

  openvdb::MetaMap::Ptr metadata_;
};

/// What `read` makes of a file; whatever is wrong with that is a FileError.
template <class Read>
auto read_checked(const fs::path& path, const Read& read) {
  openvdb::initialize();
  try {
    return read();
  } catch (const FileError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw FileError(
        fmt::format("cannot read {}: out of memory; the file is damaged, or larger than --memory, "
                    "or the machine, allows",
                    path.string()));
  } catch (const std::ios::failure&) {
    throw FileError(fmt::format("cannot read {}: it ends too early", path.string()));
  } catch (const std::exception& error) {
    throw FileError(fmt::format("cannot read {}: {}", path.string(), error.what()));
  }
}

}  // namespace

void write_vdb(const fs::path& path, const openvdb::GridPtrVec& grids,
               const openvdb::MetaMap& metadata) {
  openvdb::initialize();
  write_file_by_path(path, [&](const fs::path& temporary) {
    {
      openvdb::io::File file(temporary.string());
      // Active values only. Blosc on top packs every leaf for itself, a few dozen values here: it
      // saves little and takes half of the time.
      file.setCompression(openvdb::io::COMPRESS_ACTIVE_MASK);
      file.setGridStatsMetadataEnabled(false);
      file.write(grids, metadata);
    }
    Reader().check(temporary);  // OpenVDB says nothing of a full disk
    overwrite_header(temporary);
  });
}

openvdb::GridPtrVecPtr read_vdb(const fs::path& path) {
  return read_checked(path, [&] { return Reader().grids(path); });
}

openvdb::GridBase::Ptr read_vdb_grid(const fs::path& path, const std::string& name) {
  return read_checked(path, [&] { return Reader().grid(path, name); });
}

openvdb::MetaMap::Ptr read_vdb_metadata(const fs::path& path) {
  return read_checked(path, [&] { return Reader().metadata(path); });
}

}  // namespace wold
