#include "cloud/picture_texture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/image.h"

namespace wold::cloud {
namespace {

void refuse_too_large(const std::filesystem::path& path) {
  const ImageHeader header = read_image_header(path);
  if (header.width > largest_picture_px || header.height > largest_picture_px)
    throw FileError(fmt::format(
        "cannot use {} as clouds: found {} x {} pixels, expected at most "
        "{} x {}",
        path.string(), header.width, header.height, largest_picture_px, largest_picture_px));
}

bool is_opaque(const Image& image) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.pixel(x, y)[image.channels - 1] < 1.0F) return false;
  return true;
}

float luminance(const float* pixel, int channels) {
  return channels < 3 ? pixel[0] : 0.2126F * pixel[0] + 0.7152F * pixel[1] + 0.0722F * pixel[2];
}

/// Pictures have their first row at the top, maps at the south.
PeriodicMap<float> opacities(const Image& image) {
  const bool by_alpha = (image.channels == 2 || image.channels == 4) && !is_opaque(image);
  PeriodicMap<float> map(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* pixel = image.pixel(x, image.height - 1 - y);
      const float value = by_alpha ? pixel[image.channels - 1] : luminance(pixel, image.channels);
      map.at(x, y) = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
    }
  return map;
}

/// Means of the source's pixels that fall on each of the fewer pixels.
PeriodicMap<float> averaged(const PeriodicMap<float>& map, int max_px) {
  const int width = std::min(map.width(), max_px);
  const int height = std::min(map.height(), max_px);
  if (width == map.width() && height == map.height()) return map;
  const auto edge = [](int i, int from, int to) {
    return static_cast<int>(static_cast<std::int64_t>(i) * from / to);
  };
  PeriodicMap<float> result(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0.0;
      const int x1 = edge(x + 1, map.width(), width), y1 = edge(y + 1, map.height(), height);
      const int x0 = edge(x, map.width(), width), y0 = edge(y, map.height(), height);
      for (int j = y0; j < y1; ++j)
        for (int i = x0; i < x1; ++i) sum += map.at(i, j);
      result.at(x, y) = static_cast<float>(sum / ((x1 - x0) * (y1 - y0)));
    }
  return result;
}

PeriodicMap<float> transposed(const PeriodicMap<float>& map) {
  PeriodicMap<float> result(map.height(), map.width());
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) result.at(y, x) = map.at(x, y);
  return result;
}

/// Mean step from the column before, which may be the last.
double step_into(const PeriodicMap<float>& map, int x) {
  double sum = 0.0;
  for (int y = 0; y < map.height(); ++y)
    sum += std::abs(static_cast<double>(map.at(x, y)) - map.wrapped(x - 1, y));
  return sum / map.height();
}

/// Whether the step from the last column to the first is like the largest inside.
bool closes(const PeriodicMap<float>& map) {
  double inside = 0.0;
  for (int x = 1; x < map.width(); ++x) inside = std::max(inside, step_into(map, x));
  constexpr double tolerated = 1.25;
  return step_into(map, 0) <= tolerated * inside;
}

/// Cross-fades the last columns into the first and cuts them off.
PeriodicMap<float> closed_in_x(const PeriodicMap<float>& map) {
  const int overlap = map.width() / 8;
  if (overlap == 0 || closes(map)) return map;
  PeriodicMap<float> result(map.width() - overlap, map.height());
  for (int y = 0; y < result.height(); ++y)
    for (int x = 0; x < result.width(); ++x) {
      const float own =
          x < overlap ? (static_cast<float>(x) + 0.5F) / static_cast<float>(overlap) : 1.0F;
      const float other = x < overlap ? map.at(result.width() + x, y) : 0.0F;
      result.at(x, y) = own * map.at(x, y) + (1.0F - own) * other;
    }
  return result;
}

}  // namespace

PeriodicMap<float> picture_opacity(const std::filesystem::path& path, int max_px) {
  refuse_too_large(path);
  const PeriodicMap<float> map = averaged(opacities(read_image(path)), max_px);
  return transposed(closed_in_x(transposed(closed_in_x(map))));
}

}  // namespace wold::cloud
