#include "cloud/sunlit.h"

#include <algorithm>
#include <cmath>

#include "cloud/box_filter.h"
#include "core/parallel.h"

namespace wold::cloud {
namespace {

constexpr int max_ray_steps = 32;

/// A part of the ray to the sun.
struct RayStep {
  glm::ivec2 away_px;  ///< of its middle
  float low_m;         ///< its lower end, above the base
  float rise_m;
  float length_m;
};

/// Steps that grow with the distance, as what is near shades most.
std::vector<RayStep> ray_to_sun(double low_m, double top_m, const glm::dvec3& sun_direction,
                                double pixel_m) {
  const double sine = std::max(sun_direction.z, lowest_sun_sine);
  const double length_m = (top_m - low_m) / sine;
  const int ray_steps = static_cast<int>(std::ceil(max_ray_steps * (1.0 - low_m / top_m)));
  const glm::dvec2 level(sun_direction.x, sun_direction.y);
  const glm::dvec2 towards = glm::length(level) > 0.0 ? glm::normalize(level) : glm::dvec2(0.0);
  const double across = std::sqrt(1.0 - sine * sine);
  // From a third of the mean length to five thirds of it.
  const auto fraction = [&](double step) {
    const double x = step / ray_steps;
    return x * (1.0 + 2.0 * x) / 3.0;
  };
  std::vector<RayStep> steps;
  for (int i = 0; i < ray_steps; ++i) {
    const double from_m = length_m * fraction(i), to_m = length_m * fraction(i + 1);
    const double away_m = across * 0.5 * (from_m + to_m);
    steps.push_back({glm::ivec2(glm::round(towards * (away_m / pixel_m))),
                     static_cast<float>(low_m + from_m * sine),
                     static_cast<float>((to_m - from_m) * sine),
                     static_cast<float>(to_m - from_m)});
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
void add_step(const PeriodicMap<float>& tops, int y, const RayStep& step, float* in_cloud_m) {
  const int width = tops.width();
  const float* row = tops.row(wrapped_index(y + step.away_px.y, tops.height()));
  const int start = wrapped_index(step.away_px.x, width);
  const auto add = [&](const float* top, float* end_of_sum, float* sum) {
    const float per_rise = 1.0F / step.rise_m;
    for (; sum != end_of_sum; ++sum, ++top)
      *sum += step.length_m * std::clamp((*top - step.low_m) * per_rise, 0.0F, 1.0F);
  };
  add(row + start, in_cloud_m + (width - start), in_cloud_m);
  add(row, in_cloud_m + width, in_cloud_m + (width - start));
}

/// Light walks at random before it has lost its direction: over the transport mean free path, here
/// the base of the kernel.
double diffusion_radius_m(const Droplets& droplets) {
  return 0.25 / (droplets.extinction_per_m * (1.0 - droplets.asymmetry));
}

PeriodicMap<float> diffused(const PeriodicMap<float>& in_cloud_m, double radius_px) {
  const int radius = static_cast<int>(radius_px);
  return box_filtered(box_filtered(in_cloud_m, radius), radius);
}

/// Means of 2 x 2 pixels; sides are even.
PeriodicMap<float> halved(const PeriodicMap<float>& map) {
  PeriodicMap<float> half(map.width() / 2, map.height() / 2);
  parallel_for(static_cast<std::size_t>(half.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    const float *low = map.row(2 * y), *high = map.row(2 * y + 1);
    for (int x = 0; x < half.width(); ++x)
      half.at(x, y) = 0.25F * (low[2 * x] + low[2 * x + 1] + high[2 * x] + high[2 * x + 1]);
  });
  return half;
}

/// Lengths of the rays to the sun inside clouds with these tops.
PeriodicMap<float> lengths_in_cloud_m(const PeriodicMap<float>& tops,
                                      const std::vector<RayStep>& steps) {
  PeriodicMap<float> in_cloud_m(tops.width(), tops.height());
  parallel_for(static_cast<std::size_t>(tops.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (const RayStep& step : steps) add_step(tops, y, step, in_cloud_m.row(y));
  });
  return in_cloud_m;
}

double through_of(double brightness) {
  return (brightness - ground_albedo) / (1.0 - ground_albedo);
}

double brightness_of(double through) { return through + ground_albedo * (1.0 - through); }

}  // namespace

double base_brightness(const Droplets& droplets, double optical_depth) {
  return brightness_of(1.0 / (1.0 + 0.75 * (1.0 - droplets.asymmetry) * optical_depth));
}

double depth_of_brightness(const Droplets& droplets, double brightness) {
  const double through = std::clamp(through_of(brightness), 1e-6, 1.0);
  return (1.0 / through - 1.0) / (0.75 * (1.0 - droplets.asymmetry));
}

double brightness_of_less(double brightness, double factor) {
  const double through = std::max(through_of(brightness), 1e-6);
  return brightness_of(1.0 / (1.0 + factor * (1.0 / through - 1.0)));
}

LayerMap sunlit(const LayerMap& ranks, const std::vector<float>& height_m, const Droplets& droplets,
                const glm::dvec3& sun_direction, double pixel_m, double from_m) {
  // Where light diffuses over many pixels, coarser ones show the same.
  constexpr double enough_px = 2.0;
  PeriodicMap<float> tops = tops_of(ranks, height_m);
  double radius_px = std::min(diffusion_radius_m(droplets) / pixel_m,
                              0.25 * std::min(ranks.width(), ranks.height()));
  while (radius_px >= 2.0 * enough_px && tops.width() % 2 == 0 && tops.height() % 2 == 0) {
    tops = halved(tops);
    radius_px /= 2.0;
    pixel_m *= 2.0;
  }
  PeriodicMap<float> brightness = diffused(
      lengths_in_cloud_m(tops, ray_to_sun(from_m, height_m.back(), sun_direction, pixel_m)),
      radius_px);
  parallel_for_blocks(brightness.values().size(), [&](std::size_t i) {
    float& value = brightness.values()[i];
    value = static_cast<float>(
        base_brightness(droplets, droplets.extinction_per_m * static_cast<double>(value)));
  });
  LayerMap result(ranks.width(), ranks.height());
  parallel_for(static_cast<std::size_t>(result.height()), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < result.width(); ++x)
      result.at(x, y) = static_cast<std::uint16_t>(
          65535.0 * brightness.sample((x + 0.5) / result.width(), (y + 0.5) / result.height()));
  });
  return result;
}

}  // namespace wold::cloud
