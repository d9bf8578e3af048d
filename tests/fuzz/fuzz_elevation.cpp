#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/error.h"
#include "scratch_file.h"
#include "terrain/elevation.h"

/// Any bytes are an elevation model or an error; the ground of one is finite and starts at 0. GDAL
/// is told nothing of the format: the same window code reads them all.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const fuzz::ScratchFile file(bytes, count);
  try {
    const terrain::Elevation elevation = terrain::read_elevation({.elevation = file.path().string(),
                                                                  .system = {},
                                                                  .centre = {},
                                                                  .size_m = 60.0,
                                                                  .samples = 9});
    for (const double height_m : elevation.heights_m.values())
      if (!(std::isfinite(height_m) && height_m >= 0.0)) std::abort();
  } catch (const InputError&) {
  } catch (const FileError&) {
  }
  return 0;
}
