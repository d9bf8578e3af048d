#include "sky/cumulus_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cloud/layer_crossing.h"
#include "core/elementary.h"

namespace wold::sky {
namespace {

/// A transmittance below which nothing behind is seen.
constexpr double nothing_left = 0.004;

/// How far from a place the heaps are followed as they are seen, as a fraction of the thickness; to
/// a low sun, before which their edges shine, until light comes from so much higher.
constexpr double near_fraction = 0.45, near_rise = 0.2;

/// How much heads raise the field of heaps whose heads are evened out: hardly ever more.
constexpr double heads_field = 0.95;

/// Where the sun shines from into clouds.
glm::dvec3 shining_from(glm::dvec3 sun_direction) {
  sun_direction.z = std::max(sun_direction.z, cloud::lowest_sun_sine);
  return glm::normalize(sun_direction);
}

}  // namespace

/// A line of sight between the base and the height of the highest top.
struct CumulusView::Ray {
  glm::dvec3 direction;
  double base_m, top_m;  ///< distances
  double footprint_m;    ///< of what the eye makes out at the base

  double length_m() const { return top_m - base_m; }
};

/// What a line of sight has met so far.
struct CumulusView::Passed {
  double transmittance = 1.0;
  glm::vec3 sent{0.0F};
  glm::vec3 source{0.0F};  ///< of the place that was lit last
  double lit_at = 2.0;     ///< the transmittance there; above 1 where none was lit yet
  double step_m = 0.0;     ///< that comes next in the heap
  double weighed_m = 0.0;  ///< distances by how much is seen there

  bool is_done() const { return transmittance < nothing_left; }

  /// Whether the light there may differ from that of the place that was lit last, and shows.
  bool wants_light() const {
    constexpr double deeper = 0.55, hardly_seen = 0.15;
    return lit_at > 1.0 || (transmittance > hardly_seen && transmittance < deeper * lit_at);
  }
};

CumulusView::CumulusView(const cloud::LayerState& state, std::vector<cloud::Sheet> sheets,
                         const glm::dvec3& eye_m, const light::Daylight& day, double finest_rad,
                         const std::optional<CloudWindow>& window)
    : layer_(state.layer),
      light_(cloud::cloud_light(day, cloud::middle_m(*state.layer), eye_m)),
      to_sun_(shining_from(light_.sun_direction)),
      finest_rad_(finest_rad),
      colour_(state.moment.light),
      alpha_(state.moment.amount_is_alpha ? static_cast<float>(state.moment.amount) : 1.0F),
      heaps_(state, std::move(sheets)),
      forward_(cloud::forward_source, state.layer->droplets.asymmetry),
      window_(window) {}

CumulusView::Ray CumulusView::ray_along(const glm::dvec3& direction) const {
  const double rise_m = layer_->base_m - light_.eye_m.z;
  const double base_m = cloud::crossing(direction.z, rise_m).distance_m;
  const double top_m = cloud::crossing(direction.z, rise_m + heaps_.highest_m()).distance_m;
  return {direction, base_m, top_m, finest_rad_ * base_m};
}

/// As many as find heaps of the layer's size, up to a limit.
int CumulusView::steps_along(const Ray& ray) const {
  constexpr double max = 128.0, of_thickness = 0.06;
  const double step_m = std::max(of_thickness * layer_->thickness_m, 2.0 * ray.footprint_m);
  return static_cast<int>(std::clamp(std::ceil(ray.length_m() / step_m), 4.0, max));
}

SeenClouds CumulusView::along(const glm::dvec3& direction) const {
  if (heaps_.highest_m() <= 0.0) return {};
  const Ray ray = ray_along(direction);
  const int count = steps_along(ray);
  const double step_m = ray.length_m() / count;
  Passed passed;
  passed.step_m = first_step_m(ray, passed);
  double before = field_on(ray, ray.base_m, step_m);
  for (int i = 0; i < count && !passed.is_done(); ++i) {
    const double low_m = ray.base_m + i * step_m, high_m = low_m + step_m;
    const double after = field_on(ray, high_m, step_m);
    if (std::max(before, after) > -heads_field) pass_step(ray, low_m, high_m, passed);
    before = after;
  }
  const double hidden = 1.0 - passed.transmittance;
  if (hidden <= 0.0) return {};
  return {1.0F - alpha_ * static_cast<float>(hidden), alpha_ * colour_ * passed.sent,
          passed.weighed_m / hidden};
}

/// The place of a distance along the ray, on the layer's flat earth.
glm::dvec3 CumulusView::place_on(const Ray& ray, double at_m) const {
  const double height_fraction = (at_m - ray.base_m) / ray.length_m();
  return {glm::dvec2(light_.eye_m) + glm::dvec2(ray.direction) * at_m,
          layer_->base_m + height_fraction * heaps_.highest_m()};
}

/// Of heads that steps of that length can find.
double CumulusView::field_on(const Ray& ray, double at_m, double step_m) const {
  return heaps_.field(place_on(ray, at_m), std::max(ray.footprint_m, 0.25 * step_m));
}

/// Where between two places of the ray, by their distances, the heap begins that is at the second.
double CumulusView::surface_between(const Ray& ray, double outside_m, double inside_m,
                                    double step_m) const {
  constexpr int halvings = 4;
  for (int i = 0; i < halvings; ++i) {
    const double middle_m = 0.5 * (outside_m + inside_m);
    (field_on(ray, middle_m, step_m) > 0.0 ? inside_m : outside_m) = middle_m;
  }
  return inside_m;
}

/// Follows the line of sight through a step near a heap, in as short ones as find the heads that
/// the eye makes out.
void CumulusView::pass_step(const Ray& ray, double from_m, double to_m, Passed& passed) const {
  constexpr double finest = 1.0 / 4.0;  // of the step
  const double length_m = to_m - from_m;
  const double wanted_m = std::max(finest * length_m, 2.0 * ray.footprint_m);
  const int count = static_cast<int>(std::ceil(length_m / wanted_m));
  const double step_m = length_m / count;
  double before = field_on(ray, from_m, step_m);
  for (int i = 0; i < count && !passed.is_done(); ++i) {
    const double low_m = from_m + i * step_m, high_m = low_m + step_m;
    const double after = field_on(ray, high_m, step_m);
    if (before <= 0.0) passed.step_m = first_step_m(ray, passed);
    if (before > 0.0 || after > 0.0)
      pass_heap(ray, before > 0.0 ? low_m : surface_between(ray, low_m, high_m, step_m),
                after > 0.0 ? high_m : surface_between(ray, high_m, low_m, step_m), passed);
    before = after;
  }
}

/// Where a heap is met; of one behind another less is seen.
double CumulusView::first_step_m(const Ray& ray, const Passed& passed) const {
  const double first_m = std::max(0.25 / layer_->droplets.extinction_per_m, ray.footprint_m);
  return passed.transmittance > 0.9 ? first_m : 2.0 * first_m;
}

/// Follows the line of sight through a heap: steps are short at the surface that is met and grow
/// inward. Light changes little on the way through what is as thin as that.
void CumulusView::pass_heap(const Ray& ray, double from_m, double to_m, Passed& passed) const {
  constexpr double growth = 1.3;
  for (double at_m = from_m; at_m < to_m && !passed.is_done();) {
    const double length_m = std::min(passed.step_m, to_m - at_m);
    if (length_m == passed.step_m) passed.step_m *= growth;
    const double middle_m = at_m + 0.5 * length_m;
    at_m += length_m;
    const glm::dvec3 place_m = place_on(ray, middle_m);
    const double seen = window_ ? 1.0 - window_->fraction(glm::dvec2(place_m)) : 1.0;
    const double depth = seen * extinction_per_m(place_m, ray.footprint_m) * length_m;
    if (depth <= 0.0) continue;
    if (passed.wants_light()) {
      passed.source = source(place_m, ray.direction);
      passed.lit_at = passed.transmittance;
    }
    const double hidden = passed.transmittance * -math::expm1(-depth);
    passed.sent += static_cast<float>(hidden) * passed.source;
    passed.weighed_m += hidden * middle_m;
    passed.transmittance -= hidden;
  }
}

/// Rises inward from the surface to that of the droplets.
double CumulusView::extinction_per_m(const glm::dvec3& place_m, double footprint_m) const {
  constexpr double soft = 0.5;  // of the field
  const double inside = std::clamp(heaps_.field(place_m, footprint_m) / soft, 0.0, 1.0);
  return layer_->droplets.extinction_per_m * inside * inside;
}

/// Optical depth from a place to a distance from there; what is nearer counts in shorter steps.
double CumulusView::near_depth(const glm::dvec3& place_m, const glm::dvec3& direction,
                               double reach_m) const {
  constexpr double growth = 1.6, first = 0.03;  // of the thickness
  double length_m = first * layer_->thickness_m, from_m = 0.0, depth = 0.0;
  for (; from_m < reach_m; from_m += length_m, length_m *= growth) {
    const double step_m = std::min(length_m, reach_m - from_m);
    depth += step_m * extinction_per_m(place_m + direction * (from_m + 0.5 * step_m), 0.5 * step_m);
  }
  return depth;
}

double CumulusView::depth_to_sun(const glm::dvec3& place_m) const {
  const double reach_m = std::max(near_fraction, near_rise / to_sun_.z) * layer_->thickness_m;
  return near_depth(place_m, to_sun_, reach_m) + heaps_.depth_to_sun(place_m + to_sun_ * reach_m);
}

double CumulusView::depth_above(const glm::dvec3& place_m) const {
  const double reach_m = near_fraction * layer_->thickness_m;
  const double far_m = place_m.z + reach_m - layer_->base_m;
  const double above_m = std::max(heaps_.top_m(glm::dvec2(place_m)) - far_m, 0.0);
  return near_depth(place_m, {0.0, 0.0, 1.0}, reach_m) +
         layer_->droplets.extinction_per_m * above_m;
}

/// Radiance that the place sends to the eye per unit of optical depth. Behind it, away from the sun
/// and from the sky, lies all that is between it and the base.
glm::vec3 CumulusView::source(const glm::dvec3& place_m, const glm::dvec3& from_eye) const {
  const cloud::Droplets& droplets = layer_->droplets;
  const double below = droplets.extinction_per_m * std::max(place_m.z - layer_->base_m, 0.0);
  return cloud::source_at(forward_, droplets.asymmetry,
                          {depth_to_sun(place_m), below / to_sun_.z, depth_above(place_m), below},
                          from_eye, light_);
}

}  // namespace wold::sky
