#include "sky/precipitation_medium.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/colour.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::sky {
namespace {

using std::numbers::pi;

/// From the ground to the middle of the clouds in which flakes grow.
constexpr double snow_column_m = 3000.0;

/// Irradiance of level ground under clouds that snow, in the daylight's unit: a camera opens and
/// leaves a little of the gloom.
constexpr double light_dimming = 0.95;

/// Clouds scatter all colours alike, but what reaches the ground through them is a little bluer
/// than sun and clear sky together.
constexpr glm::vec3 bluer(0.9592F, 0.9916F, 1.06F);

glm::vec3 overcast_irradiance(const light::Daylight& day) {
  const glm::vec3 colour = day.level_irradiance() * bluer;
  return colour * static_cast<float>(light_dimming / luminance(colour));
}

/// Radiance of CIE's overcast sky, (1 + 2 sine) / 3 of its zenith's, under which level ground has
/// the irradiance 1: at the zenith 9 / (7 pi), on average over directions 6 / (7 pi).
constexpr double zenith_per_irradiance = 9.0 / (7.0 * pi);
constexpr double mean_per_irradiance = 6.0 / (7.0 * pi);

/// A fraction of the backdrop this small and the fog before it is all that is seen.
constexpr double min_transmittance = 0.05;

}  // namespace

PrecipitationMedium::PrecipitationMedium(const light::Daylight& day, double extinction_per_m,
                                         double ground_albedo)
    : day_(day),
      optical_depth_(extinction_per_m * snow_column_m),
      irradiance_(overcast_irradiance(day)),
      radiance_(irradiance_ * static_cast<float>(0.5 * (mean_per_irradiance + ground_albedo / pi))),
      zenith_(irradiance_ * static_cast<float>(zenith_per_irradiance)) {}

double PrecipitationMedium::through(double sine) const {
  return math::exp(-optical_depth_ / std::max(sine, 0.02));
}

double PrecipitationMedium::sunlit_fraction() const { return through(day_.sun_direction().z); }

ColourMap PrecipitationMedium::light(const ColourMap& light, const FactorMap& overcast) const {
  const auto clear = static_cast<float>(sunlit_fraction());
  const glm::vec3 rest = irradiance_ * (1.0F - clear);
  ColourMap result = light;
  for (std::size_t i = 0; i < result.values().size(); ++i)
    result.values()[i] = result.values()[i] * clear + rest * overcast.values()[i];
  return result;
}

glm::vec3 PrecipitationMedium::sky_radiance(const glm::vec3& clear,
                                            const glm::dvec3& direction) const {
  const auto sine = static_cast<float>(std::max(direction.z, 0.0));
  const glm::vec3 overcast = glm::mix(radiance_, glm::max(zenith_, radiance_), sine);
  return glm::mix(overcast, clear, static_cast<float>(through(direction.z)));
}

namespace {

/// What has to stand behind the fog, whose share `transmittance` lets through, to be seen as
/// `wanted`.
glm::vec3 behind(const glm::vec3& wanted, const landscape::Fog& fog, double transmittance) {
  const auto t = static_cast<float>(std::max(transmittance, min_transmittance));
  return glm::max((wanted - fog.radiance * (1.0F - t)) / t, glm::vec3(0.0F));
}

void veil_sphere(const PrecipitationMedium& air, Image& sky) {
  for (int r = 0; r < sky.height; ++r)
    for (int c = 0; c < sky.width; ++c) {
      const glm::dvec3 direction = light::direction_of(2.0 * pi * (c + 0.5) / sky.width,
                                                       pi * (0.5 - (r + 0.5) / sky.height));
      float* pixel = sky.pixel(c, r);
      const glm::vec3 seen = air.sky_radiance({pixel[0], pixel[1], pixel[2]}, direction);
      std::copy_n(&seen.x, 3, pixel);
    }
}

void veil_backdrop(const PrecipitationMedium& air, const landscape::Fog& fog,
                   const glm::dvec3& eye_m, landscape::Backdrop& backdrop) {
  Image& picture = backdrop.picture;
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int r = static_cast<int>(row);
    for (int c = 0; c < picture.width; ++c) {
      const glm::dvec3 way_m = backdrop.corner_m + backdrop.right_m * ((c + 0.5) / picture.width) +
                               backdrop.up_m * (1.0 - (r + 0.5) / picture.height) - eye_m;
      const double distance_m = glm::length(way_m);
      float* pixel = picture.pixel(c, r);
      const glm::vec3 wanted = air.sky_radiance({pixel[0], pixel[1], pixel[2]}, way_m / distance_m);
      const glm::vec3 stands = behind(wanted, fog, math::exp(-fog.extinction_per_m * distance_m));
      std::copy_n(&stands.x, 3, pixel);
    }
  });
}

}  // namespace

void show_through(const PrecipitationMedium& air, const landscape::Fog& fog,
                  landscape::Landscape& landscape) {
  veil_sphere(air, landscape.sky);
  if (landscape.backdrop) veil_backdrop(air, fog, landscape.camera.eye_m, *landscape.backdrop);
}

}  // namespace wold::sky
