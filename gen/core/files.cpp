#include "core/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "core/error.h"
#include "core/temporary_name.h"

namespace wold {
namespace fs = std::filesystem;
namespace {

std::string reason(int error) { return error == 0 ? "unknown reason" : std::strerror(error); }

/// Why writing in `folder` failed: what errno says of the disk, and else, since libraries may have
/// lost it, what the folder looks like now. That alone would not do: another thread that failed as
/// well may have made room again by removing what it had begun.
std::string reason_of_disk(int error_number, const fs::path& folder) {
  for (const int known : {ENOSPC, EDQUOT, EFBIG, EIO, EROFS})
    if (error_number == known) return reason(known);
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (error) return error.message();
  if (space.available < 65536) return "no space left on device";
  if (::access(folder.c_str(), W_OK) != 0) return reason(errno);
  return {};
}

/// Makes an empty file where there is none, so that whoever opens it by name opens this one.
void create_anew(const fs::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0) throw FileError(reason(errno));
  ::close(file);
}

/// Where shipped files may lie: of an installation, of sources around a build folder, of that.
std::array<fs::path, 3> shipped_folders() {
  std::error_code ignored;
  const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  return {(folder / WOLD_DATA_FROM_PROGRAM).lexically_normal(), folder.parent_path(),
          folder / "share/wold"};
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw FileError(fmt::format("cannot create folder {}: {}", folder.string(), error.message()));
}

void write_file_by_path(const fs::path& path, const std::function<void(const fs::path&)>& writer) {
  const fs::path temporary = temporary_name(path);
  const auto remove_temporary = [&] {
    std::error_code ignored;
    fs::remove(temporary, ignored);
  };
  try {
    create_anew(temporary);
    errno = 0;
    writer(temporary);
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error) throw FileError(error.message());
  } catch (const InterruptedError&) {
    remove_temporary();
    throw;
  } catch (const std::bad_alloc&) {
    remove_temporary();
    throw;
  } catch (const std::exception& error) {
    const int error_number = errno;
    const std::string why =
        reason_of_disk(error_number, path.has_parent_path() ? path.parent_path() : ".");
    remove_temporary();
    const auto* known = dynamic_cast<const Error*>(&error);
    if (why.empty() && known != nullptr && known->code() != ExitCode::file) throw;
    throw FileError(
        fmt::format("cannot write {}: {}", path.string(), why.empty() ? error.what() : why));
  }
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& writer) {
  write_file_by_path(path, [&](const fs::path& temporary) {
    std::ofstream out(temporary, std::ios::binary);
    if (!out) throw FileError(reason(errno));
    writer(out);
    out.flush();
    if (!out) throw FileError(reason(errno));
  });
}

void write_file(const fs::path& path, std::string_view bytes) {
  write_file(path, [&](std::ostream& out) {
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

std::string why_no_regular_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status)) return "";
  if (fs::is_directory(status)) return "it is a folder, a file was expected";
  if (fs::exists(status)) return "it is a pipe or a device, a file was expected";
  return reason(error ? error.value() : ENOENT);
}

void require_regular_file(const fs::path& path) {
  if (const std::string why = why_no_regular_file(path); !why.empty())
    throw FileError(fmt::format("cannot read {}: {}", path.string(), why));
}

std::string read_file(const fs::path& path) {
  require_regular_file(path);
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw FileError(fmt::format("cannot read {}: {}", path.string(), reason(errno)));
  std::string bytes;
  const std::uintmax_t size = fs::file_size(path, error);
  if (!error) bytes.reserve(size);
  std::array<char, 1 << 16> block;
  while (in.read(block.data(), block.size()) || in.gcount() > 0)
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw FileError(fmt::format("cannot read {}: {}", path.string(), reason(errno)));
  return bytes;
}

void remove_file(const fs::path& path) {
  if (::unlink(path.c_str()) == 0) return;
  if (errno == ENOENT || errno == ENOTDIR || errno == EISDIR) return;
  throw FileError(fmt::format("cannot remove {}: {}", path.string(), reason(errno)));
}

void remove_empty_folder(const fs::path& folder) { ::rmdir(folder.c_str()); }

void update_file(const fs::path& path, std::string_view bytes) {
  if (!fs::is_regular_file(path) || read_file(path) != bytes) write_file(path, bytes);
}

std::string content_hash(std::string_view bytes) {
  return fmt::format("{:016x}", XXH64(bytes.data(), bytes.size(), 0));
}

fs::path shipped_file(std::string_view relative) {
  std::string looked;
  for (const fs::path& folder : shipped_folders()) {
    std::error_code ignored;
    if (fs::exists(folder / relative, ignored)) return folder / relative;
    looked += fmt::format("\n  {}", (folder / relative).string());
  }
  throw FileError(fmt::format("{} is missing; looked for it at{}", relative, looked));
}

fs::path shipped_library(std::string_view name) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const std::string file = fmt::format("lib/wold/libwold_{}.so", name);
  for (const fs::path& library : {(program / ".." / file).lexically_normal(), program / file})
    if (fs::is_regular_file(library, ignored)) return library;
  return {};
}

fs::path bundled_folder(std::string_view relative) {
  std::error_code ignored;
  const fs::path folder = shipped_folders().front() / relative;
  return fs::is_directory(folder, ignored) ? folder : fs::path();
}

}  // namespace wold
