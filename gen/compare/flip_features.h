#pragma once

#include "core/image.h"

/// The feature pipeline of FLIP (Andersson et al. 2020, section 4.2; see flip.h).
namespace wold::compare {

/// How much edges and points of brightness differ, from 0 to 1. The pictures are opponent_colours()
/// of one size.
Image feature_differences(const Image& got, const Image& want, double pixels_per_degree);

}  // namespace wold::compare
