#pragma once

#include "core/image.h"

namespace wold::compare {

/// Mean structural similarity of two pictures of one size, on luma: 1 for equal pictures, down to
/// -1. Wang, Bovik, Sheikh and Simoncelli 2004 (IEEE Transactions on Image Processing 13:600), but
/// that the border's values continue outside, so that the border counts and any size will do.
double ssim(const Image& got, const Image& want);

}  // namespace wold::compare
