#include "render/picture_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/image.h"

namespace wold::render {
namespace {

// In 8 bits: less variation than that is one colour, which has half a step at most where a renderer
// dithers.
constexpr double min_deviation = 0.6 / 255.0;

/// Standard deviation of one channel over the pixels.
double deviation(const Image& image, int channel) {
  double sum = 0.0;
  double sum_of_squares = 0.0;
  const auto stride = static_cast<std::size_t>(image.channels);
  for (std::size_t i = static_cast<std::size_t>(channel); i < image.values.size(); i += stride) {
    const double value = image.values[i];
    sum += value;
    sum_of_squares += value * value;
  }
  const std::size_t pixels = image.values.size() / stride;
  const auto count = static_cast<double>(pixels);
  const double mean = sum / count;
  return std::sqrt(std::max(0.0, sum_of_squares / count - mean * mean));
}

/// Whether the colour never changes; an alpha channel is not looked at.
bool is_blank(const Image& image) {
  for (int channel = 0; channel < std::min(image.channels, 3); ++channel)
    if (deviation(image, channel) > min_deviation) return false;
  return true;
}

}  // namespace

std::string picture_problem(const std::filesystem::path& picture, glm::ivec2 size_px) {
  std::error_code ignored;
  if (!std::filesystem::exists(picture, ignored)) return "it wrote no picture";
  Image image;
  try {
    image = read_image(picture);
  } catch (const FileError& error) {
    return fmt::format("its picture is damaged ({})", error.what());
  }
  if (image.width != size_px.x || image.height != size_px.y)
    return fmt::format("its picture has {} x {} pixels, {} x {} were asked for", image.width,
                       image.height, size_px.x, size_px.y);
  if (!std::ranges::all_of(image.values, [](float value) { return std::isfinite(value); }))
    return "its picture has values that are not finite numbers";
  if (is_blank(image)) return "its picture is blank: every pixel has the same colour";
  return {};
}

}  // namespace wold::render
