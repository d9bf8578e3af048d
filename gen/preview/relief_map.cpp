#include "preview/relief_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "preview/sheet.h"

namespace wold::preview {
namespace {

/// A terrain on the pixels of a map.
class Map {
 public:
  Map(const Heightfield& terrain, int width_px)
      : terrain_(terrain), pixel_m_(terrain.size_m() / width_px) {
    const auto [low, high] = std::ranges::minmax(terrain.values());
    lowest_m_ = low;
    highest_m_ = high;
  }

  double pixel_m() const { return pixel_m_; }
  glm::dvec2 pixel_of(const glm::dvec2& at_m) const {
    return {at_m.x / pixel_m_, (terrain_.size_m() - at_m.y) / pixel_m_};
  }
  glm::dvec2 place_m(const glm::dvec2& pixel) const {
    return {pixel.x * pixel_m_, terrain_.size_m() - pixel.y * pixel_m_};
  }
  double height_m(const glm::dvec2& at_m) const { return terrain_.sample(at_m.x, at_m.y); }
  /// Rise per metre, over two pixels.
  glm::dvec2 gradient(const glm::dvec2& at_m) const {
    const glm::dvec2 east(pixel_m_, 0.0), north(0.0, pixel_m_);
    return glm::dvec2(height_m(at_m + east) - height_m(at_m - east),
                      height_m(at_m + north) - height_m(at_m - north)) /
           (2.0 * pixel_m_);
  }
  /// From 0, the lowest, to 1, the highest place.
  double relative_height(double height_m) const {
    return (height_m - lowest_m_) / std::max(highest_m_ - lowest_m_, 1e-9);
  }
  double mean_slope() const {
    constexpr int places = 64;
    double sum = 0.0;
    for (int j = 0; j < places; ++j)
      for (int i = 0; i < places; ++i)
        sum += glm::length(gradient((glm::dvec2(i, j) + 0.5) * (terrain_.size_m() / places)));
    return sum / (places * places);
  }

 private:
  const Heightfield& terrain_;
  double pixel_m_;
  double lowest_m_, highest_m_;
};

/// Light on relief that is as much higher than it is: from the north-west, half-way up.
double shade(const glm::dvec2& gradient, double exaggeration) {
  const glm::dvec3 light = glm::normalize(glm::dvec3(-1.0, 1.0, 1.4));
  const glm::dvec3 up = glm::normalize(glm::dvec3(-exaggeration * gradient, 1.0));
  return std::max(glm::dot(up, light), 0.0) / light.z;
}

glm::dvec3 tint(double relative_height) {
  const glm::dvec3 valley(0.66, 0.75, 0.58), slope(0.87, 0.81, 0.65), summit(0.93, 0.90, 0.86);
  return relative_height < 0.5 ? glm::mix(valley, slope, 2.0 * relative_height)
                               : glm::mix(slope, summit, 2.0 * relative_height - 1.0);
}

/// How much of a pixel a contour line covers, in [0, 1].
double contour(double height_m, double slope, double interval_m, double pixel_m) {
  if (interval_m <= 0.0 || slope <= 0.0) return 0.0;
  const double lines = height_m / interval_m;
  const double nearest = std::round(lines);
  const double away_px = std::abs(lines - nearest) * interval_m / (slope * pixel_m);
  const bool is_strong = std::remainder(nearest, 5.0) == 0.0;
  return (is_strong ? 0.55 : 0.28) * std::clamp((is_strong ? 1.4 : 1.1) - away_px, 0.0, 1.0);
}

void mark_camera(const landscape::Camera& camera, const Map& map, double reach_m, Image& picture) {
  const glm::vec3 colour(0.85F, 0.2F, 0.05F);
  const glm::dvec2 eye_m(camera.eye_m), ahead = glm::dvec2(camera.target_m) - eye_m;
  const double azimuth = math::atan2(ahead.x, ahead.y);
  const auto place = [&](double turned_deg) {
    const double towards = azimuth + radians(turned_deg);
    return map.pixel_of(eye_m + reach_m * glm::dvec2(math::sin(towards), math::cos(towards)));
  };
  const glm::dvec2 eye = map.pixel_of(eye_m), left = place(-0.5 * camera.field_of_view_deg),
                   right = place(0.5 * camera.field_of_view_deg);
  draw_line(picture, eye, left, colour);
  draw_line(picture, eye, right, colour);
  draw_line(picture, left, right, colour);
  const glm::dvec2 across(3.0, 0.0), along(0.0, 3.0);
  draw_line(picture, eye - across, eye + across, colour);
  draw_line(picture, eye - along, eye + along, colour);
}

void draw_path(const std::vector<glm::dvec2>& path_m, const Map& map, Image& picture) {
  const glm::vec3 colour(0.45F, 0.25F, 0.1F);
  for (std::size_t k = 0; k + 1 < path_m.size(); ++k)
    draw_line(picture, map.pixel_of(path_m[k]), map.pixel_of(path_m[k + 1]), colour);
}

void label_corners(double size_m, Image& picture, const std::filesystem::path& font) {
  constexpr double in_km_m = 2000.0;
  const glm::vec3 ink(0.1F);
  const std::string size = size_m >= in_km_m ? fmt::format("{:.4g} km", size_m / 1000.0)
                                             : fmt::format("{:.4g} m", size_m);
  const int width = picture.width;
  const int end = width - 7 * static_cast<int>(size.size());
  write_label(picture, "0, 0", {{5, width - 6}, 11, ink}, font);
  write_label(picture, size, {{end, width - 6}, 11, ink}, font);
  write_label(picture, size, {{5, 14}, 11, ink}, font);
  write_label(picture, "N", {{width / 2, 15}, 12, ink, true}, font);
}

}  // namespace

double contour_interval_m(const Heightfield& terrain) {
  constexpr double fewest_lines = 8.0;
  const auto [low, high] = std::ranges::minmax(terrain.values());
  const double widest_m = (double{high} - double{low}) / fewest_lines;
  if (widest_m <= 0.0) return 0.0;
  const double ten = math::pow(10.0, std::floor(math::log10(widest_m)));
  for (const double times : {5.0, 2.0})
    if (times * ten <= widest_m) return times * ten;
  return ten;
}

Image relief_map(const Heightfield& terrain, const landscape::Camera& camera,
                 const std::vector<std::vector<glm::dvec2>>& paths_m, int width_px,
                 const std::filesystem::path& font) {
  const Map map(terrain, width_px);
  const double exaggeration = std::clamp(0.4 / std::max(map.mean_slope(), 1e-6), 0.7, 20.0);
  const double interval_m = contour_interval_m(terrain);
  Image picture(width_px, width_px, 3);
  parallel_for(static_cast<std::size_t>(width_px), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < width_px; ++x) {
      const glm::dvec2 at_m = map.place_m(glm::dvec2(x, y) + 0.5), gradient = map.gradient(at_m);
      const double height_m = map.height_m(at_m);
      const glm::dvec3 land = tint(map.relative_height(height_m)) *
                              std::clamp(0.35 + 0.65 * shade(gradient, exaggeration), 0.2, 1.12);
      const double line = contour(height_m, glm::length(gradient), interval_m, map.pixel_m());
      const glm::vec3 seen(glm::mix(glm::min(land, 1.0), glm::dvec3(0.35, 0.22, 0.1), line));
      std::copy_n(&seen.x, 3, picture.pixel(x, y));
    }
  });
  for (const std::vector<glm::dvec2>& path_m : paths_m) draw_path(path_m, map, picture);
  mark_camera(camera, map, 0.25 * terrain.size_m(), picture);
  label_corners(terrain.size_m(), picture, font);
  return picture;
}

}  // namespace wold::preview
