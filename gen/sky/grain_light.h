#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "cloud/scattering.h"
#include "core/image.h"
#include "landscape/landscape.h"

namespace wold::sky {

/// The light that blown snow grains send to an eye: the sun's, scattered any number of times near
/// its way, and that of sky and ground. Within 12 % of all orders of scattering in the sun,
/// within 26 % in the shade of a hill (docs/measurements.md).
class GrainLight {
 public:
  /// Sky by direction as Landscape::sky has it, and below the horizon ground of that albedo. `day`
  /// has to outlive it.
  GrainLight(const landscape::Daylight& day, const Image& sky, double albedo,
             const glm::dvec3& eye_m);

  /// Source radiance at a place, as CloudBox::radiance has it. `depth`: optical depth of the snow
  /// above it; `lit`: fraction of the sun's light that hills and clouds leave it.
  glm::vec3 radiance(const glm::dvec3& at_m, double depth, double lit) const;

 private:
  /// What is hidden where the sun is hidden, the sky about it with it, and what is not.
  struct Surroundings {
    glm::vec3 of_sun{0.0F}, of_sky{0.0F};
  };
  struct Patch;
  static std::vector<Patch> sky_patches(const Image& sky, const glm::dvec3& to_sun);
  static void add_ground(const landscape::Daylight& day, double albedo,
                         std::vector<Patch>& patches);
  static std::vector<Surroundings> scattered(const std::vector<Patch>& patches);
  Surroundings seen_along(const glm::dvec3& direction) const;

  const landscape::Daylight& day_;
  glm::dvec3 eye_m_;
  cloud::ForwardTable forward_;
  std::vector<Surroundings> scattered_;  ///< by the direction from the eye, row by row
};

}  // namespace wold::sky
