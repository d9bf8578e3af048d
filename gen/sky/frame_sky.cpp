#include "sky/frame_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/shadow.h"
#include "place/nearby_frames.h"
#include "scene/calendar.h"
#include "sky/cloud_boxes.h"

namespace wold::sky {
namespace {

constexpr int usual_sky_width_px = 1024;

/// The angle that clouds show details of, where the picture has pixels of that angle.
double finest_rad(const place::Site& site, double pixel_rad) {
  constexpr double usual_px = 0.5, sketched_px = 2.0;
  return (site.sketch ? sketched_px : usual_px) * pixel_rad;
}

double finest_of_sky_rad(const place::Site& site) {
  return finest_rad(site, 2.0 * std::numbers::pi / usual_sky_width_px);
}

/// How long the clouds drift between the moments over which a frame's shadows are the mean; 0 where
/// they are those of the frame's moment. The frames of a time lapse are so far apart that shadows
/// that drift by from frame to frame would make it flicker.
double shadow_step_s(const scene::Scene& scene, int frame) {
  constexpr double frames_apart = 2.0;
  return scene::is_time_lapse(scene, frame) && place::has_nearby_frames(scene, frame)
             ? frames_apart * scene::cloud_step_s(scene, frame)
             : 0.0;
}

/// Their own events have gathered them; in a season they are as many of these as its days have.
/// Those that have drifted there so much later may be asked for.
std::optional<cloud::CloudState> clouds_of(const scene::Scene& scene, const place::Site& site,
                                           int frame, double drifted_s = 0.0) {
  if (!site.clouds) return std::nullopt;
  cloud::CloudState clouds =
      site.clouds->at(scene::cloud_time_s(scene, frame) + drifted_s, site.day.sun_direction());
  if (site.season) {
    const double cover = place::mean_of_nearby(scene, frame, [&](int near) {
      return site.season->cloud_cover(scene::season_days(scene, near));
    });
    for (cloud::LayerState& layer : clouds.layers) layer.moment.amount *= cover;
  }
  return clouds;
}

/// A distance from the camera that no ground and no cloud reaches.
double beyond_everything_m(const landscape::Landscape& landscape) {
  double size_m = landscape.terrain.size_m() + 2.0 * std::abs(landscape.camera.eye_m.z) + 100.0;
  for (const landscape::CloudBox& box : landscape.clouds)
    size_m = std::max(size_m, box.voxels.x * box.voxel_m + box.corner_m.z);
  return 2.0 * size_m;
}

}  // namespace

FrameSky::FrameSky(const scene::Scene& scene, const place::Site& site, int frame,
                   const glm::dvec3& eye_m)
    : scene_(scene),
      site_(site),
      frame_(frame),
      clouds_(clouds_of(scene, site, frame)),
      sheets_(site.day, clouds_.value_or(cloud::CloudState{}), eye_m, finest_of_sky_rad(site)) {}

double FrameSky::openness() const {
  constexpr double sine = 0.5;  // of lines of sight well above the horizon
  constexpr double closed = 0.2, open = 0.4;
  return clouds_ ? glm::smoothstep(closed, open, cloud::mean_transmittance(*clouds_, sine)) : 1.0;
}

/// Fraction of the sunlight that passes the clouds. Where frames are far apart it is the mean over
/// what drifts by in as many steps as an eye sees frames in half a second.
FactorMap FrameSky::sunlit_fraction(const GroundGrid& grid) const {
  const auto at = [&](const cloud::CloudState& clouds) {
    return cloud::sunlit_fraction(clouds, site_.terrain, site_.day.sun_direction(), grid);
  };
  const double step_s = shadow_step_s(scene_, frame_);
  if (step_s == 0.0) return at(*clouds_);
  constexpr int moments = 12;
  FactorMap mean(grid.samples, grid.square, 0.0F);
  for (int moment = 0; moment < moments; ++moment) {
    const FactorMap fraction = at(*clouds_of(scene_, site_, frame_, moment * step_s));
    for (std::size_t i = 0; i < mean.values().size(); ++i)
      mean.values()[i] += fraction.values()[i] / moments;
  }
  return mean;
}

/// Steps of half a pixel of the clouds along the ray to the sun, where the ground rises by 45
/// degrees; finer ones show nothing more of their shadows.
GroundGrid FrameSky::shadow_grid(const ColourMap& light) const {
  const glm::dvec3 to_sun = site_.day.sun_direction();
  const double cotangent = glm::length(glm::dvec2(to_sun)) / std::max(to_sun.z, 1e-3);
  const double step_m = 0.5 * clouds_->pixel_m / (1.0 + cotangent);
  return {light.square(), std::clamp(map_samples(light.size_m(), step_m), 2, light.samples())};
}

ColourMap FrameSky::light(const terrain::GroundLight& clear) const {
  if (!clouds_) return clear.together();
  const bool sun_shines = std::ranges::any_of(
      clear.sun.values(), [](const glm::vec3& sun) { return sun != glm::vec3(0.0F); });
  ColourMap light =
      sun_shines ? product(clear.sun, sunlit_fraction(shadow_grid(clear.sun))) : clear.sun;
  const glm::vec3 sky_factor = sheets_.irradiance() / site_.day.sky_irradiance();
  for (std::size_t i = 0; i < light.values().size(); ++i)
    light.values()[i] += clear.sky.values()[i] * sky_factor;
  return light;
}

void FrameSky::show(landscape::Landscape& landscape, bool with_backdrop) const {
  if (!clouds_ && !with_backdrop) {
    landscape.sky = site_.day.sky_image(usual_sky_width_px);
    return;
  }
  landscape.sky =
      sky_picture(sheets_, site_.sketch ? site_.sketch->sky_width_px : usual_sky_width_px);
  const cloud::CloudState clouds = clouds_.value_or(cloud::CloudState{});
  const landscape::Camera& camera = landscape.camera;
  const auto windows = cloud_windows(clouds, camera);
  landscape.clouds = cloud_boxes(clouds, windows, site_.day, camera.eye_m);
  const double pixel_rad =
      glm::radians(camera.field_of_view_deg) / static_cast<double>(landscape.width_px);
  const CloudySky behind(site_.day, clouds, camera.eye_m, finest_rad(site_, pixel_rad), windows);
  landscape.backdrop = sky_backdrop(behind, camera, landscape.width_px, landscape.height_px,
                                    beyond_everything_m(landscape));
}

Image FrameSky::unlit(const landscape::Camera& camera) const {
  if (!clouds_) return site_.day.sunless_sky_image(usual_sky_width_px);
  const CloudySky behind(site_.day, *clouds_, camera.eye_m, finest_of_sky_rad(site_),
                         cloud_windows(*clouds_, camera));
  return sky_picture(behind, usual_sky_width_px);
}

}  // namespace wold::sky
