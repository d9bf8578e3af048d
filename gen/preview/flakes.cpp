#include "preview/flakes.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/parallel.h"
#include "expectation/cloud_view.h"

namespace wold::preview {
namespace {

using landscape::Flake;

/// A flake in the picture: its middle, the half sides that its rectangle has there, and how opaque
/// it is. What is smaller than a pixel is as much fainter instead.
struct Spot {
  glm::dvec3 middle;
  glm::dvec2 right;
  glm::dvec2 up;
  double opacity = 0.0;
};

glm::dvec2 at_least(const glm::dvec2& half_px, double& opacity) {
  constexpr double min_px = 0.6;
  const double length_px = glm::length(half_px);
  if (length_px >= min_px || length_px == 0.0) return half_px;
  opacity *= length_px / min_px;
  return half_px * (min_px / length_px);
}

Spot spot_of(const Flake& flake, const landscape::Perspective& perspective) {
  const glm::dvec3 centre_m(flake.centre_m);
  Spot spot{perspective.seen(centre_m), {}, {}, flake.opacity};
  const glm::dvec2 middle(spot.middle);
  spot.right = at_least(glm::dvec2(perspective.seen(centre_m + glm::dvec3(flake.right_m))) - middle,
                        spot.opacity);
  spot.up = at_least(glm::dvec2(perspective.seen(centre_m + glm::dvec3(flake.up_m))) - middle,
                     spot.opacity);
  return spot;
}

float opacity_at(const Image& picture, const glm::dvec2& place) {
  const glm::dvec2 at =
      (place * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(picture.width, picture.height);
  return *picture.pixel(std::clamp(static_cast<int>(at.x), 0, picture.width - 1),
                        std::clamp(static_cast<int>(at.y), 0, picture.height - 1));
}

void paint_spot(const Spot& spot, const Image& picture, const glm::vec3& radiance, Canvas& canvas) {
  const double area = spot.right.x * spot.up.y - spot.right.y * spot.up.x;
  if (std::abs(area) < 1e-9) return;
  const glm::dvec2 reach = glm::abs(spot.right) + glm::abs(spot.up);
  const glm::dvec2 low = glm::max(glm::floor(glm::dvec2(spot.middle) - reach), 0.0);
  const glm::dvec2 high = glm::min(glm::ceil(glm::dvec2(spot.middle) + reach),
                                   glm::dvec2(canvas.radiance.width, canvas.radiance.height));
  for (int y = static_cast<int>(low.y); y < high.y; ++y)
    for (int x = static_cast<int>(low.x); x < high.x; ++x) {
      const glm::dvec2 away = glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(spot.middle);
      const glm::dvec2 place = glm::dvec2(away.x * spot.up.y - away.y * spot.up.x,
                                          spot.right.x * away.y - spot.right.y * away.x) /
                               area;
      if (std::abs(place.x) > 1.0 || std::abs(place.y) > 1.0) continue;
      if (spot.middle.z >= canvas.depth_at(x, y)) continue;
      const float opacity = static_cast<float>(spot.opacity) * opacity_at(picture, place);
      float* pixel = canvas.radiance.pixel(x, y);
      for (int c = 0; c < 3; ++c) pixel[c] = std::lerp(pixel[c], radiance[c], opacity);
    }
}

}  // namespace

void paint_fog(const landscape::Fog& fog, const landscape::Perspective& perspective,
               Canvas& canvas) {
  for (int y = 0; y < canvas.radiance.height; ++y)
    for (int x = 0; x < canvas.radiance.width; ++x) {
      const double slant = perspective.depth_along(perspective.direction({x + 0.5, y + 0.5}));
      const auto left = static_cast<float>(
          math::exp(-fog.extinction_per_m * double{canvas.depth_at(x, y)} / slant));
      float* pixel = canvas.radiance.pixel(x, y);
      for (int c = 0; c < 3; ++c) pixel[c] = std::lerp(fog.radiance[c], pixel[c], left);
    }
}

void paint_haze(const std::vector<landscape::CloudBox>& clouds,
                const landscape::Perspective& perspective, Canvas& canvas) {
  const auto first = std::ranges::find(clouds, true, &landscape::CloudBox::is_haze);
  if (first == clouds.end()) return;
  parallel_for(static_cast<std::size_t>(canvas.radiance.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < canvas.radiance.width; ++x) {
      const glm::dvec3 direction = perspective.direction({x + 0.5, y + 0.5});
      const double end_m = double{canvas.depth_at(x, y)} / perspective.depth_along(direction);
      const landscape::AggregateAppearance look =
          expectation::cloud_view({first, clouds.end()}, perspective.eye_m(), direction, end_m)
              .look;
      float* pixel = canvas.radiance.pixel(x, y);
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<float>(look.radiance[c] + look.transmittance * double{pixel[c]});
    }
  });
}

void paint_flakes(const landscape::Flakes& flakes, const landscape::Perspective& perspective,
                  Canvas& canvas) {
  constexpr double nearest_m = 0.02;
  for (const Flake& flake : flakes.flakes) {
    const Spot spot = spot_of(flake, perspective);
    if (spot.middle.z < nearest_m) continue;
    const Image& picture = flakes.pictures[static_cast<std::size_t>(flake.picture)].opacity;
    paint_spot(spot, picture, flakes.radiance, canvas);
  }
}

}  // namespace wold::preview
