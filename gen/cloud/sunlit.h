#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "cloud/tiling.h"

namespace wold::cloud {

/// Of the ground beneath clouds, which sends light up again: meadows.
inline constexpr double ground_albedo = 0.2;

/// A sun lower than of this sine shines into clouds as if from there: its rays would be followed
/// for ever, and farther clouds only redden it.
inline constexpr double lowest_sun_sine = 0.15;

/// What scatters in a cloud: without absorption, grey.
struct Droplets {
  double extinction_per_m = 0.0;
  double asymmetry = 0.86;  ///< mean cosine of the scattering angle
};

/// Light that a cloud's base sends down, of the light that falls on its top: what two-stream
/// diffusion lets through, T = 1 / (1 + 3/4 (1 - g) tau) (Bohren 1987, Multiple scattering of light
/// and some of its observable consequences, American Journal of Physics 55:524), and of the rest
/// the fifth that the ground beneath sends up again.
double base_brightness(const Droplets& droplets, double optical_depth);

/// The optical depth of a base with that brightness.
double depth_of_brightness(const Droplets& droplets, double brightness);

/// The brightness of a cloud that is `factor` times as deep, from 0, as one of the brightness
/// given.
double brightness_of_less(double brightness, double factor);

/// The brightness at every pixel, in steps of 1/65535, with tau along the ray from a height above
/// the base, in [0, height_m.back()), to the sun: sunward edges are bright, and a cloud is darkest
/// on its far side. Where light diffuses over many pixels it is worked out on coarser ones and
/// interpolated. height_m: the top above the flat base by rank, on equal steps from 0 to 1.
/// sun_direction is a unit vector to a sun above the horizon; pixel_m > 0.
LayerMap sunlit(const LayerMap& ranks, const std::vector<float>& height_m, const Droplets& droplets,
                const glm::dvec3& sun_direction, double pixel_m, double from_m = 0.0);

}  // namespace wold::cloud
