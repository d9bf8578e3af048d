#include "compare/images.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "compare/filter.h"
#include "compare/flip.h"
#include "compare/pixels.h"
#include "compare/ssim.h"
#include "core/colour.h"
#include "core/elementary.h"

namespace wold::compare {
namespace {

void require_same_shape(const Image& got, const Image& want) {
  if (std::string why = shape_difference(got, want); !why.empty()) throw std::invalid_argument(why);
}

Differences differences(const Image& got, const Image& want, double soft) {
  DifferenceSum sum(soft);
  const auto channels = static_cast<std::size_t>(got.channels);
  for (std::size_t i = 0; i < got.values.size(); ++i) {
    sum.add(got.values[i], want.values[i]);
    if ((i + 1) % channels == 0) sum.end_sample();
  }
  return sum.result();
}

/// got - want; 0 where one of them is no finite number.
Image signed_difference(const Image& got, const Image& want) {
  Image result(got.width, got.height, got.channels);
  for (std::size_t i = 0; i < result.values.size(); ++i) {
    const float difference = got.values[i] - want.values[i];
    result.values[i] = std::isfinite(difference) ? difference : 0.0F;
  }
  return result;
}

glm::ivec2 worst_pixel(const Image& difference) {
  const auto worst =
      std::ranges::max_element(difference.values, {}, [](float value) { return std::abs(value); });
  const auto pixel = static_cast<int>((worst - difference.values.begin()) / difference.channels);
  return {pixel % difference.width, pixel / difference.width};
}

std::vector<double> channel_means(const Image& image) {
  std::vector<double> means(static_cast<std::size_t>(image.channels));
  for (std::size_t i = 0; i < image.values.size(); ++i) means[i % means.size()] += image.values[i];
  for (double& mean : means) mean /= static_cast<double>(image.width) * image.height;
  return means;
}

Image magnitude(Image image) {
  for (float& value : image.values) value = std::abs(value);
  return image;
}

/// The mean over 8 x 8 pixels taken twice, which is a triangle 16 pixels wide.
Image blurred8(const Image& image) {
  const Weights triangle = weights(8, [](double x) { return 8.0 - std::abs(x); });
  return filtered(image, triangle, triangle);
}

glm::dvec3 lab(const float* pixel) {
  return lab_from_xyz(
      xyz_from_srgb({srgb_decoded(pixel[0]), srgb_decoded(pixel[1]), srgb_decoded(pixel[2])}));
}

double mean_delta_e(const Image& got, const Image& want) {
  const auto distance = [](float* out, const float* a, const float* b) {
    *out = static_cast<float>(glm::distance(lab(a), lab(b)));
  };
  return mean(pixelwise(1, distance, shown_rgb(got), shown_rgb(want)));
}

}  // namespace

std::string shape_difference(const Image& got, const Image& want) {
  if (got.width == want.width && got.height == want.height && got.channels == want.channels)
    return {};
  return fmt::format("got {} x {} pixels with {} channels, want {} x {} with {}", got.width,
                     got.height, got.channels, want.width, want.height, want.channels);
}

ImageMetrics compare_images(const Image& got, const Image& want, double soft) {
  require_same_shape(got, want);
  const Image difference = signed_difference(got, want);
  ImageMetrics metrics;
  static_cast<Differences&>(metrics) = differences(got, want, soft);
  metrics.worst_px = worst_pixel(difference);
  metrics.psnr_db = -20.0 * math::log10(metrics.rmse);
  metrics.mean_shift = channel_means(difference);
  metrics.mean_abs_blurred8 = mean(magnitude(blurred8(difference)));
  metrics.mean_delta_e = mean_delta_e(got, want);
  metrics.ssim = ssim(got, want);
  metrics.flip_map = flip_map(got, want);
  metrics.flip = mean(metrics.flip_map);
  return metrics;
}

Image difference_image(const Image& got, const Image& want, float gain) {
  require_same_shape(got, want);
  Image difference = magnitude(signed_difference(got, want));
  for (float& value : difference.values) value *= gain;
  return difference;
}

Image flip_picture(const Image& flip_map) {
  Image map = flip_map;
  const OIIO::ImageSpec spec(map.width, map.height, 1, OIIO::TypeDesc::FLOAT);
  const OIIO::ImageBuf source(spec, map.values.data());
  const OIIO::ImageBuf coloured = OIIO::ImageBufAlgo::color_map(source, 0, "magma");
  Image result(map.width, map.height, 3);
  coloured.get_pixels(coloured.roi(), OIIO::TypeDesc::FLOAT, result.values.data());
  for (float& value : result.values) value = static_cast<float>(srgb_encoded(value));
  return result;
}

std::vector<Measure> measures(const ImageMetrics& metrics, const Limits& limits) {
  std::vector<Measure> list = measures(static_cast<const Differences&>(metrics), limits);
  list.push_back({.name = "FLIP", .value = metrics.flip, .max = limits.flip});
  list.push_back({.name = "SSIM", .value = metrics.ssim, .min = limits.ssim});
  list.push_back({.name = "PSNR (dB)", .value = metrics.psnr_db});
  list.push_back({.name = "mean L*a*b* difference", .value = metrics.mean_delta_e});
  return list;
}

}  // namespace wold::compare
