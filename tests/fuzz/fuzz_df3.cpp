#include <cstdint>
#include <cstdlib>
#include <sstream>

#include "core/df3.h"
#include "core/error.h"
#include "scratch_file.h"

/// Any bytes are a density file or a FileError; what was read has a value in [0, 1] per voxel and
/// can be written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const fuzz::ScratchFile file(bytes, count);
  try {
    const Df3 df3 = read_df3(file.path());
    for (const float value : df3.values)
      if (!(value >= 0.0F && value <= 1.0F)) std::abort();
    std::ostringstream out;
    write_df3(out, df3.size, df3.values, 1.0F, 8);
  } catch (const FileError&) {
  }
  return 0;
}
