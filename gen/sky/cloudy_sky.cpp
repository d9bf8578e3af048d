#include "sky/cloudy_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/pinhole.h"
#include "sky/cloud_haze.h"

namespace wold::sky {
namespace {

using std::numbers::pi;

/// Whether an eye might see that.
bool differ(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 difference = glm::abs(a - b), sum = a + b;
  return std::max({difference.r, difference.g, difference.b}) >
         0.01F * std::max({sum.r, sum.g, sum.b});
}

}  // namespace

CloudySky::CloudySky(const light::Daylight& day, const cloud::CloudState& clouds,
                     const glm::dvec3& eye_m, double finest_rad,
                     const std::vector<std::optional<CloudWindow>>& windows)
    : day_(day) {
  for (std::size_t i = 0; i < clouds.layers.size(); ++i) {
    const cloud::LayerState& state = clouds.layers[i];
    if (state.layer->base_m <= eye_m.z) continue;
    layers_.emplace_back(state, clouds.pixel_m, eye_m, day, finest_rad,
                         windows.empty() ? std::nullopt : windows[i]);
  }
}

glm::vec3 CloudySky::radiance(const glm::dvec3& direction) const {
  return clouded(day_.seen_radiance(direction), day_.sky_radiance(direction), direction);
}

glm::vec3 CloudySky::irradiance() const {
  constexpr int rings = 24;
  constexpr int azimuths = 48;
  glm::dvec3 sum(0.0);
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < azimuths; ++a) {
      // Rings of equal sin^2: each direction lights level ground alike.
      const double elevation = math::asin(std::sqrt((r + 0.5) / rings));
      const glm::dvec3 direction = light::direction_of(2.0 * pi * (a + 0.5) / azimuths, elevation);
      const glm::vec3 clear = day_.sky_radiance(direction);
      sum += glm::dvec3(clouded(clear, clear, direction));
    }
  return glm::vec3(sum * (pi / (rings * azimuths)));
}

/// What is seen of the layers before the clear sky. Haze before them has the light that all of the
/// air there has, the clear sky's without the sun's glare.
glm::vec3 CloudySky::clouded(glm::vec3 behind, const glm::vec3& haze,
                             const glm::dvec3& direction) const {
  if (direction.z <= 0.0) return behind;
  for (const CloudLayerView& layer : layers_) {
    const SeenClouds seen = layer.along(direction);
    if (seen.distance_m <= 0.0) continue;
    const auto clear =
        static_cast<float>(clear_fraction(seen.distance_m, layer.rise_m(), day_.visual_range_m()));
    behind = behind * seen.through + glm::mix(haze * (1.0F - seen.through), seen.sent, clear);
  }
  return behind;
}

void CloudySky::paint(Image& picture, const DirectionOf& direction) const {
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      const glm::dvec3 middle = direction(glm::dvec2(x + 0.5, y + 0.5));
      const glm::vec3 clear = day_.seen_radiance(middle), haze = day_.sky_radiance(middle);
      const auto seen = [&](double right, double down) {
        return clouded(clear, haze, direction(glm::dvec2(x + right, y + down)));
      };
      const glm::vec3 first = seen(0.25, 0.25), second = seen(0.75, 0.75);
      glm::vec3 mean = 0.5F * (first + second);
      if (differ(first, second)) mean = 0.5F * mean + 0.25F * (seen(0.75, 0.25) + seen(0.25, 0.75));
      std::copy_n(&mean.x, 3, picture.pixel(x, y));
    }
  });
}

Image sky_picture(const CloudySky& sky, int width_px) {
  Image picture(width_px, width_px / 2, 3);
  sky.paint(picture, [&](const glm::dvec2& at) {
    return light::direction_of(2.0 * pi * at.x / picture.width, pi * (0.5 - at.y / picture.height));
  });
  return picture;
}

landscape::Backdrop sky_backdrop(const CloudySky& sky, const landscape::Camera& camera,
                                 int width_px, int height_px, double distance_m) {
  constexpr double margin = 1.06;
  const CameraAxes axes(camera.eye_m, camera.target_m);
  const double width_m = 2.0 * distance_m * margin * half_width(camera.field_of_view_deg);
  landscape::Backdrop backdrop;
  backdrop.picture = Image(static_cast<int>(std::ceil(width_px * margin)),
                           static_cast<int>(std::ceil(height_px * margin)), 3);
  const Image& picture = backdrop.picture;
  backdrop.right_m = axes.right * width_m;
  backdrop.up_m = axes.up * (width_m * picture.height / picture.width);
  backdrop.corner_m =
      camera.eye_m + axes.forward * distance_m - (backdrop.right_m + backdrop.up_m) / 2.0;
  sky.paint(backdrop.picture, [&](const glm::dvec2& at) {
    const glm::dvec3 place_m = backdrop.corner_m + backdrop.right_m * (at.x / picture.width) +
                               backdrop.up_m * (1.0 - at.y / picture.height);
    return glm::normalize(place_m - camera.eye_m);
  });
  return backdrop;
}

}  // namespace wold::sky
