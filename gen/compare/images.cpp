#include "compare/images.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/colour.h"

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

double mean_abs(const Image& image) {
  double sum = 0.0;
  for (float value : image.values) sum += std::abs(static_cast<double>(value));
  return sum / static_cast<double>(image.values.size());
}

/// The mean over 8 x 8 pixels taken twice, which is a triangle 16 pixels wide. The border's values
/// continue outside the picture.
Image blurred8(Image image) {
  const OIIO::ImageSpec spec(image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT);
  const OIIO::ImageBuf source(spec, image.values.data());
  const auto across = OIIO::ImageBufAlgo::make_kernel("triangle", 16.0F, 1.0F);
  const auto down = OIIO::ImageBufAlgo::make_kernel("triangle", 1.0F, 16.0F);
  const auto result =
      OIIO::ImageBufAlgo::convolve(OIIO::ImageBufAlgo::convolve(source, across), down);
  Image copy(image.width, image.height, image.channels);
  if (!result.get_pixels(source.roi(), OIIO::TypeDesc::FLOAT, copy.values.data()))
    throw std::runtime_error(result.geterror());
  return copy;
}

/// ISO/CIE 11664-4, relative to the white of sRGB.
glm::dvec3 lab_from_xyz(const glm::dvec3& xyz, const glm::dvec3& white_xyz) {
  constexpr double knee = 6.0 / 29.0;
  const auto f = [](double t) {
    return t > knee * knee * knee ? std::cbrt(t) : t / (3.0 * knee * knee) + 4.0 / 29.0;
  };
  const glm::dvec3 t = xyz / white_xyz;
  return {116.0 * f(t.y) - 16.0, 500.0 * (f(t.x) - f(t.y)), 200.0 * (f(t.y) - f(t.z))};
}

glm::dvec3 linear_colour(const float* pixel) {
  return {srgb_decoded(pixel[0]), srgb_decoded(pixel[1]), srgb_decoded(pixel[2])};
}

double mean_delta_e(const Image& got, const Image& want) {
  if (got.channels < 3) return 0.0;
  const glm::dvec3 white_xyz = xyz_from_srgb(glm::dvec3(1.0));
  const auto lab = [&](const float* pixel) {
    return lab_from_xyz(xyz_from_srgb(linear_colour(pixel)), white_xyz);
  };
  double sum = 0.0;
  for (int y = 0; y < got.height; ++y)
    for (int x = 0; x < got.width; ++x) {
      const double distance = glm::distance(lab(got.pixel(x, y)), lab(want.pixel(x, y)));
      if (std::isfinite(distance)) sum += distance;
    }
  return sum / (static_cast<double>(got.width) * got.height);
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
  metrics.psnr_db = -20.0 * std::log10(metrics.rmse);
  metrics.mean_shift = channel_means(difference);
  metrics.mean_abs_blurred8 = mean_abs(blurred8(difference));
  metrics.mean_delta_e = mean_delta_e(got, want);
  return metrics;
}

Image difference_image(const Image& got, const Image& want, float gain) {
  require_same_shape(got, want);
  Image difference = signed_difference(got, want);
  for (float& value : difference.values) value = gain * std::abs(value);
  return difference;
}

}  // namespace wold::compare
