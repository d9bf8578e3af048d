#include "landscape/exposure.h"

#include <algorithm>
#include <numbers>

#include "core/colour.h"

namespace wold::landscape {
namespace {

/// How a white card in the open is exposed: above white where the subject is dark, as grass and sky
/// are, and a camera that meters them opens by most of a stop. Clouds are white cards themselves,
/// and snow is one that lies in the open.
double card_exposure(Subject subject) {
  switch (subject) {
    case Subject::meadow:
      return 1.6;
    case Subject::clouds:
      return 1.2;
    case Subject::snow:
      break;
  }
  return 0.95;
}

/// Exposure of the sky at 20 degrees of elevation at which it is about to burn out: there the
/// camera stops opening. A low sun lights the sky more than the ground.
constexpr double brightest_sky = 0.9;

}  // namespace

double metered_gain(const light::Daylight& day, Subject subject) {
  constexpr double elevation_rad = 20.0 * std::numbers::pi / 180.0;
  const double sky = luminance(day.mean_sky_radiance(elevation_rad));
  return std::min(card_exposure(subject) * std::numbers::pi, brightest_sky / sky);
}

}  // namespace wold::landscape
