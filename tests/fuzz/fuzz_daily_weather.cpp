#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/error.h"
#include "scratch_file.h"
#include "weather/daily_weather.h"

/// Any bytes are days in a row, with numbers for all that a season needs, or an error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const fuzz::ScratchFile file(bytes, count);
  try {
    for (const weather::Day& day : weather::read_daily_weather(file.path(), 47.0))
      if (!(day.tmin_c <= day.tmax_c && day.precipitation_mm >= 0.0 && day.day_length_h >= 0.0))
        std::abort();
  } catch (const InputError&) {
  } catch (const FileError&) {
  }
  return 0;
}
