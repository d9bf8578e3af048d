#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "cloud/clouds.h"
#include "landscape/landscape.h"
#include "light/daylight.h"

namespace wold::sky {

/// Of the volume that a layer's box has, east, north and up.
inline constexpr glm::ivec3 cloud_box_voxels{512, 512, 64};

/// Where a layer of clouds is a volume: a square before the camera, from where it sees the layer
/// first. Beyond it, the layer is a sheet.
struct CloudWindow {
  glm::dvec2 south_west_m;
  double side_m;

  /// 1 inside, 0 outside, falling smoothly over a strip along the border: of the layer there that
  /// is volume.
  double fraction(const glm::dvec2& place_m) const;
};

/// The window of every layer of the state; none for those that are sheets or not above the eye.
/// Windows stand on multiples of a voxel, so that clouds do not swim when the camera moves.
std::vector<std::optional<CloudWindow>> cloud_windows(const cloud::CloudState& clouds,
                                                      const landscape::Camera& camera);

/// The volumes in those windows, lit for the camera's eye. Haze puts the sky's light before what is
/// far.
std::vector<landscape::CloudBox> cloud_boxes(const cloud::CloudState& clouds,
                                             const std::vector<std::optional<CloudWindow>>& windows,
                                             const light::Daylight& day, const glm::dvec3& eye_m);

}  // namespace wold::sky
