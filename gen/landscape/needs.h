#pragma once

#include <limits>

namespace wold::landscape {

/// What exporters ask of a landscape: how far its model has to keep to what renderers can show, and
/// what it has to hold.
struct Needs {
  /// Flakes that a ray may pass, on average over a small part of the picture; infinite where no
  /// renderer has a limit.
  double max_flakes_on_a_ray = std::numeric_limits<double>::infinity();
  /// Whether materials without light are to be there, for a renderer that lights them itself.
  bool materials = false;
};

}  // namespace wold::landscape
