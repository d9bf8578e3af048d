#pragma once

#include "core/image.h"

/// The colour pipeline of FLIP (Andersson et al. 2020, section 4.1; see flip.h).
namespace wold::compare {

/// The picture as brightness and two opponent colours, YCxCz: L*a*b* without its cube roots, so
/// that light can be added up in it. Y is 100 for white; Cx goes from green to red, Cz from blue to
/// yellow.
Image opponent_colours(const Image& image);

/// How different the colours look, from 0 to 1, when detail too fine for the eye is left out. The
/// pictures are opponent_colours() of one size.
Image colour_differences(const Image& got, const Image& want, double pixels_per_degree);

}  // namespace wold::compare
