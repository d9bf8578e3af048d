#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "cloud/clouds.h"
#include "cloud/look.h"
#include "light/daylight.h"
#include "sky/cloud_boxes.h"
#include "sky/cumulus_view.h"
#include "sky/seen_clouds.h"

namespace wold::sky {

/// A layer of clouds as an eye below it sees it, on a sphere around the earth.
///
/// Heaps are bodies (CumulusView): layers with relief and with gaps between them. Another layer, a
/// veil or one that is closed and shows its base alone, is a sheet: a line of sight that meets it
/// lets through exp(-tau / mu), tau the layer's vertical optical depth and mu the cosine between
/// line of sight and vertical there. It has what two-stream diffusion leaves of the light that
/// falls on its top (cloud/sunlit.h). Sunlight that is still in the forward peak goes its way
/// (forward_through()), which makes edges near the sun shine. Where an eye makes out more than a
/// layer's map has, the layer's detail is seen as well. A layer lit as [Wang2010] has it is as
/// bright everywhere.
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
  struct Sheets;

  Sheets sheets_at(const glm::dvec2& place_m, double footprint_m) const;
  glm::vec3 sent(const Sheets& seen, double cosine, const glm::dvec3& direction) const;

  const light::Daylight& day_;
  std::shared_ptr<const cloud::Layer> layer_;
  glm::dvec3 eye_m_;
  double finest_rad_;
  double rise_m_;
  double pixel_m_;
  glm::dvec2 way_m_;
  glm::vec3 colour_;                    ///< of the layer's light
  glm::vec3 sun_irradiance_;            ///< of a plane up there that faces the sun
  std::vector<cloud::Sheet> sheets_;    ///< its shapes
  std::optional<CumulusView> cumulus_;  ///< of one with heaps
  std::optional<CloudWindow> window_;
};

}  // namespace wold::sky
