#include "compare/ssim.h"

#include "compare/filter.h"
#include "compare/pixels.h"
#include "core/colour.h"

namespace wold::compare {
namespace {

// Wang et al. 2004, section III.C, for values up to 1.
constexpr double window_sigma_px = 1.5;
constexpr int window_radius_px = 5;
constexpr double c1 = 0.01 * 0.01;
constexpr double c2 = 0.03 * 0.03;

double luma(const float* rgb) { return luminance({rgb[0], rgb[1], rgb[2]}); }

/// Both lumas, their squares and their product: what the local moments are means of.
void products(float* out, const float* got, const float* want) {
  const double x = luma(got);
  const double y = luma(want);
  const std::array<double, 5> values = {x, y, x * x, y * y, x * y};
  std::copy(values.begin(), values.end(), out);
}

/// Equation 13, from the local means of products().
void similarity(float* out, const float* means) {
  const double mean_x = means[0];
  const double mean_y = means[1];
  const double variance_x = means[2] - mean_x * mean_x;
  const double variance_y = means[3] - mean_y * mean_y;
  const double covariance = means[4] - mean_x * mean_y;
  const double value = (2.0 * mean_x * mean_y + c1) * (2.0 * covariance + c2) /
                       ((mean_x * mean_x + mean_y * mean_y + c1) * (variance_x + variance_y + c2));
  out[0] = static_cast<float>(value);
}

}  // namespace

double ssim(const Image& got, const Image& want) {
  const Weights window = gaussian(window_sigma_px, window_radius_px);
  const Image moments =
      filtered(pixelwise(5, products, shown_rgb(got), shown_rgb(want)), window, window);
  return mean(pixelwise(1, similarity, moments));
}

}  // namespace wold::compare
