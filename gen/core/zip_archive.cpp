#include "core/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "core/error.h"

namespace wold {
namespace {

constexpr zip_uint16_t first_day = (1 << 5) | 1;        // 1 January 1980, of which MS-DOS counts
constexpr zip_uint32_t readable_file = 0100644U << 16;  // as Unix has it

FileError failure(const char* reason) {
  return FileError(fmt::format("cannot make the ZIP archive: {}", reason));
}

struct SourceFree {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, SourceFree>;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, Discard>;

Source memory() {
  Source source(zip_source_buffer_create(nullptr, 0, 0, nullptr));
  if (!source) throw failure("out of memory");
  return source;
}

/// `file` has to live until the archive is closed.
void add(zip_t* archive, const ArchivedFile& file) {
  zip_source_t* bytes = zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
  const zip_int64_t added =
      bytes == nullptr ? -1 : zip_file_add(archive, file.name.c_str(), bytes, ZIP_FL_ENC_UTF_8);
  if (added < 0) {
    zip_source_free(bytes);
    throw failure(zip_strerror(archive));
  }
  const auto index = static_cast<zip_uint64_t>(added);
  if (zip_set_file_compression(archive, index, ZIP_CM_STORE, 0) != 0 ||
      zip_file_set_dostime(archive, index, 0, first_day, 0) != 0 ||
      zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, readable_file) != 0)
    throw failure(zip_strerror(archive));
}

std::string bytes_of(zip_source_t* source) {
  zip_stat_t state;
  zip_stat_init(&state);
  if (zip_source_stat(source, &state) != 0 || zip_source_open(source) != 0)
    throw failure(zip_error_strerror(zip_source_error(source)));
  std::string bytes(state.size, '\0');
  const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (count != static_cast<zip_int64_t>(bytes.size()))
    throw failure(zip_error_strerror(zip_source_error(source)));
  return bytes;
}

}  // namespace

std::string zip_archive(const std::vector<ArchivedFile>& files) {
  const Source source = memory();
  zip_error_t error;
  zip_error_init(&error);
  Archive archive(zip_open_from_source(source.get(), ZIP_TRUNCATE, &error));
  if (!archive) throw failure(zip_error_strerror(&error));
  zip_source_keep(source.get());  // closing the archive gives one of the two back
  for (const ArchivedFile& file : files) add(archive.get(), file);
  if (zip_close(archive.get()) != 0) throw failure(zip_strerror(archive.get()));
  archive.release();
  return bytes_of(source.get());
}

}  // namespace wold
