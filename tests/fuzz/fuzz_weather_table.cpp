#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/error.h"
#include "scratch_file.h"
#include "snow/weather.h"

/// Any bytes are a table of weather or an error; what it says is finite at any time.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const fuzz::ScratchFile file(bytes, count);
  scene::Scene scene;
  scene.weather.table = file.path().string();
  try {
    const snow::Weather weather(scene, nullptr);
    for (const double time_s : {-1e6, 0.0, 1800.0, 1e9})
      if (!std::isfinite(weather.snow_mm_h(time_s, 1000.0)) ||
          !std::isfinite(weather.at(time_s).temperature_c))
        std::abort();
  } catch (const InputError&) {
  } catch (const FileError&) {
  }
  return 0;
}
