#include "ground/water_look.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/interpolation.h"
#include "core/random.h"
#include "ground/line_of_sight.h"

namespace wold::ground {
namespace {

using std::numbers::pi;

/// The longest and the shortest waves that are drawn, and how fast the middle ones run.
constexpr ScaleFreeNoise::Sizes wave_sizes = {.largest_m = 1.2, .smallest_m = 0.05};
constexpr double wave_speed_m_s = 1.0;

ScaleFreeNoise waves_of(std::uint64_t seed, const char* purpose, double step_m) {
  return {random_bits({seed, key_of("water"), 0, key_of(purpose)}), wave_sizes, /*hurst=*/0.3,
          step_m};
}

glm::dvec2 heading_of(const snow::WeatherMoment& wind) {
  const double rad = radians(wind.wind_heading_deg);
  return {math::sin(rad), math::cos(rad)};
}

light::SlopeVariance unseen(const light::SlopeVariance& all, double shown) {
  return {all.along * (1.0 - shown), all.across * (1.0 - shown)};
}

/// Gauss and Hermite's: slopes in standard deviations, and their weights; means over a normal
/// distribution are exact for polynomials up to the ninth degree.
constexpr std::array<double, 5> slopes = {-2.8569700138728, -1.3556261799743, 0.0, 1.3556261799743,
                                          2.8569700138728};
constexpr std::array<double, 5> weights = {0.0112574113277, 0.2220759220056, 0.5333333333333,
                                           0.2220759220056, 0.0112574113277};

/// A ray that facets mirror away from the eye.
struct Ray {
  glm::dvec3 direction;
  double rise;    ///< over distance, away from the eye
  double weight;  ///< of its facets, as the eye sees them
  double reflectance;
};

/// By facets that lean to and from the eye.
std::vector<Ray> mirrored_rays(const glm::dvec3& to_eye, const glm::dvec2& tilt,
                               const light::WaterFacets& facets) {
  constexpr double least_rise = 0.003;  // what goes down is mirrored up again
  const glm::dvec2 level(to_eye);
  const double length = glm::length(level);
  const glm::dvec2 towards = length > 1e-9 ? level / length : glm::dvec2(0.0, 1.0);
  const double deviation = facets.deviation(towards);
  std::vector<Ray> rays;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const glm::dvec2 slope = tilt + towards * (deviation * slopes[k]);
    const glm::dvec3 up = glm::normalize(glm::dvec3(-slope, 1.0));
    const double cosine = glm::dot(up, to_eye);
    if (cosine <= 0.0) continue;
    glm::dvec3 direction = 2.0 * cosine * up - to_eye;
    direction.z = std::max(direction.z, least_rise);
    direction = glm::normalize(direction);
    const double away = -glm::dot(glm::dvec2(direction), towards);
    rays.push_back({direction, direction.z / std::max(away, 1e-6), weights[k] * cosine / up.z,
                    light::water_reflectance(cosine)});
  }
  std::ranges::sort(rays, {}, &Ray::rise);
  return rays;
}

}  // namespace

Waves::Waves(const snow::WeatherMoment& wind, double time_s, std::uint64_t seed, double step_m)
    : heading_(heading_of(wind)),
      way_m_(heading_ * (wave_speed_m_s * time_s)),
      variance_(light::slope_variance(wind.wind_speed_m_s)),
      along_(waves_of(seed, "waves along the wind", step_m)),
      across_(waves_of(seed, "waves across the wind", step_m)),
      facets_(unseen(variance_, along_.shown()), heading_) {}

glm::dvec2 Waves::tilt(const glm::dvec2& at_m) const {
  if (along_.shown() <= 0.0) return glm::dvec2(0.0);
  const glm::dvec2 place_m = at_m - way_m_;
  const glm::dvec2 right(heading_.y, -heading_.x);
  return heading_ * (std::sqrt(variance_.along) * along_.at(place_m)) +
         right * (std::sqrt(variance_.across) * across_.at(place_m));
}

WaterSurface water_surface(const glm::dvec3& at_m, const glm::dvec3& eye_m, const Waves& waves,
                           const Mirrored& mirrored, const SunOnWater& sun) {
  const glm::dvec3 to_eye = glm::normalize(eye_m - at_m);
  if (to_eye.z <= 0.0) return {};
  const glm::dvec2 tilt = waves.tilt(glm::dvec2(at_m));
  const std::vector<Ray> rays = mirrored_rays(to_eye, tilt, waves.facets());
  std::vector<double> rises;
  for (const Ray& ray : rays) rises.push_back(ray.rise);
  const auto places = mirrored.land.met(at_m, rises);
  WaterSurface surface;
  double sum = 0.0;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto weight = static_cast<float>(rays[k].weight * rays[k].reflectance);
    surface.radiance +=
        weight * (places[k] ? mirrored.land_radiance(*places[k]) : mirrored.sky(rays[k].direction));
    surface.reflectance += weight;
    sum += rays[k].weight;
  }
  const auto scale = static_cast<float>(1.0 / std::max(sum, 1e-12));
  surface.radiance *= scale;
  surface.reflectance *= scale;
  const double glitter = waves.facets().glitter(to_eye, sun.to_sun, tilt);
  if (glitter > 0.0)
    surface.radiance += static_cast<float>(glitter) * sun.irradiance(glm::dvec2(at_m));
  return surface;
}

glm::vec3 sky_radiance(const Image& sky, const glm::dvec3& direction) {
  const double turn = math::atan2(direction.x, direction.y) / (2.0 * pi);
  const double x = (turn - std::floor(turn)) * sky.width - 0.5;
  const double y = (0.5 - math::asin(std::clamp(direction.z, -1.0, 1.0)) / pi) * sky.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto value = [&](int right, int below) {
    const int column = (static_cast<int>(left) + right + sky.width) % sky.width;
    const int row = std::clamp(static_cast<int>(top) + below, 0, sky.height - 1);
    const float* pixel = sky.pixel(column, row);
    return glm::vec3(pixel[0], pixel[1], pixel[2]);
  };
  return bilinear(value(0, 0), value(1, 0), value(0, 1), value(1, 1), static_cast<float>(x - left),
                  static_cast<float>(y - top));
}

}  // namespace wold::ground
