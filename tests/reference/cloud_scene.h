#pragma once

#include <array>
#include <glm/glm.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "cloud/lifting.h"
#include "landscape/landscape.h"
#include "light/daylight.h"
#include "scene/scene.h"

namespace wold::test {

// The cloud that light in clouds is held against: a heap of examples/cumulus.toml's kind, alone in
// the sky, 3.5 km to the north of an eye on the ground.

struct CloudSun {
  double elevation_deg;
  std::string side;    ///< of the sun, for the eye: "towards", "across" or "away"
  double azimuth_deg;  ///< clockwise from north
};

inline const std::vector<CloudSun>& cloud_suns() {
  static const std::vector<CloudSun> suns = [] {
    std::vector<CloudSun> all;
    for (const double elevation_deg : {3.0, 5.0, 20.0, 60.0})
      for (const auto& [side, azimuth_deg] :
           {std::pair("towards", 0.0), std::pair("across", 90.0), std::pair("away", 180.0)})
        all.push_back({elevation_deg, side, azimuth_deg});
    return all;
  }();
  return suns;
}

inline constexpr glm::ivec2 cloud_picture_px{48, 34};

inline landscape::Camera cloud_camera() {
  return {{3650.0, 1000.0, 2.0}, {3650.0, 4550.0, 1440.0}, 21.0};
}

inline scene::Scene cloud_scene(const CloudSun& sun) {
  scene::Scene scene;
  scene.seed = 7;
  scene.sun.azimuth_deg = sun.azimuth_deg;
  scene.sun.elevation_deg = sun.elevation_deg;
  scene.clouds.resize(1);
  scene.clouds[0].kind = scene::CloudKind::cumulus;
  scene.clouds[0].body = scene::CloudBody::volume;
  return scene;
}

/// The heap in the layer at the film's start, without its neighbours, in voxels as large as those
/// of frames.
inline cloud::CloudVolume cloud_volume() {
  const scene::Scene scene = cloud_scene(cloud_suns().front());
  const double pixel_m = cloud::Clouds::usual_pixel_m(scene.clouds);
  const cloud::CloudState state = cloud::Clouds(scene, pixel_m).at(0.0);
  constexpr double voxel_m = 7.8125;
  constexpr glm::ivec3 voxels{180, 180, 64};
  constexpr double radius_m = 0.5 * voxel_m * voxels.x;
  const glm::dvec2 middle_m(3650.0, 4550.0);
  cloud::CloudVolume volume = cloud::lifted(state.layers[0], pixel_m, middle_m - radius_m,
                                            glm::dvec2(2.0 * radius_m), voxels);
  for (std::size_t i = 0; i < volume.extinction_per_m.size(); ++i) {
    const glm::dvec2 voxel(i % voxels.x, i / voxels.x % voxels.y);
    const double away_m = glm::length((voxel + 0.5) * voxel_m - radius_m);
    const double left = 1.0 - glm::smoothstep(0.85 * radius_m, radius_m, away_m);
    volume.extinction_per_m[i] *= static_cast<float>(left);
  }
  return volume;
}

/// Height of the volume's middle above the sea.
inline constexpr double cloud_middle_m = 1450.0;

/// Radiance of the ground far below, a fifth of what falls on it.
inline constexpr float cloud_ground_radiance = 0.2F / std::numbers::pi_v<float>;

/// What is behind the cloud and shines on it beside the sun.
inline glm::vec3 cloud_surroundings(const light::Daylight& day, const glm::dvec3& direction) {
  return direction.z > 0.0 ? day.sky_radiance(direction) : glm::vec3(cloud_ground_radiance);
}

}  // namespace wold::test
