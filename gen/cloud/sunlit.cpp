#include "cloud/sunlit.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace wold::cloud {
namespace {

constexpr double from_the_ground = 0.2;
constexpr int ray_steps = 16;
/// A sun near the horizon would be followed for ever; farther clouds only redden it.
constexpr double lowest_sine = 0.15;
/// Over this height a top is soft, so that steps of the ray do not show.
constexpr float soft_m = 30.0F;

int wrapped(int i, int period) {
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

/// A place on the ray to the sun, from the base up.
struct RayStep {
  glm::ivec2 away_px;
  float height_m;
  float length_m;  ///< of the ray that it stands for
};

/// Steps that grow with the distance, as what is near shades most.
std::vector<RayStep> ray_to_sun(double top_m, const glm::dvec3& sun_direction, double pixel_m) {
  const double sine = std::max(sun_direction.z, lowest_sine);
  const double length_m = top_m / sine;
  const glm::dvec2 level(sun_direction.x, sun_direction.y);
  const glm::dvec2 towards = glm::length(level) > 0.0 ? glm::normalize(level) : glm::dvec2(0.0);
  const double across = std::sqrt(1.0 - sine * sine);
  const auto share = [](double step) { return step * step / (ray_steps * ray_steps); };
  std::vector<RayStep> steps;
  for (int i = 0; i < ray_steps; ++i) {
    const double along_m = length_m * 0.5 * (share(i) + share(i + 1));
    steps.push_back({glm::ivec2(glm::round(towards * (across * along_m / pixel_m))),
                     static_cast<float>(along_m * sine),
                     static_cast<float>(length_m * (share(i + 1) - share(i)))});
  }
  return steps;
}

PeriodicMap<float> tops_of(const LayerMap& ranks, const std::vector<float>& height_m) {
  PeriodicMap<float> tops(ranks.width(), ranks.height());
  const std::size_t last = height_m.size() - 1;
  for (std::size_t i = 0; i < ranks.values().size(); ++i)
    tops.values()[i] = height_m[ranks.values()[i] * last / 65535];
  return tops;
}

/// Adds the length of the ray's step inside clouds, for a whole row.
void add_step(const PeriodicMap<float>& tops, int y, const RayStep& step,
              std::vector<float>& in_cloud_m) {
  const int width = tops.width();
  const float* row = tops.row(wrapped(y + step.away_px.y, tops.height()));
  const int start = wrapped(step.away_px.x, width);
  const auto add = [&](const float* top, float* end_of_sum, float* sum) {
    for (; sum != end_of_sum; ++sum, ++top) {
      const float soft = std::min(*top, soft_m) + 1e-6F;
      *sum += step.length_m * std::clamp((*top - step.height_m) / soft + 0.5F, 0.0F, 1.0F) *
              (*top > 0.0F ? 1.0F : 0.0F);
    }
  };
  float* sums = in_cloud_m.data();
  add(row + start, sums + (width - start), sums);
  add(row, sums + width, sums + (width - start));
}

double through_of(double brightness) {
  return (brightness - from_the_ground) / (1.0 - from_the_ground);
}

double brightness_of(double through) { return through + from_the_ground * (1.0 - through); }

}  // namespace

double base_brightness(const Droplets& droplets, double optical_depth) {
  return brightness_of(1.0 / (1.0 + 0.75 * (1.0 - droplets.asymmetry) * optical_depth));
}

double brightness_of_less(double brightness, double factor) {
  const double through = std::max(through_of(brightness), 1e-6);
  return brightness_of(1.0 / (1.0 + factor * (1.0 / through - 1.0)));
}

LayerMap sunlit(const LayerMap& ranks, const std::vector<float>& height_m, const Droplets& droplets,
                const glm::dvec3& sun_direction, double pixel_m) {
  const PeriodicMap<float> tops = tops_of(ranks, height_m);
  const std::vector<RayStep> steps = ray_to_sun(height_m.back(), sun_direction, pixel_m);
  LayerMap result(ranks.width(), ranks.height());
  parallel_for(static_cast<std::size_t>(ranks.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    std::vector<float> in_cloud_m(static_cast<std::size_t>(ranks.width()));
    for (const RayStep& step : steps) add_step(tops, y, step, in_cloud_m);
    for (int x = 0; x < ranks.width(); ++x) {
      const double depth =
          droplets.extinction_per_m * static_cast<double>(in_cloud_m[static_cast<std::size_t>(x)]);
      result.at(x, y) = static_cast<std::uint16_t>(65535.0 * base_brightness(droplets, depth));
    }
  });
  return result;
}

}  // namespace wold::cloud
