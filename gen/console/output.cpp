#include "console/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "core/error.h"
#include "core/printable.h"

namespace wold::console {

void print_data(std::string_view text) {
  const std::string shown = ::isatty(STDOUT_FILENO) != 0 ? printable(text) : std::string(text);
  errno = 0;
  const bool whole = std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size();
  if (!whole || std::fflush(stdout) != 0)
    throw FileError(std::string("cannot write to standard output: ") + std::strerror(errno));
}

void print_message(std::string_view text) { print_progress(printable(text) + '\n'); }

void print_progress(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace wold::console
