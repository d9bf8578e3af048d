#include "sky/cloud_layer_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::sky {
namespace {

using std::numbers::pi;
constexpr double earth_radius_m = 6.371e6;

/// Logarithm of how much deeper a cloud is where its field is higher by 1. Only fine detail is
/// shaded by this, and gently: light has been scattered too often to show more.
constexpr double shade_per_field = 1.0;

/// An optical depth behind which nothing is seen.
constexpr double opaque = 6.0;

/// Fraction of the sky's light that a cloud's side sends back.
constexpr double side_albedo = 0.8;

/// Where a ray from the ground meets a layer `rise_m` above it: the distance along the ray and the
/// cosine between the ray and the vertical there. The ray goes up at an elevation whose sine is
/// given.
struct Crossing {
  double distance_m;
  double cosine;
};
Crossing crossing(double sine, double rise_m) {
  const double down_m = earth_radius_m * sine;
  const double beyond_m2 = rise_m * (2.0 * earth_radius_m + rise_m);
  // The difference of two large numbers, written so that it keeps its digits.
  const double distance_m = beyond_m2 / (down_m + std::sqrt(down_m * down_m + beyond_m2));
  return {distance_m, (down_m + distance_m) / (earth_radius_m + rise_m)};
}

double sample(const cloud::LayerMap& map, const glm::dvec2& place_px) {
  return map.sample(place_px.x / map.width(), place_px.y / map.height());
}

/// What [Wang2010]'s events leave of a layer.
double alpha_of(const cloud::LayerMoment& moment) {
  return moment.amount_is_alpha ? moment.amount : 1.0;
}

/// Mean density, over the densest, of a step through a heap whose field, there linear, has these
/// values at its ends.
double dense_fraction(double first, double last) {
  constexpr double soft = 0.2;  // of the field, from the surface to the densest
  if (first <= 0.0 && last <= 0.0) return 0.0;
  const auto dense = [](double field) { return std::clamp(field / soft, 0.0, 1.0); };
  const double outside = std::max(-std::min(first, last), 0.0);
  const double inside = std::max(first, last);
  return inside / (inside + outside) * 0.5 * (dense(first) + dense(last));
}

}  // namespace

/// A line of sight that meets the layer's base.
struct CloudLayerView::Ray {
  glm::dvec3 direction;
  double distance_m;      ///< to the base
  double top_distance_m;  ///< to the height of the highest top
  double cosine;          ///< between the line of sight and the vertical at the base
};

/// The light of a place that is seen; optical depths are the droplets'.
struct CloudLayerView::Lit {
  double to_sun = 0.0;  ///< optical depth
  double sky = 0.0;     ///< fraction of the sky's irradiance that comes out again
  double faced = 0.0;   ///< likewise of the sun's, where it shines on the place itself
};

/// Sums over a line of sight; those of light are of what hides the light behind.
struct CloudLayerView::Passed {
  double depth = 0.0;     ///< optical depth, as it is seen
  double droplets = 0.0;  ///< and that of the droplets
  Lit light;

  void add(double seen, double of_droplets, const Lit& lit) {
    const double hides = math::exp(-depth) * -math::expm1(-seen);
    depth += seen;
    droplets += of_droplets;
    light.to_sun += hides * lit.to_sun;
    light.sky += hides * lit.sky;
    light.faced += hides * lit.faced;
  }
  double hidden() const { return -math::expm1(-depth); }
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
      seen_per_m_(alpha_of(state.moment) * state.layer->seen_depth / state.layer->thickness_m),
      sheets_(cloud::sheets_of(state, pixel_m)),
      window_(window) {
  if (layer_->has_relief) cumulus_cells_.emplace(state, sheets_);
}

SeenClouds CloudLayerView::along(const glm::dvec3& direction) const {
  const auto [distance_m, cosine] = crossing(direction.z, rise_m_);
  const double highest_m = cumulus_cells_ ? cumulus_cells_->highest_m() : 0.0;
  const Ray ray{direction, distance_m, crossing(direction.z, rise_m_ + highest_m).distance_m,
                cosine};
  Passed passed;
  add_base(passed, ray);
  if (highest_m > 0.0 && passed.depth < opaque) add_sides(passed, ray);
  if (passed.depth <= 0.0) return {};
  return {static_cast<float>(math::exp(-passed.depth)), colour_ * sent(passed, ray), distance_m};
}

/// A place of the ray above the base, at a fraction of the highest top.
glm::dvec3 CloudLayerView::place_on(const Ray& ray, double height_fraction) const {
  const double way_m = std::lerp(ray.distance_m, ray.top_distance_m, height_fraction);
  return {glm::dvec2(eye_m_) + glm::dvec2(ray.direction) * way_m,
          layer_->base_m + height_fraction * cumulus_cells_->highest_m()};
}

/// As many as show the highest clouds in steps that an eye makes out, up to a limit.
int CloudLayerView::steps_along(const Ray& ray) const {
  constexpr double max = 48.0;
  const double across_m =
      cumulus_cells_->highest_m() * math::hypot(ray.direction.x, ray.direction.y);
  return static_cast<int>(
      std::clamp(std::ceil(across_m / (3.0 * finest_rad_ * ray.distance_m)), 1.0, max));
}

double CloudLayerView::window_fraction(const glm::dvec2& place_m) const {
  return window_ ? 1.0 - window_->fraction(place_m) : 1.0;
}

void CloudLayerView::add_base(Passed& passed, const Ray& ray) const {
  const glm::dvec2 place_m = glm::dvec2(eye_m_) + glm::dvec2(ray.direction) * ray.distance_m;
  const double fraction = window_fraction(place_m);
  if (fraction <= 0.0) return;
  const double footprint_m = finest_rad_ * ray.distance_m / std::sqrt(ray.cosine);
  double depth = 0.0;
  Lit lit;
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
    depth += fraction * -math::log1p(-std::min(opacity, 0.999999));
    lit.to_sun +=
        sheet.fraction * sheet.depth_left * math::exp(shade_per_field * detail) *
        cloud::depth_of_brightness(layer_->droplets, sample(sheet.map->sunlit, place_px) / 65535.0);
  }
  if (depth <= 0.0) return;
  const double droplets = depth * cloud::droplets_per_seen(*layer_);
  const double relief =
      cumulus_cells_ ? layer_->droplets.extinction_per_m * cumulus_cells_->top_m(place_m) : 0.0;
  lit.sky = cloud::base_brightness(layer_->droplets, std::max(droplets, relief));
  passed.add(depth / ray.cosine, droplets / ray.cosine, lit);
}

CloudLayerView::Lit CloudLayerView::side_light(const glm::dvec3& place_m,
                                               double footprint_m) const {
  const cloud::Droplets& droplets = layer_->droplets;
  const glm::dvec3 normal = cumulus_cells_->normal(place_m, footprint_m);
  Lit lit;
  lit.to_sun = cumulus_cells_->depth_to_sun(place_m);
  const double open = 0.5 + 0.5 * normal.z;
  const double above_m =
      std::max(layer_->base_m + cumulus_cells_->top_m(glm::dvec2(place_m)) - place_m.z, 0.0);
  lit.sky = std::lerp(cloud::base_brightness(droplets, droplets.extinction_per_m * above_m),
                      side_albedo, open);
  lit.faced = side_albedo * std::max(glm::dot(normal, day_.sun_direction()), 0.0) *
              cloud::two_stream(droplets.asymmetry, lit.to_sun, 0.0).onward;
  return lit;
}

/// Where between two places of the ray, by fractions of the highest top, a heap begins: it is not
/// at the first but at the second.
double CloudLayerView::entry_between(const Ray& ray, double outside, double inside,
                                     double footprint_m) const {
  constexpr int halvings = 5;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (outside + inside);
    (cumulus_cells_->field(place_on(ray, middle), footprint_m) > 0.0 ? inside : outside) = middle;
  }
  return inside;
}

/// How many times as deep heaps are along a line of sight as columns are seen: from the side clouds
/// end within some metres, while through a base, unless it is but a fringe, they are the column.
double CloudLayerView::crispness(const Ray& ray, double base_depth) const {
  constexpr double from_side = 8.0;
  if (base_depth <= 0.0) return from_side;
  const double column =
      seen_per_m_ * cumulus_cells_->top_m(glm::dvec2(place_on(ray, 0.0))) / ray.cosine;
  return column > 0.0 ? std::lerp(from_side, 1.0, std::min(base_depth / column, 1.0)) : 1.0;
}

/// Follows the line of sight through heaps. What stands on the base where it was met is in the
/// base's depth already.
void CloudLayerView::add_sides(Passed& passed, const Ray& ray) const {
  const int count = steps_along(ray);
  const double step_m = (ray.top_distance_m - ray.distance_m) / count;
  const double finest_m = finest_rad_ * ray.distance_m;
  const double footprint_m = std::max(finest_m, 0.5 * step_m);  // of what steps can show
  double before = cumulus_cells_->field(place_on(ray, 0.0), footprint_m);
  double in_base = passed.depth;
  double crisp = crispness(ray, in_base);
  std::optional<Lit> lit;  // of the surface that is seen
  for (int i = 0; i < count && passed.depth < opaque; ++i) {
    const double low = static_cast<double>(i) / count, high = (i + 1.0) / count;
    const double after = cumulus_cells_->field(place_on(ray, high), footprint_m);
    const bool enters = before <= 0.0 && after > 0.0;
    const double dense_m = dense_fraction(before, after) * step_m;
    before = after;
    if (dense_m <= 0.0) {
      in_base = 0.0;
      crisp = crispness(ray, in_base);
      continue;
    }
    const glm::dvec3 place_m =
        place_on(ray, enters ? entry_between(ray, low, high, footprint_m) : low);
    const double there_m = window_fraction(glm::dvec2(place_m)) * dense_m;
    const double seen = crisp * seen_per_m_ * there_m;
    const double counted = std::min(in_base, seen);
    in_base -= counted;
    if (seen <= counted) continue;
    if (enters || !lit) lit = side_light(place_m, finest_m);
    passed.add(seen - counted, layer_->droplets.extinction_per_m * there_m, *lit);
  }
}

/// Radiance of clouds. Sunlight is scattered into the line of sight as if that led through all of
/// the cloud before the sun, where it meets a drop at all; of what is not in the forward peak the
/// ground sends some back.
glm::vec3 CloudLayerView::sent(const Passed& passed, const Ray& ray) const {
  const cloud::Droplets& droplets = layer_->droplets;
  const double hidden = passed.hidden();
  const double sun_height = day_.sun_direction().z;
  if (layer_->lit_as_paper)
    return (day_.sky_irradiance() + day_.sun_irradiance() * static_cast<float>(sun_height)) *
           static_cast<float>(hidden / pi);
  const double to_sun = std::max(passed.light.to_sun / hidden, 1e-6);
  const double even = std::max(cloud::base_brightness(droplets, to_sun) -
                                   cloud::in_forward_peak(droplets.asymmetry, to_sun),
                               0.0) *
                      sun_height / pi;
  const double forward = layer_->forward->at(to_sun, glm::dot(ray.direction, day_.sun_direction()));
  const double met = math::expm1(-passed.droplets) / math::expm1(-to_sun);
  return day_.sun_irradiance() *
             static_cast<float>((forward + even) * met + passed.light.faced / pi) +
         day_.sky_irradiance() * static_cast<float>(passed.light.sky / pi);
}

}  // namespace wold::sky
