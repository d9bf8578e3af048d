#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "cloud/clouds.h"
#include "core/image.h"
#include "landscape/landscape.h"
#include "light/daylight.h"
#include "sky/cloud_boxes.h"
#include "sky/cloud_layer_view.h"

namespace wold::sky {

/// The sky as one eye sees it: the clear sky behind layers of cloud (CloudLayerView), the farthest
/// first, which sink into the haze with their distance.
class CloudySky {
 public:
  /// Half a pixel of a picture 1000 pixels and 60 degrees wide.
  static constexpr double usual_finest_rad = 5e-4;

  /// `day` has to outlive it. Layers that are not above the eye are left out, and what of a layer
  /// stands as a volume in its window; no windows at all: nothing does. The eye makes out angles of
  /// finest_rad.
  CloudySky(const light::Daylight& day, const cloud::CloudState& clouds, const glm::dvec3& eye_m,
            double finest_rad = usual_finest_rad,
            const std::vector<std::optional<CloudWindow>>& windows = {});

  /// Radiance from a unit direction.
  glm::vec3 radiance(const glm::dvec3& direction) const;

  /// The unit direction that a place in a picture looks to, in pixels from its upper left corner.
  using DirectionOf = std::function<glm::dvec3(const glm::dvec2&)>;

  /// Radiance, the mean over four places of each pixel, or two where these are alike. Clouds have
  /// edges; the clear sky behind them counts as the same all over a pixel.
  void paint(Image& picture, const DirectionOf& direction) const;

  /// Irradiance by the whole sky, without the sun's disc, on level ground.
  glm::vec3 irradiance() const;

 private:
  glm::vec3 clouded(glm::vec3 behind, const glm::vec3& haze, const glm::dvec3& direction) const;

  const light::Daylight& day_;
  std::vector<CloudLayerView> layers_;
};

/// The whole sphere, as Landscape::sky has it.
Image sky_picture(const CloudySky& sky, int width_px);

/// What of the sky the camera sees, as sharp as its picture and a little larger: a rectangle that
/// faces the camera `distance_m` away.
landscape::Backdrop sky_backdrop(const CloudySky& sky, const landscape::Camera& camera,
                                 int width_px, int height_px, double distance_m);

}  // namespace wold::sky
