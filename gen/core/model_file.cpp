#include "core/model_file.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"

namespace wold {

toml::table read_model_file(const std::filesystem::path& file) {
  try {
    return toml::parse(read_file(file), file.string());
  } catch (const toml::parse_error& error) {
    throw FileError(
        fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

}  // namespace wold
