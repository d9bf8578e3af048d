#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "cloud/clouds.h"
#include "cloud/look.h"
#include "cloud/scattering.h"
#include "core/image.h"
#include "landscape/cloud_boxes.h"
#include "landscape/landscape.h"
#include "light/daylight.h"

namespace wold::landscape {

/// The sky as one eye sees it: the clear sky behind sheets of cloud, which are curved like the
/// Earth and sink into the haze with their distance.
///
/// A sheet lets through exp(-tau / mu), tau its vertical optical depth and mu the cosine between
/// line of sight and vertical there. It sends what two-stream diffusion leaves of the daylight
/// (cloud/sunlit.h); of sunlight what is still in the forward peak goes its way
/// (forward_through()), which makes edges near the sun shine. Where an eye makes out more than a
/// layer's map has, the layer's detail is seen as well: what it adds to the field changes opacity
/// and shade.
class CloudySky {
 public:
  /// `day` has to outlive it. Layers that are not above the eye are left out, and what of a layer
  /// stands as a volume in its window; no windows at all: nothing does.
  CloudySky(const light::Daylight& day, const cloud::CloudState& clouds, const glm::dvec3& eye_m,
            const std::vector<std::optional<CloudWindow>>& windows = {});

  /// Radiance from a unit direction.
  glm::vec3 radiance(const glm::dvec3& direction) const;

  /// The unit direction that a place in a picture looks to, in pixels from its upper left corner.
  using DirectionOf = std::function<glm::dvec3(const glm::dvec2&)>;

  /// Radiance, the mean over samples x samples places of each pixel. Clouds have edges; the clear
  /// sky behind them counts as the same all over a pixel.
  void paint(Image& picture, int samples, const DirectionOf& direction) const;

  /// Irradiance by the whole sky, without the sun's disc, on level ground.
  glm::vec3 irradiance() const;

 private:
  struct Layer {
    std::shared_ptr<const cloud::Layer> made;
    glm::dvec2 way_m;
    std::vector<cloud::Sheet> sheets;  ///< the further one first
    double rise_m;                     ///< of its base over the eye
    glm::vec3 light_colour;
    cloud::ForwardTable forward;  ///< forward_through()
    std::optional<CloudWindow> window;
  };
  struct Meeting;
  struct Passed;

  glm::vec3 clouded(glm::vec3 behind, const glm::vec3& haze, const glm::dvec3& direction) const;
  glm::vec3 before(const glm::vec3& behind, const glm::vec3& haze, const Layer& layer,
                   const glm::dvec3& direction) const;
  /// Lays a sheet before what was passed, lit by the sky.
  void veil(Passed& passed, const Layer& layer, const cloud::Sheet& sheet,
            const Meeting& meeting) const;
  glm::vec3 sunshine(const Layer& layer, const Passed& passed, const Meeting& meeting) const;

  const light::Daylight& day_;
  glm::dvec3 eye_m_;
  double pixel_m_;
  glm::vec3 daylight_;  ///< irradiance of level ground in the open
  std::vector<Layer> layers_;
};

/// The whole sphere, as Landscape::sky has it.
Image sky_picture(const CloudySky& sky, int width_px);

/// What of the sky the camera sees, as sharp as its picture and a little larger: a rectangle that
/// faces the camera `distance_m` away.
Backdrop sky_backdrop(const CloudySky& sky, const Camera& camera, int width_px, int height_px,
                      double distance_m);

}  // namespace wold::landscape
