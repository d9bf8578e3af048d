#include "landscape/exposure.h"

#include <algorithm>
#include <numbers>

#include "core/colour.h"

namespace wold::landscape {
namespace {

/// A white card in the open is exposed above white: grass and sky are dark subjects, and a camera
/// that meters them opens by most of a stop.
constexpr double card_exposure = 1.6;

/// The same under clouds, which are white cards themselves.
constexpr double card_exposure_clouds = 1.2;

/// Exposure of the sky at 20 degrees of elevation at which it is about to burn out: there the
/// camera stops opening. A low sun lights the sky more than the ground.
constexpr double brightest_sky = 0.9;

}  // namespace

double metered_gain(const light::Daylight& day, bool clouds) {
  constexpr double elevation_rad = 20.0 * std::numbers::pi / 180.0;
  const double sky = luminance(day.mean_sky_radiance(elevation_rad));
  return std::min((clouds ? card_exposure_clouds : card_exposure) * std::numbers::pi,
                  brightest_sky / sky);
}

}  // namespace wold::landscape
