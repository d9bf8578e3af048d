#pragma once

#include <glm/glm.hpp>

#include "cloud/clouds.h"
#include "cloud/look.h"
#include "core/image.h"

namespace wold::cloud {

/// The part of the sky that a picture shows, as it is laid over the land: row 0 is north, pixels
/// are those of the clouds' maps.
struct SkyWindow {
  glm::dvec2 south_west_m = {};  ///< corner of the picture
  int width_px = 0;
  int height_px = 0;
};

/// All layers over each other, the lowest in front, as seen from below along the vertical: 4
/// channels, linear colour premultiplied by opacity, and opacity. Drift moves maps by parts of a
/// pixel: bilinear, in steps of 1/65536.
Image composed(const CloudState& state, const SkyWindow& window);

/// The same into a picture that has the window's size and 4 channels already.
void compose(const CloudState& state, const SkyWindow& window, Image& picture);

/// One layer alone over its whole period, likewise, where it would be without drift: a renderer's
/// texture, which `LayerState::moment.way_m` moves and `Layer::period_m` repeats.
Image layer_picture(const LayerState& state, double pixel_m);

}  // namespace wold::cloud
