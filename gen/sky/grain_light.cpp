#include "sky/grain_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/interpolation.h"
#include "core/parallel.h"
#include "light/daylight.h"
#include "snow/blowing_snow.h"

namespace wold::sky {
namespace {

using std::numbers::pi;

/// Pictures of all directions, as Landscape::sky is one: what comes to the grains, and what they
/// make of it.
constexpr glm::ivec2 patches{96, 48}, directions{72, 36};

glm::dvec3 direction_at(const glm::dvec2& place, const glm::ivec2& size) {
  return light::direction_of(2.0 * pi * place.x / size.x, pi * (0.5 - place.y / size.y));
}

double solid_angle_sr(const glm::dvec3& direction) {
  const double cosine = std::sqrt(std::max(0.0, 1.0 - direction.z * direction.z));
  return 2.0 * pi * pi / (patches.x * patches.y) * cosine;
}

/// Mean of one of the patches of a picture.
glm::vec3 mean_of(const Image& picture, const glm::ivec2& patch) {
  const glm::ivec2 all(picture.width, picture.height), first = patch * all / patches;
  const glm::ivec2 last = glm::max((patch + 1) * all / patches, first + 1);
  glm::vec3 sum(0.0F);
  for (int r = first.y; r < last.y; ++r)
    for (int c = first.x; c < last.x; ++c) {
      const float* pixel = picture.pixel(c, r);
      sum += glm::vec3(pixel[0], pixel[1], pixel[2]);
    }
  return sum / static_cast<float>((last.x - first.x) * (last.y - first.y));
}

}  // namespace

struct GrainLight::Patch {
  glm::dvec3 direction;
  Surroundings light;  ///< radiance times solid angle
};

std::vector<GrainLight::Patch> GrainLight::sky_patches(const Image& sky, const glm::dvec3& to_sun) {
  constexpr double outer = 0.5, inner = 0.94;  // cosines: 60 and 20 degrees from the sun
  std::vector<Patch> list;
  for (int r = 0; r < patches.y / 2; ++r)
    for (int c = 0; c < patches.x; ++c) {
      const glm::dvec3 direction = direction_at({c + 0.5, r + 0.5}, patches);
      const glm::vec3 light = static_cast<float>(solid_angle_sr(direction)) * mean_of(sky, {c, r});
      const auto of_sun =
          static_cast<float>(glm::smoothstep(outer, inner, glm::dot(direction, to_sun)));
      list.push_back({direction, {of_sun * light, (1.0F - of_sun) * light}});
    }
  return list;
}

/// Ground that has the light of these patches of sky, and the sun's.
void GrainLight::add_ground(const landscape::Daylight& day, double albedo,
                            std::vector<Patch>& list) {
  Surroundings level{day.sun_irradiance * static_cast<float>(std::max(day.to_sun.z, 0.0)), {}};
  for (const Patch& patch : list) {
    level.of_sun += static_cast<float>(patch.direction.z) * patch.light.of_sun;
    level.of_sky += static_cast<float>(patch.direction.z) * patch.light.of_sky;
  }
  for (int r = patches.y / 2; r < patches.y; ++r)
    for (int c = 0; c < patches.x; ++c) {
      const glm::dvec3 direction = direction_at({c + 0.5, r + 0.5}, patches);
      const auto ground = static_cast<float>(solid_angle_sr(direction) * albedo / pi);
      list.push_back({direction, {ground * level.of_sun, ground * level.of_sky}});
    }
}

std::vector<GrainLight::Surroundings> GrainLight::scattered(const std::vector<Patch>& list) {
  std::vector<Surroundings> result(static_cast<std::size_t>(directions.x * directions.y));
  parallel_for(result.size(), [&](std::size_t i) {
    const auto index = static_cast<int>(i);
    const glm::dvec3 direction =
        direction_at({index % directions.x + 0.5, index / directions.x + 0.5}, directions);
    for (const Patch& patch : list) {
      const auto phase = static_cast<float>(
          cloud::henyey_greenstein(snow::grain_asymmetry, glm::dot(direction, patch.direction)));
      result[i].of_sun += phase * patch.light.of_sun;
      result[i].of_sky += phase * patch.light.of_sky;
    }
  });
  return result;
}

GrainLight::GrainLight(const landscape::Daylight& day, const Image& sky, double albedo,
                       const glm::dvec3& eye_m)
    : day_(day), eye_m_(eye_m), forward_(cloud::forward_source, snow::grain_asymmetry) {
  std::vector<Patch> list = sky_patches(sky, day.to_sun);
  add_ground(day, albedo, list);
  scattered_ = scattered(list);
}

GrainLight::Surroundings GrainLight::seen_along(const glm::dvec3& direction) const {
  const double turn = math::atan2(direction.x, direction.y) / (2.0 * pi);
  const double x = (turn - std::floor(turn)) * directions.x - 0.5;
  const double y = (0.5 - math::asin(std::clamp(direction.z, -1.0, 1.0)) / pi) * directions.y - 0.5;
  const int row = std::clamp(static_cast<int>(std::floor(y)), 0, directions.y - 2);
  const int column = static_cast<int>(std::floor(x));
  const auto at = [&](int i, int j) -> const Surroundings& {
    return scattered_[static_cast<std::size_t>(j * directions.x +
                                               (i + directions.x) % directions.x)];
  };
  const auto u = static_cast<float>(x - column);
  const auto v = static_cast<float>(std::clamp(y - row, 0.0, 1.0));
  const auto between = [&](glm::vec3 Surroundings::*part) {
    return bilinear(at(column, row).*part, at(column + 1, row).*part, at(column, row + 1).*part,
                    at(column + 1, row + 1).*part, u, v);
  };
  return {between(&Surroundings::of_sun), between(&Surroundings::of_sky)};
}

glm::vec3 GrainLight::radiance(const glm::dvec3& at_m, double depth, double lit) const {
  constexpr double flattest_sine = 0.1;  // layers end: the way through them is not endless
  constexpr double nearest_m = 1e-3;     // to the eye, from where any direction will do
  const double to_sun = depth / std::max(day_.to_sun.z, flattest_sine);
  const glm::dvec3 way_m = at_m - eye_m_;
  const double distance_m = glm::length(way_m);
  const glm::dvec3 direction = distance_m > nearest_m ? way_m / distance_m : day_.to_sun;
  const double forward = forward_.at(to_sun, glm::dot(day_.to_sun, direction));
  // Half of the light that has lost its way leaves the layer at once.
  const double even = 0.5 * (1.0 - math::exp(-to_sun)) / (4.0 * pi);
  // Of the sky's light about the sun goes on what has not turned aside.
  const double onward = math::exp(-(1.0 - snow::grain_asymmetry) * to_sun);
  const Surroundings around = seen_along(direction);
  return day_.sun_irradiance * static_cast<float>(lit * (forward + even)) + around.of_sky +
         around.of_sun * static_cast<float>(lit * onward);
}

}  // namespace wold::sky
