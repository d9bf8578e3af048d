#include "landscape/landscape.h"

#include <fmt/format.h>

#include <cmath>

namespace wold::landscape {

std::string suffix_of(const Part& part) {
  if (part.is_whole()) return {};
  const auto myriadth = [](double fraction) { return std::lround(1e4 * fraction); };
  return fmt::format("_x{}-{}_y{}-{}", myriadth(part.low.x), myriadth(part.high.x),
                     myriadth(part.low.y), myriadth(part.high.y));
}

}  // namespace wold::landscape
