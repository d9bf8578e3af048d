#include "compare/filter.h"

#include <OpenImageIO/imagebufalgo.h>

#include <cmath>
#include <stdexcept>

namespace wold::compare {
namespace {

/// The kernel's middle is at 0. OpenImageIO's own Gaussian kernels end at two standard deviations,
/// too early for the papers.
OIIO::ImageBuf kernel(const Weights& weights, bool is_across) {
  const auto size = static_cast<int>(weights.size());
  OIIO::ImageSpec spec(is_across ? size : 1, is_across ? 1 : size, 1, OIIO::TypeDesc::FLOAT);
  (is_across ? spec.x : spec.y) = -size / 2;
  OIIO::ImageBuf result(spec);
  result.set_pixels(result.roi(), OIIO::TypeDesc::DOUBLE, weights.data());
  return result;
}

OIIO::ImageBuf convolved(const OIIO::ImageBuf& image, const OIIO::ImageBuf& kernel) {
  constexpr bool normalise = false;
  OIIO::ImageBuf result = OIIO::ImageBufAlgo::convolve(image, kernel, normalise);
  if (result.has_error()) throw std::runtime_error(result.geterror());
  return result;
}

}  // namespace

Weights weights(int radius, const std::function<double(double)>& curve) {
  Weights result;
  double above = 0.0;
  double below = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    result.push_back(curve(i));
    (result.back() > 0.0 ? above : below) += std::abs(result.back());
  }
  for (double& weight : result) weight /= weight < 0.0 ? below : above;
  return result;
}

Weights gaussian(double sigma_px, int radius) {
  return weights(radius, [&](double x) { return std::exp(-x * x / (2.0 * sigma_px * sigma_px)); });
}

Image filtered(const Image& image, const Weights& across, const Weights& down) {
  Image result = image;
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  const OIIO::ImageBuf source(spec, result.values.data());
  const OIIO::ImageBuf both =
      convolved(convolved(source, kernel(across, true)), kernel(down, false));
  both.get_pixels(source.roi(), OIIO::TypeDesc::FLOAT, result.values.data());
  return result;
}

}  // namespace wold::compare
