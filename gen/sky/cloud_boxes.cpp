#include "sky/cloud_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "cloud/lifting.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "sky/cloud_haze.h"

namespace wold::sky {
namespace {

/// Along a window's border over which the volume gives way to what lies beyond, of the side.
constexpr double strip = 0.12;

/// Optical depth across a voxel, at most: a ray's samples lie some two voxels apart, and would show
/// as stripes in what is denser. The light is that of the droplets' own extinction.
constexpr double deepest_voxel = 1.0;

double voxel_m(const cloud::Layer& layer) { return layer.thickness_m / cloud_box_voxels.z; }

/// How far away on the level the view meets what is rise_m above the eye: it looks up at most half
/// its field above its middle.
double nearest_seen_m(const landscape::Camera& camera, double middle_rad, double rise_m) {
  constexpr double flattest_rad = 0.1;
  const double highest_rad = middle_rad + 0.5 * glm::radians(camera.field_of_view_deg);
  if (highest_rad >= 0.5 * std::numbers::pi) return 0.0;
  return rise_m * math::tan(0.5 * std::numbers::pi - std::max(highest_rad, flattest_rad));
}

/// From where the camera sees the layer first, but for the strip along the border.
CloudWindow window_before(const landscape::Camera& camera, const cloud::Layer& layer) {
  const double step_m = voxel_m(layer), side_m = cloud_box_voxels.x * step_m;
  const glm::dvec3 forward = glm::normalize(camera.target_m - camera.eye_m);
  const glm::dvec2 level(forward);
  const double across = glm::length(level);
  const double first_m =
      nearest_seen_m(camera, math::asin(forward.z), layer.base_m - camera.eye_m.z);
  const double middle_m = std::min(first_m + (0.5 - strip) * side_m, 1.5 * side_m);
  const glm::dvec2 centre_m =
      glm::dvec2(camera.eye_m) + (across > 0.0 ? level / across * middle_m : glm::dvec2(0.0));
  return {glm::round((centre_m - 0.5 * side_m) / step_m) * step_m, side_m};
}

/// Every voxel with cloud: visit(index, centre in metres).
template <class Visit>
void each_filled(const cloud::CloudVolume& volume, const Visit& visit) {
  const cloud::VoxelBox& box = volume.box;
  const auto width = static_cast<std::size_t>(box.voxels.x);
  const auto depth = static_cast<std::size_t>(box.voxels.y);
  parallel_for(depth * static_cast<std::size_t>(box.voxels.z), [&](std::size_t row) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t i = row * width + x;
      if (volume.extinction_per_m[i] <= 0.0F) continue;
      const glm::dvec3 at(x, row % depth, row / depth);
      visit(i, box.corner_m + (at + 0.5) * box.voxel_m);
    }
  });
}

landscape::CloudBox cloud_box(const cloud::LayerState& state, double pixel_m,
                              const CloudWindow& window, const light::Daylight& day,
                              const glm::dvec3& eye_m) {
  cloud::CloudVolume volume = cloud::lifted(state, pixel_m, window.south_west_m,
                                            glm::dvec2(window.side_m), cloud_box_voxels);
  std::vector<glm::vec3> source =
      cloud::source_radiance(volume, cloud::cloud_light(day, cloud::middle_m(*state.layer), eye_m));
  const glm::vec3 colour(state.moment.light);
  const auto densest_per_m = static_cast<float>(deepest_voxel / volume.box.voxel_m.z);
  each_filled(volume, [&](std::size_t i, const glm::dvec3& centre_m) {
    const glm::dvec3 way_m = centre_m - eye_m;
    const double distance_m = glm::length(way_m);
    const double clear = clear_fraction(distance_m, std::max(way_m.z, 1.0), day.visual_range_m());
    source[i] = glm::mix(day.sky_radiance(way_m / distance_m), source[i] * colour,
                         static_cast<float>(clear));
    volume.extinction_per_m[i] = std::min(volume.extinction_per_m[i], densest_per_m) *
                                 static_cast<float>(window.fraction(glm::dvec2(centre_m)));
  });
  return {{},
          volume.box.voxels,
          volume.box.voxel_m.z,
          volume.box.corner_m,
          std::move(volume.extinction_per_m),
          std::move(source),
          volume.asymmetry};
}

}  // namespace

double CloudWindow::fraction(const glm::dvec2& place_m) const {
  const glm::dvec2 at = (place_m - south_west_m) / side_m;
  const glm::dvec2 inside = glm::min(at, 1.0 - at);
  return glm::smoothstep(0.0, strip, std::min(inside.x, inside.y));
}

std::vector<std::optional<CloudWindow>> cloud_windows(const cloud::CloudState& clouds,
                                                      const landscape::Camera& camera) {
  std::vector<std::optional<CloudWindow>> windows;
  for (const cloud::LayerState& state : clouds.layers) {
    const bool stands = state.layer->is_volume && state.layer->base_m > camera.eye_m.z;
    windows.push_back(stands ? std::optional(window_before(camera, *state.layer)) : std::nullopt);
  }
  return windows;
}

std::vector<landscape::CloudBox> cloud_boxes(const cloud::CloudState& clouds,
                                             const std::vector<std::optional<CloudWindow>>& windows,
                                             const light::Daylight& day, const glm::dvec3& eye_m) {
  std::vector<landscape::CloudBox> boxes;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (!windows[i]) continue;
    boxes.push_back(cloud_box(clouds.layers[i], clouds.pixel_m, *windows[i], day, eye_m));
    boxes.back().name = fmt::format("cloud_{}", boxes.size());
  }
  return boxes;
}

}  // namespace wold::sky
