#include "core/version.h"

#include "core/error.h"
#include "core/files.h"

#ifdef __clang__
#define WOLD_COMPILER "clang " __clang_version__
#else
#define WOLD_COMPILER "GCC " __VERSION__
#endif

namespace wold {

const char* const version = WOLD_VERSION;

const char* const build = WOLD_COMPILER ", " WOLD_MACHINE;

std::string revision() {
  try {
    const std::string text = read_file(shipped_file("revision"));
    return text.substr(0, text.find('\n'));
  } catch (const FileError&) {
    return "unknown";
  }
}

}  // namespace wold
