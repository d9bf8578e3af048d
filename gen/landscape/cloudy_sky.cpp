#include "landscape/cloudy_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/scattering.h"
#include "core/parallel.h"
#include "landscape/cloud_haze.h"

namespace wold::landscape {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double earth_radius_m = 6.371e6;

/// What an eye makes out: half a pixel of a picture 1000 pixels and 60 degrees wide.
constexpr double finest_angle_rad = 5e-4;

/// Logarithm of how much deeper a cloud is where its field is higher by 1. Only fine detail is
/// shaded by this, and gently: light has been scattered too often to show more.
constexpr double shade_per_field = 1.0;

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

double rank_at(const cloud::LayerMap& map, const glm::dvec2& place_px) {
  return map.sample(place_px.x / map.width(), place_px.y / map.height());
}

/// What a table has for a number of 16 bits.
template <class Value>
const Value& looked_up(const std::vector<Value>& table, double number, unsigned per_entry) {
  const auto entry = static_cast<std::size_t>(number) / per_entry;
  return table[std::min(entry, table.size() - 1)];
}

/// Opacity for a number of the sheet's ranks where detail adds to the field.
double opacity_at(const cloud::Sheet& sheet, const cloud::Layer& layer, double number,
                  double detail) {
  const double rise = cloud::rank_rise(layer, number / 65535.0, detail);
  return double{looked_up(sheet.opacity_by_rank, std::clamp(number + 65535.0 * rise, 0.0, 65535.0),
                          cloud::ranks_per_entry)};
}

/// The light of a place, in 65536ths, where detail makes the cloud deeper or less so.
double shaded(double light, double detail) {
  if (detail == 0.0) return light;
  return std::min(
      65535.0 * cloud::brightness_of_less(light / 65535.0, std::exp(shade_per_field * detail)),
      65535.0);
}

}  // namespace

/// A line of sight where it meets a layer.
struct CloudySky::Meeting {
  glm::dvec2 place_m;
  double cosine;
  double share;              ///< of the layer there that is a sheet
  double sun_cosine;         ///< between the line of sight and the way to the sun
  double footprint_m = 0.0;  ///< what the eye makes out there
};

/// What a line of sight has passed of a layer.
struct CloudySky::Passed {
  double depth = 0.0;    ///< vertical optical depth, as it is seen
  double to_sun = 0.0;   ///< that of the droplets, from the base on towards the sun
  glm::vec3 sent{0.0F};  ///< without sunshine()
};

CloudySky::CloudySky(const light::Daylight& day, const cloud::CloudState& clouds,
                     const glm::dvec3& eye_m,
                     const std::vector<std::optional<CloudWindow>>& windows)
    : day_(day),
      eye_m_(eye_m),
      pixel_m_(clouds.pixel_m),
      daylight_(day.sun_irradiance() * static_cast<float>(day.sun_direction().z) +
                day.sky_irradiance()) {
  for (std::size_t i = 0; i < clouds.layers.size(); ++i) {
    const cloud::LayerState& state = clouds.layers[i];
    const double rise_m = state.layer->base_m - eye_m.z;
    if (rise_m <= 0.0) continue;
    layers_.push_back({state.layer,
                       state.moment.way_m,
                       cloud::sheets_of(state, clouds.pixel_m),
                       rise_m,
                       glm::vec3(state.moment.light),
                       {cloud::forward_through, state.layer->droplets.asymmetry},
                       windows.empty() ? std::nullopt : windows[i]});
  }
}

glm::vec3 CloudySky::radiance(const glm::dvec3& direction) const {
  return clouded(day_.seen_radiance(direction), day_.sky_radiance(direction), direction);
}

glm::vec3 CloudySky::irradiance() const {
  constexpr int rings = 24;
  constexpr int azimuths = 48;
  glm::dvec3 sum(0.0);
  for (int r = 0; r < rings; ++r)
    for (int a = 0; a < azimuths; ++a) {
      // Rings of equal sin^2: each direction lights level ground alike.
      const double elevation = std::asin(std::sqrt((r + 0.5) / rings));
      const glm::dvec3 direction = light::direction_of(2.0 * pi * (a + 0.5) / azimuths, elevation);
      const glm::vec3 clear = day_.sky_radiance(direction);
      sum += glm::dvec3(clouded(clear, clear, direction));
    }
  return glm::vec3(sum * (pi / (rings * azimuths)));
}

/// What is seen of the layers before the clear sky. Haze before them has the light that all of the
/// air there has, the clear sky's without the sun's glare.
glm::vec3 CloudySky::clouded(glm::vec3 behind, const glm::vec3& haze,
                             const glm::dvec3& direction) const {
  if (direction.z <= 0.0) return behind;
  for (const Layer& layer : layers_) behind = before(behind, haze, layer, direction);
  return behind;
}

glm::vec3 CloudySky::before(const glm::vec3& behind, const glm::vec3& haze, const Layer& layer,
                            const glm::dvec3& direction) const {
  const auto [distance_m, cosine] = crossing(direction.z, layer.rise_m);
  const glm::dvec2 place_m = glm::dvec2(eye_m_) + glm::dvec2(direction) * distance_m;
  Meeting meeting{place_m, cosine, layer.window ? 1.0 - layer.window->share(place_m) : 1.0,
                  glm::dot(direction, day_.sun_direction())};
  if (meeting.share <= 0.0) return behind;
  meeting.footprint_m = finest_angle_rad * distance_m / std::sqrt(cosine);
  Passed passed;
  for (const cloud::Sheet& sheet : layer.sheets) veil(passed, layer, sheet, meeting);
  if (passed.depth <= 0.0) return behind;
  glm::vec3 sent = passed.sent;
  if (!layer.made->lit_as_paper) sent += sunshine(layer, passed, meeting);
  const auto through = static_cast<float>(std::exp(-passed.depth / cosine));
  const auto clear =
      static_cast<float>(clear_share(distance_m, layer.rise_m, day_.visual_range_m()));
  return behind * through + glm::mix(haze * (1.0F - through), sent, clear);
}

/// Sunlight that the layer's sheets, as one cloud, scatter into the line of sight, as if that led
/// through all of the cloud before the sun, where it meets a drop at all. Of what is not in the
/// forward peak the ground sends some back.
glm::vec3 CloudySky::sunshine(const Layer& layer, const Passed& passed,
                              const Meeting& meeting) const {
  const double asymmetry = layer.made->droplets.asymmetry;
  const double along = passed.depth * cloud::droplets_per_seen(*layer.made) / meeting.cosine;
  const double to_sun = std::max(passed.to_sun, 1e-6);
  const double even = cloud::base_brightness(layer.made->droplets, to_sun) -
                      cloud::in_forward_peak(asymmetry, to_sun);
  const double radiance = layer.forward.at(to_sun, meeting.sun_cosine) +
                          std::max(even, 0.0) * day_.sun_direction().z / pi;
  return day_.sun_irradiance() * layer.light_colour *
         static_cast<float>(radiance * std::expm1(-along) / std::expm1(-to_sun));
}

void CloudySky::veil(Passed& passed, const Layer& layer, const cloud::Sheet& sheet,
                     const Meeting& meeting) const {
  const glm::dvec2 place_px = meeting.place_m / pixel_m_ - sheet.way_px;
  const double number = rank_at(sheet.map->ranks, place_px);
  const cloud::Layer& made = *layer.made;
  if (opacity_at(sheet, made, number, sheet.map->detail * made.detail.most()) <= 0.0) return;
  const double detail =
      sheet.map->detail * made.detail.at(meeting.place_m - layer.way_m, meeting.footprint_m);
  const double opacity = opacity_at(sheet, made, number, detail);
  if (opacity <= 0.0) return;
  const double depth = meeting.share * -std::log1p(-std::min(opacity, 0.999999));
  const double light = shaded(rank_at(sheet.map->sunlit, place_px), detail);
  const glm::vec3 diffuse(looked_up(sheet.colour_by_light, light, cloud::lights_per_entry));
  const float through = std::exp(static_cast<float>(-depth / meeting.cosine));
  const glm::vec3 shining = made.lit_as_paper ? daylight_ : day_.sky_irradiance();
  passed.sent =
      passed.sent * through + diffuse * shining * ((1.0F - through) / static_cast<float>(pi));
  passed.depth += depth;
  passed.to_sun += sheet.depth_share * cloud::depth_of_brightness(made.droplets, light / 65535.0);
}

void CloudySky::paint(Image& picture, int samples, const DirectionOf& direction) const {
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      const glm::dvec3 middle = direction(glm::dvec2(x + 0.5, y + 0.5));
      const glm::vec3 clear = day_.seen_radiance(middle), haze = day_.sky_radiance(middle);
      glm::vec3 sum(0.0F);
      for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i)
          sum += clouded(clear, haze,
                         direction(glm::dvec2(x + (i + 0.5) / samples, y + (j + 0.5) / samples)));
      sum /= static_cast<float>(samples * samples);
      std::copy_n(&sum.x, 3, picture.pixel(x, y));
    }
  });
}

Image sky_picture(const CloudySky& sky, int width_px) {
  constexpr int samples = 2;
  Image picture(width_px, width_px / 2, 3);
  sky.paint(picture, samples, [&](const glm::dvec2& at) {
    return light::direction_of(2.0 * pi * at.x / picture.width, pi * (0.5 - at.y / picture.height));
  });
  return picture;
}

Backdrop sky_backdrop(const CloudySky& sky, const Camera& camera, int width_px, int height_px,
                      double distance_m) {
  constexpr double margin = 1.06;
  constexpr int samples = 2;
  const glm::dvec3 forward = glm::normalize(camera.target_m - camera.eye_m);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
  const double width_m =
      2.0 * distance_m * margin * std::tan(camera.field_of_view_deg * pi / 360.0);
  Backdrop backdrop;
  backdrop.picture = Image(static_cast<int>(std::ceil(width_px * margin)),
                           static_cast<int>(std::ceil(height_px * margin)), 3);
  const Image& picture = backdrop.picture;
  backdrop.right_m = right * width_m;
  backdrop.up_m = glm::cross(right, forward) * (width_m * picture.height / picture.width);
  backdrop.corner_m =
      camera.eye_m + forward * distance_m - (backdrop.right_m + backdrop.up_m) / 2.0;
  sky.paint(backdrop.picture, samples, [&](const glm::dvec2& at) {
    const glm::dvec3 place_m = backdrop.corner_m + backdrop.right_m * (at.x / picture.width) +
                               backdrop.up_m * (1.0 - at.y / picture.height);
    return glm::normalize(place_m - camera.eye_m);
  });
  return backdrop;
}

}  // namespace wold::landscape
