#include <cstdint>
#include <cstdlib>

#include "compare/vdb.h"
#include "core/error.h"
#include "scratch_file.h"

/// Any bytes are grids or an error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const fuzz::ScratchFile file(bytes, count);
  try {
    for (const compare::GridFacts& grid : compare::vdb_facts(file.path()).grids)
      if (grid.has_range && !(grid.min <= grid.largest)) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
