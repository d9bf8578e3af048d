#include "snow/weather.h"

#include <algorithm>

namespace wold::snow {

double snow_share(double temperature_c) { return std::clamp(1.0 - 0.5 * temperature_c, 0.0, 1.0); }

}  // namespace wold::snow
