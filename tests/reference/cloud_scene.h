#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "cloud/volume.h"
#include "core/image.h"
#include "landscape/landscape.h"
#include "light/daylight.h"
#include "scene/scene.h"

namespace wold::test {

// The cloud that light in clouds is held against: a heap of cumulus, alone in the sky, 3.5 km to
// the north of an eye on the ground.

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
  scene.sun.azimuth_deg = sun.azimuth_deg;
  scene.sun.elevation_deg = sun.elevation_deg;
  return scene;
}

/// A heap as the product made them when the references were traced, without neighbours, in voxels
/// as large as those of frames: it stays so that light is held against paths through the same grid,
/// whatever shapes become. DIR/cloud_extinction.exr has its slices below each other, per metre.
inline cloud::CloudVolume cloud_volume(const std::filesystem::path& folder) {
  constexpr double voxel_m = 7.8125;
  constexpr glm::ivec3 voxels{180, 180, 64};
  return {{{2946.875, 3846.875, 1200.0}, glm::dvec3(voxel_m), voxels},
          read_image(folder / "cloud_extinction.exr").values,
          0.866};
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
