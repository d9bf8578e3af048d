#include "preview/sky_picture.h"

#include <algorithm>
#include <cmath>

#include "preview/camera_picture.h"

namespace wold::preview {
namespace {

/// Mean of the picture's pixels in a box in its pixels, of one channel.
float mean(const Image& picture, const glm::dvec2& low, const glm::dvec2& high, int channel) {
  const auto first = glm::ivec2(glm::floor(low));
  const auto end = glm::max(glm::ivec2(glm::ceil(high)), first + 1);
  float sum = 0.0F;
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x)
      sum +=
          picture.pixel(std::min(x, picture.width - 1), std::min(y, picture.height - 1))[channel];
  return sum / static_cast<float>((end.x - first.x) * (end.y - first.y));
}

void place_flake(const Image& opacity, const glm::ivec2& corner, int side_px, Image& picture) {
  const double step = static_cast<double>(opacity.width) / side_px;
  for (int y = 0; y < side_px; ++y)
    for (int x = 0; x < side_px; ++x) {
      const glm::dvec2 low = step * glm::dvec2(x, y);
      const float white = mean(opacity, low, low + step, 0);
      float* pixel = picture.pixel(corner.x + x, corner.y + y);
      for (int c = 0; c < 3; ++c) pixel[c] = std::lerp(pixel[c], 0.95F, white);
    }
}

}  // namespace

Image sky_picture(const landscape::Landscape& landscape, int width_px) {
  const Image& sky = landscape.sky;
  const double step = static_cast<double>(sky.width) / width_px;
  Image radiance(width_px, width_px / 4, 3);
  for (int y = 0; y < radiance.height; ++y)
    for (int x = 0; x < width_px; ++x)
      for (int c = 0; c < 3; ++c)
        radiance.pixel(x, y)[c] =
            mean(sky, step * glm::dvec2(x, y), step * glm::dvec2(x + 1, y + 1), c);
  return developed(radiance, landscape.exposure_gain);
}

Image flakes_picture(const landscape::Flakes& flakes, const glm::ivec2& size_px) {
  constexpr int per_row = 3;
  Image picture(size_px.x, size_px.y, 3);
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = i % 3 == 2 ? 0.36F : 0.3F;
  const int side_px = size_px.x / per_row;
  const int rows = size_px.y / side_px;
  const std::size_t count =
      std::min(flakes.pictures.size(), static_cast<std::size_t>(rows * per_row));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t chosen = i * flakes.pictures.size() / count;
    const auto at = static_cast<int>(i);
    place_flake(flakes.pictures[chosen].opacity, side_px * glm::ivec2(at % per_row, at / per_row),
                side_px, picture);
  }
  return picture;
}

}  // namespace wold::preview
