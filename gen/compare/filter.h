#pragma once

#include <functional>
#include <vector>

#include "core/image.h"

namespace wold::compare {

/// What neighbours count along one axis: an odd number of weights, the middle one for the pixel
/// itself.
using Weights = std::vector<double>;

/// curve(distance in pixels) from -radius to radius, scaled so that what is above zero sums to 1
/// and what is below, if anything is, to -1.
Weights weights(int radius, const std::function<double(double)>& curve);

/// A Gaussian bell of the standard deviation `sigma_px`, cut off at the radius; sums to 1.
Weights gaussian(double sigma_px, int radius);

/// Every channel filtered along the rows, then along the columns. The border's values continue
/// outside the picture.
Image filtered(const Image& image, const Weights& across, const Weights& down);

}  // namespace wold::compare
