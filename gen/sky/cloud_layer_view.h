#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "cloud/clouds.h"
#include "cloud/look.h"
#include "cloud/scattering.h"
#include "light/daylight.h"
#include "sky/cloud_boxes.h"
#include "sky/cumulus_cells.h"

namespace wold::sky {

/// What a line of sight meets of one layer of clouds.
struct SeenClouds {
  float through = 1.0F;     ///< fraction of the light behind that comes through
  glm::vec3 sent{0.0F};     ///< radiance of the clouds
  double distance_m = 0.0;  ///< to them; 0 where there are none
};

/// A layer of clouds as an eye below it sees it: on a sphere around the earth, and, where clouds
/// are dense, with sides.
///
/// Where a line of sight meets the layer's flat base it lets through exp(-tau / mu), tau the
/// layer's vertical optical depth and mu the cosine between line of sight and vertical there. Bases
/// have what two-stream diffusion leaves of the light that falls on their tops (cloud/sunlit.h).
/// Where an eye makes out more than a layer's map has, the layer's detail is seen as well. From
/// there on lines of sight are followed through the heaps of the layer's relief
/// (cloud/cumulus_column.h), whose sides also have the light that falls on themselves. Sunlight
/// that is still in the forward peak goes its way (forward_through()), which makes edges near the
/// sun shine. A layer lit as [Wang2010] has it is as bright everywhere and has no sides.
class CloudLayerView {
 public:
  /// `day` has to outlive it; the layer is above the eye, which makes out angles of finest_rad.
  /// What of the layer stands as a volume in its window is left out.
  CloudLayerView(const cloud::LayerState& state, double pixel_m, const glm::dvec3& eye_m,
                 const light::Daylight& day, double finest_rad,
                 const std::optional<CloudWindow>& window);

  /// Along a unit direction above the horizon.
  SeenClouds along(const glm::dvec3& direction) const;

  /// Of the base over the eye.
  double rise_m() const { return rise_m_; }

 private:
  struct Ray;
  struct Lit;
  struct Passed;

  void add_base(Passed& passed, const Ray& ray) const;
  void add_sides(Passed& passed, const Ray& ray) const;
  Lit side_light(const glm::dvec3& place_m, double footprint_m) const;
  glm::dvec3 place_on(const Ray& ray, double height_fraction) const;
  int steps_along(const Ray& ray) const;
  double entry_between(const Ray& ray, double outside, double inside, double footprint_m) const;
  double crispness(const Ray& ray, double base_depth) const;
  double window_fraction(const glm::dvec2& place_m) const;
  glm::vec3 sent(const Passed& passed, const Ray& ray) const;

  const light::Daylight& day_;
  std::shared_ptr<const cloud::Layer> layer_;
  glm::dvec3 eye_m_;
  double finest_rad_;
  double rise_m_;
  double pixel_m_;
  glm::dvec2 way_m_;
  glm::vec3 colour_;                  ///< of the layer's light
  double seen_per_m_;                 ///< optical depth of its densest places, as columns are seen
  std::vector<cloud::Sheet> sheets_;  ///< its shapes
  std::optional<CumulusCells> cumulus_cells_;  ///< where it has relief
  std::optional<CloudWindow> window_;
};

}  // namespace wold::sky
