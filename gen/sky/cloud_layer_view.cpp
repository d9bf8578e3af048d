#include "sky/cloud_layer_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/layer_crossing.h"
#include "core/elementary.h"

namespace wold::sky {
namespace {

using std::numbers::pi;

/// Logarithm of how much deeper a cloud is where its field is higher by 1. Only fine detail is
/// shaded by this, and gently: light has been scattered too often to show more.
constexpr double shade_per_field = 1.0;

double sample(const cloud::LayerMap& map, const glm::dvec2& place_px) {
  return map.sample(place_px.x / map.width(), place_px.y / map.height());
}

/// Sunlight that leaves the base of a layer without a way of its own, over that on a plane that
/// faces the sun: what comes through beside the forward peak; of a sun below the layer's level,
/// whose sine is negative, what the base sends back.
double even_flux(const cloud::Droplets& droplets, double depth_to_sun, double sun_sine) {
  const double through = cloud::base_brightness(droplets, depth_to_sun);
  if (sun_sine < 0.0) return -sun_sine * (1.0 - through);
  return sun_sine *
         std::max(through - cloud::in_forward_peak(droplets.asymmetry, depth_to_sun), 0.0);
}

}  // namespace

/// The layer's sheets at a place; optical depths along the vertical.
struct CloudLayerView::Sheets {
  double depth = 0.0;   ///< as it is seen
  double to_sun = 0.0;  ///< of the droplets
};

CloudLayerView::CloudLayerView(const cloud::LayerState& state, double pixel_m,
                               const glm::dvec3& eye_m, const light::Daylight& day,
                               double finest_rad, const std::optional<CloudWindow>& window)
    : day_(day),
      layer_(state.layer),
      eye_m_(eye_m),
      finest_rad_(finest_rad),
      rise_m_(state.layer->base_m - eye_m.z),
      pixel_m_(pixel_m),
      way_m_(state.moment.way_m),
      colour_(state.moment.light),
      sun_irradiance_(day.sun_irradiance_at(cloud::middle_m(*state.layer))),
      sheets_(cloud::sheets_of(state, pixel_m)),
      window_(window) {
  if (cloud::stands_in_heaps(*layer_))
    cumulus_.emplace(state, sheets_, eye_m, day, finest_rad, window);
}

SeenClouds CloudLayerView::along(const glm::dvec3& direction) const {
  if (cumulus_) return cumulus_->along(direction);
  const auto [distance_m, cosine] = cloud::crossing(direction.z, rise_m_);
  const glm::dvec2 place_m = glm::dvec2(eye_m_) + glm::dvec2(direction) * distance_m;
  const double footprint_m = finest_rad_ * distance_m / std::sqrt(cosine);
  const Sheets seen = sheets_at(place_m, footprint_m);
  if (seen.depth <= 0.0) return {};
  return {static_cast<float>(math::exp(-seen.depth / cosine)),
          colour_ * sent(seen, cosine, direction), distance_m};
}

CloudLayerView::Sheets CloudLayerView::sheets_at(const glm::dvec2& place_m,
                                                 double footprint_m) const {
  const double fraction = window_ ? 1.0 - window_->fraction(place_m) : 1.0;
  Sheets seen;
  if (fraction <= 0.0) return seen;
  for (const cloud::Sheet& sheet : sheets_) {
    const glm::dvec2 place_px = place_m / pixel_m_ - sheet.way_px;
    const double rank = sample(sheet.map->ranks, place_px);
    const auto opacity_with = [&](double detail) {
      return cloud::by_rank(sheet.opacity_by_rank,
                            rank + 65535.0 * cloud::rank_rise(*layer_, rank / 65535.0, detail));
    };
    if (opacity_with(sheet.map->detail * layer_->detail.max()) <= 0.0) continue;
    const double detail = sheet.map->detail * layer_->detail.at(place_m - way_m_, footprint_m);
    const double opacity = opacity_with(detail);
    if (opacity <= 0.0) continue;
    seen.depth += fraction * -math::log1p(-std::min(opacity, 0.999999));
    seen.to_sun +=
        sheet.fraction * sheet.depth_left * math::exp(shade_per_field * detail) *
        cloud::depth_of_brightness(layer_->droplets, sample(sheet.map->sunlit, place_px) / 65535.0);
  }
  return seen;
}

/// Radiance of clouds. Sunlight is scattered into the line of sight as if that led through all of
/// the cloud before the sun, where it meets a drop at all; of what is not in the forward peak the
/// ground sends some back.
glm::vec3 CloudLayerView::sent(const Sheets& seen, double cosine,
                               const glm::dvec3& direction) const {
  const cloud::Droplets& droplets = layer_->droplets;
  const double hidden = -math::expm1(-seen.depth / cosine);
  if (layer_->lit_as_paper) return day_.level_irradiance() * static_cast<float>(hidden / pi);
  const double to_sun = std::max(seen.to_sun, 1e-6);
  const double depth = seen.depth * cloud::droplets_per_seen(*layer_);
  const double even = even_flux(droplets, to_sun, day_.sun_direction().z) / pi;
  const double forward = layer_->forward->at(to_sun, glm::dot(direction, day_.sun_direction()));
  const double met = math::expm1(-depth / cosine) / math::expm1(-to_sun);
  const double sky = hidden * cloud::base_brightness(droplets, depth);
  return sun_irradiance_ * static_cast<float>((forward + even) * met) +
         day_.sky_irradiance() * static_cast<float>(sky / pi);
}

}  // namespace wold::sky
