#include "expectation/bare_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/elementary.h"
#include "core/interpolation.h"

namespace wold::expectation {
namespace {

/// Bilinear value at a place in pixels from the upper left corner; `around`: columns repeat.
glm::vec3 sampled(const Image& image, double x, double y, bool around) {
  const double fx = x - 0.5;
  const double fy = std::clamp(y - 0.5, 0.0, image.height - 1.0);
  const auto i = static_cast<int>(std::floor(fx));
  const int j = std::min(static_cast<int>(fy), std::max(0, image.height - 2));
  const auto u = static_cast<float>(fx - i);
  const auto v = static_cast<float>(fy - j);
  const auto at = [&](int column, int row) {
    const int inside = around ? (column % image.width + image.width) % image.width
                              : std::clamp(column, 0, image.width - 1);
    const float* pixel = image.pixel(inside, std::min(row, image.height - 1));
    return glm::vec3(pixel[0], pixel[1], pixel[2]);
  };
  return bilinear(at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), u, v);
}

glm::vec3 sky_radiance(const Image& sky, const glm::dvec3& direction) {
  const double azimuth = math::atan2(direction.x, direction.y) / (2.0 * std::numbers::pi);
  const double elevation = math::asin(std::clamp(direction.z, -1.0, 1.0)) / std::numbers::pi;
  return sampled(sky, (azimuth - std::floor(azimuth)) * sky.width, (0.5 - elevation) * sky.height,
                 /*around=*/true);
}

/// Where the ray meets the backdrop; nothing beside it.
std::optional<Hit> backdrop_hit(const landscape::Backdrop& backdrop, const glm::dvec3& eye_m,
                                const glm::dvec3& direction) {
  const glm::dvec3 normal = glm::cross(backdrop.right_m, backdrop.up_m);
  const double along = glm::dot(direction, normal);
  const double distance_m = glm::dot(backdrop.corner_m - eye_m, normal) / along;
  if (along == 0.0 || distance_m <= 0.0) return std::nullopt;
  const glm::dvec3 place = eye_m + distance_m * direction - backdrop.corner_m;
  const double u = glm::dot(place, backdrop.right_m) / glm::dot(backdrop.right_m, backdrop.right_m);
  const double v = glm::dot(place, backdrop.up_m) / glm::dot(backdrop.up_m, backdrop.up_m);
  if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) return std::nullopt;
  const Image& picture = backdrop.picture;
  return Hit{sampled(picture, u * picture.width, (1.0 - v) * picture.height, /*around=*/false),
             distance_m};
}

Hit behind_everything(const landscape::Landscape& landscape, const glm::dvec3& eye_m,
                      const glm::dvec3& direction) {
  if (landscape.backdrop)
    if (const auto hit = backdrop_hit(*landscape.backdrop, eye_m, direction)) return *hit;
  return {sky_radiance(landscape.sky, direction)};
}

/// The ground's radiance: of each finer picture inside its square, with soft borders.
glm::vec3 ground_radiance(const landscape::Landscape& landscape, const glm::dvec2& at_m) {
  glm::vec3 seen = landscape.ground.sample(at_m.x, at_m.y);
  const ColourMap* coarser = &landscape.ground;
  for (const landscape::GroundDetail& detail : landscape.ground_details) {
    const glm::dvec2 inside = at_m - detail.corner_m;
    const glm::dvec2 from_edge = glm::min(inside, detail.map.size_m() - inside);
    const double fraction =
        std::min(from_edge.x, from_edge.y) / landscape::soft_border_m(*coarser, detail);
    coarser = &detail.map;
    if (fraction > 0.0)
      seen = glm::mix(seen, detail.map.sample(inside.x, inside.y),
                      static_cast<float>(std::min(fraction, 1.0)));
  }
  return seen;
}

}  // namespace

Hit bare_view(const landscape::Landscape& landscape, const glm::dvec3& eye_m,
              const glm::dvec3& direction, double ground_m) {
  if (!std::isfinite(ground_m)) return behind_everything(landscape, eye_m, direction);
  return {ground_radiance(landscape, glm::dvec2(eye_m + ground_m * direction)), ground_m};
}

}  // namespace wold::expectation
