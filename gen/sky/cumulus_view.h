#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "cloud/clouds.h"
#include "cloud/heaps.h"
#include "cloud/look.h"
#include "cloud/scattering.h"
#include "cloud/volume.h"
#include "light/daylight.h"
#include "sky/cloud_boxes.h"
#include "sky/seen_clouds.h"

namespace wold::sky {

/// The heaps of a layer that has relief, as an eye below them sees them: as bodies of droplets that
/// are denser inward from their surface, from the base to the highest top, on a sphere around the
/// earth.
///
/// A line of sight gains transmittance * extinction * source * ds (Chandrasekhar 1960, Radiative
/// Transfer). The source has the terms of cloud/volume.h: sunlight near the forward peak by the
/// optical depth towards the sun, which makes thin edges shine before it; what is scattered out of
/// the peak, the sky's light and the ground's by two-stream diffusion. Near the place these optical
/// depths are summed through the heaps as they are seen, heads and all. Farther on they are those
/// of the layer's maps.
class CumulusView {
 public:
  /// The layer is above the eye, which makes out angles of finest_rad. What of the layer stands as
  /// a volume in its window is left out. `sheets`: the layer's at that moment. Throws
  /// std::bad_optional_access where the layer has no heads.
  CumulusView(const cloud::LayerState& state, std::vector<cloud::Sheet> sheets,
              const glm::dvec3& eye_m, const light::Daylight& day, double finest_rad,
              const std::optional<CloudWindow>& window);

  /// Along a unit direction above the horizon.
  SeenClouds along(const glm::dvec3& direction) const;

 private:
  struct Ray;
  struct Passed;

  Ray ray_along(const glm::dvec3& direction) const;
  int steps_along(const Ray& ray) const;
  glm::dvec3 place_on(const Ray& ray, double at_m) const;
  double field_on(const Ray& ray, double at_m, double step_m) const;
  void pass_step(const Ray& ray, double from_m, double to_m, Passed& passed) const;
  double first_step_m(const Ray& ray, const Passed& passed) const;
  void pass_heap(const Ray& ray, double from_m, double to_m, Passed& passed) const;
  double surface_between(const Ray& ray, double outside_m, double inside_m, double step_m) const;
  double extinction_per_m(const glm::dvec3& place_m, double footprint_m) const;
  double near_depth(const glm::dvec3& place_m, const glm::dvec3& direction, double reach_m) const;
  double depth_to_sun(const glm::dvec3& place_m) const;
  double depth_above(const glm::dvec3& place_m) const;
  glm::vec3 source(const glm::dvec3& place_m, const glm::dvec3& from_eye) const;

  std::shared_ptr<const cloud::Layer> layer_;
  cloud::CloudLight light_;
  glm::dvec3 to_sun_;  ///< as it shines into clouds
  double finest_rad_;
  glm::vec3 colour_;  ///< of the layer's light
  float alpha_;       ///< what [Wang2010]'s events leave of its opacity
  cloud::Heaps heaps_;
  cloud::ForwardTable forward_;  ///< forward_source() of its droplets
  std::optional<CloudWindow> window_;
};

}  // namespace wold::sky
