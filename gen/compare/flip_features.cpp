#include "compare/flip_features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/filter.h"
#include "compare/pixels.h"
#include "core/elementary.h"

namespace wold::compare {
namespace {

constexpr double edge_width_deg = 0.082;  // what the eye detects best, section 4.2.1
constexpr double exponent = 0.5;          // section 4.2.2

/// Derivatives of a Gaussian of the picture's brightness: the first finds edges, the second points.
class FeatureDetector {
 public:
  explicit FeatureDetector(double pixels_per_degree)
      : sigma_px_(0.5 * edge_width_deg * pixels_per_degree),
        smooth_(gaussian(sigma_px_, radius())),
        first_(weights(radius(), [&](double x) { return -x * bell(x); })),
        second_(weights(radius(), [&](double x) {
          return (x * x / (sigma_px_ * sigma_px_) - 1.0) * bell(x);
        })) {}

  Image edges(const Image& brightness) const { return strength(brightness, first_); }
  Image points(const Image& brightness) const { return strength(brightness, second_); }

 private:
  int radius() const { return static_cast<int>(std::ceil(3.0 * sigma_px_)); }
  double bell(double x) const { return math::exp(-x * x / (2.0 * sigma_px_ * sigma_px_)); }

  /// Length of the derivative across and down.
  Image strength(const Image& brightness, const Weights& derivative) const {
    const auto length = [](float* out, const float* x, const float* y) {
      *out = math::hypot(*x, *y);
    };
    return pixelwise(1, length, filtered(brightness, derivative, smooth_),
                     filtered(brightness, smooth_, derivative));
  }

  double sigma_px_;
  Weights smooth_;
  Weights first_;
  Weights second_;
};

/// From 0 to 1.
Image brightness_of(const Image& opponent) {
  const auto scale = [](float* out, const float* pixel) { *out = (pixel[0] + 16.0F) / 116.0F; };
  return pixelwise(1, scale, opponent);
}

void difference(float* out, const float* edge, const float* other_edge, const float* point,
                const float* other_point) {
  const float larger = std::max(std::abs(*edge - *other_edge), std::abs(*point - *other_point));
  const double fraction = math::pow(larger / std::numbers::sqrt2, exponent);
  *out = static_cast<float>(std::min(fraction, 1.0));
}

}  // namespace

Image feature_differences(const Image& got, const Image& want, double pixels_per_degree) {
  const FeatureDetector detector(pixels_per_degree);
  const Image a = brightness_of(got);
  const Image b = brightness_of(want);
  return pixelwise(1, difference, detector.edges(a), detector.edges(b), detector.points(a),
                   detector.points(b));
}

}  // namespace wold::compare
