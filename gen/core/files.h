#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace wold {

/// Creates the folder and its parents. Throws FileError with the reason.
void make_folder(const std::filesystem::path& folder);

/// Writes a whole file or nothing: `writer` fills a temporary neighbour, which is
/// renamed to `path`. Throws FileError that names the path and the system's reason (disk full,
/// permission); the temporary is removed and an older file under `path` stays as it was.
void write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& writer);
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The same for libraries that insist on opening the file themselves: `writer` is given the
/// temporary's path, which has the extension of `path`, and throws when it fails. An error of the
/// writer's own kind (renderer, input, interrupt) reaches the caller, unless the folder is full or
/// unwritable, which is then the reason.
void write_file_by_path(const std::filesystem::path& path,
                        const std::function<void(const std::filesystem::path&)>& writer);

/// Writes a file unless it has these bytes already: what others have open stays as it is, also on
/// network file systems, where a replaced file is lost to them. Throws FileError.
void update_file(const std::filesystem::path& path, std::string_view bytes);

/// Removes a file or a link; a folder under that name stays, and where nothing is nothing is done.
/// Throws FileError.
void remove_file(const std::filesystem::path& path);

/// Removes an empty folder; a file, a link or a folder in which something is stays.
void remove_empty_folder(const std::filesystem::path& folder);

/// Why a path does not lead to a regular file, such as "it is a folder, a file was expected"; empty
/// when it does.
std::string why_no_regular_file(const std::filesystem::path& path);

/// Throws FileError unless the path leads to a regular file: a pipe or a device may have no end.
void require_regular_file(const std::filesystem::path& path);

/// The whole file. Throws FileError when it is missing, unreadable or no regular file.
std::string read_file(const std::filesystem::path& path);

/// 64-bit content hash as 16 hexadecimal digits: xxHash's XXH64. Names of files and records have
/// it, so that the newer XXH3 would make all of them anew.
std::string content_hash(std::string_view bytes);

/// A file that ships with the program: relative is "models/..." or "templates/...". It is looked
/// for from where the program is: where an installation has it (../share/wold), in sources around
/// its build folder, and in that. Throws FileError that says where it looked.
std::filesystem::path shipped_file(std::string_view relative);

/// A library that ships to be preloaded into a renderer, by its name without "libwold_": where an
/// installation has it (../lib/wold from the program), or in the build folder. Empty where there is
/// none, as in sanitized builds.
std::filesystem::path shipped_library(std::string_view name);

/// A folder that ships in some installations alone: "examples" in all but a build's own folder, and
/// in packages which bring their libraries along the libraries' files, such as "proj". Empty where
/// there is none.
std::filesystem::path bundled_folder(std::string_view relative);

}  // namespace wold
