#pragma once

#include <vector>

#include "core/expected_picture.h"
#include "core/image.h"

namespace wold::render {

/// How much a picture shows of things that should be there.
struct ShownFraction {
  double contrast = 0.0;  ///< they change the picture by so much: root mean square over all of it,
                          ///< of sRGB in [0, 1]
  double fraction = 0.0;  ///< of that change that is there: 1 all, 0 none
};

/// `picture`: sRGB in [0, 1], 3 channels or more, as wide to its height as what was expected.
ShownFraction shown_fraction(const Image& picture, const ExpectedPicture& expected,
                             const ExpectedThings& things);

}  // namespace wold::render
