#include "snow/canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/segment.h"

namespace wold::snow {

Canvas::Canvas(int side_px)
    : side_(side_px * samples),
      values_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {}

template <class Opacity>
void Canvas::raise(const glm::dvec2& low, const glm::dvec2& high, const Opacity& opacity) {
  const double step = 2.0 / side_;
  const auto index = [&](double at) {
    return std::clamp(static_cast<int>(std::floor((at + 1.0) / step)), 0, side_ - 1);
  };
  for (int row = index(low.y); row <= index(high.y); ++row)
    for (int column = index(low.x); column <= index(high.x); ++column) {
      const glm::dvec2 at((column + 0.5) * step - 1.0, (row + 0.5) * step - 1.0);
      float& value = values_[static_cast<std::size_t>(row) * side_ + column];
      value = std::max(value, static_cast<float>(opacity(at)));
    }
}

void Canvas::stroke(const glm::dvec2& from, const glm::dvec2& to, double width, double end_width,
                    double opacity) {
  const glm::dvec2 a = placing_.turned * from + placing_.moved;
  const glm::dvec2 b = placing_.turned * to + placing_.moved;
  const double scale = std::sqrt(std::abs(glm::determinant(placing_.turned)));
  const double sample = 2.0 / side_;
  const double reach = 0.5 * scale * std::max(width, end_width) + sample;
  raise(glm::min(a, b) - reach, glm::max(a, b) + reach, [&](const glm::dvec2& at) {
    const double t = share_of_way(at, a, b);
    const double wanted = 0.5 * scale * std::lerp(width, end_width, t);
    const double half = std::max(wanted, sample);
    const double across = glm::distance(at, a + t * (b - a)) / half;
    constexpr double side_loss = 0.4;
    if (across >= 1.0) return 0.0;
    return opacity * wanted / half * (1.0 - side_loss * across * across);
  });
}

void Canvas::polygon(const std::vector<glm::dvec2>& corners, double opacity) {
  std::vector<glm::dvec2> placed;
  glm::dvec2 low(1.0);
  glm::dvec2 high(-1.0);
  for (const glm::dvec2& corner : corners) {
    placed.push_back(placing_.turned * corner + placing_.moved);
    low = glm::min(low, placed.back());
    high = glm::max(high, placed.back());
  }
  const double side = glm::determinant(placing_.turned) < 0.0 ? -1.0 : 1.0;
  raise(low, high, [&](const glm::dvec2& at) {
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const glm::dvec2 edge = placed[(i + 1) % placed.size()] - placed[i];
      const glm::dvec2 away = at - placed[i];
      if (side * (edge.x * away.y - edge.y * away.x) < 0.0) return 0.0;
    }
    return opacity;
  });
}

void Canvas::lay_over(const Canvas& other) {
  for (std::size_t i = 0; i < values_.size(); ++i)
    values_[i] += (1.0F - values_[i]) * other.values_[i];
}

Image Canvas::picture() const {
  const int side_px = side_ / samples;
  Image image(side_px, side_px, 1);
  for (int y = 1; y < side_px - 1; ++y)
    for (int x = 1; x < side_px - 1; ++x) {
      float sum = 0.0F;
      for (int row = y * samples; row < (y + 1) * samples; ++row)
        for (int column = x * samples; column < (x + 1) * samples; ++column)
          sum += values_[static_cast<std::size_t>(side_ - 1 - row) * side_ + column];
      *image.pixel(x, y) = std::clamp(sum / (samples * samples), 0.0F, 1.0F);
    }
  return image;
}

}  // namespace wold::snow
