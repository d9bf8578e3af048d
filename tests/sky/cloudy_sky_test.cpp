#include "sky/cloudy_sky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cloud/scattering.h"
#include "scene/scene.h"
#include "support/temporary_folder.h"

namespace wold::sky {
namespace {

constexpr double deg = std::numbers::pi / 180.0;
constexpr double earth_radius_m = 6.371e6;
constexpr double clear_air_m = 1e12;  ///< a visual range
constexpr double pixel_m = 20.0;
const glm::dvec3 eye_m(300.0, -200.0, 2.0);
const glm::dvec3 zenith(0.0, 0.0, 1.0);

/// A sky of one layer 2000 m above the eye, whose clouds are at rest.
scene::Scene one_layer() {
  scene::Scene scene;
  scene.sky.visual_range_m = clear_air_m;
  scene.clouds.resize(1);
  scene.clouds[0].base_m = 2000.0 + eye_m.z;
  scene.clouds[0].speed_m_s = 0.0;
  scene.clouds[0].cell_m = 4000.0;
  scene.clouds[0].cells = {4, 4};
  return scene;
}

/// Nothing shines on the clouds: they only stand before the sky.
scene::Scene darkened(scene::Scene scene) {
  scene.cloud_events.push_back({.kind = scene::CloudEventKind::light,
                                .start_s = 0.0,
                                .duration_s = 0.001,
                                .colour = {0.0, 0.0, 0.0}});
  return scene;
}

/// The sky of a scene, and what it is made of.
struct Sky {
  light::Daylight day;
  cloud::CloudState clouds;
  CloudySky seen;

  explicit Sky(const scene::Scene& scene, double time_s = 1.0)
      : day(scene.sun, scene.sky),
        clouds(cloud::Clouds(scene, pixel_m).at(time_s)),
        seen(day, clouds, eye_m) {}
  Sky(const Sky&) = delete;
  Sky& operator=(const Sky&) = delete;

  /// Of the sun's green, that on a plane which faces it in the middle of the layer.
  double sun_up_there() const {
    return double{day.sun_irradiance_at(cloud::middle_m(*clouds.layers[0].layer)).g};
  }

  /// Fraction of the clear sky's green that comes through clouds on which nothing shines.
  double through(const glm::dvec3& direction) const {
    return static_cast<double>(seen.radiance(direction).g) /
           static_cast<double>(day.seen_radiance(direction).g);
  }
};

class CloudySkies : public testing::Test {
 protected:
  /// One texture of one pixel: clouds that are everywhere alike, of that vertical opacity.
  scene::Scene veil(double opacity, scene::CloudKind kind = scene::CloudKind::cirrus) const {
    Image picture(1, 1, 1);
    picture.values[0] = 1.0F;
    const auto path = folder_.path() / "veil.png";
    write_image(path, picture, PixelFormat::uint8);
    scene::Scene scene = one_layer();
    scene.clouds[0].kind = kind;
    scene.clouds[0].textures = {path.string()};
    scene.clouds[0].opacity = opacity;
    return scene;
  }

 private:
  test::TemporaryFolder folder_{"cloudy_sky"};
};

TEST_F(CloudySkies, WithoutSheetsAreTheClearSky) {
  scene::Scene scene = veil(0.8);
  scene.clouds[0].base_m = 0.0;  // beneath the eye
  const Sky sky(scene);
  for (int i = 0; i < 60; ++i) {
    const glm::dvec3 direction = light::direction_of(i * 0.7, (i - 20) * 2.0 * deg);
    EXPECT_EQ(sky.seen.radiance(direction), sky.day.seen_radiance(direction)) << i;
  }
  const glm::vec3 irradiance = sky.seen.irradiance();
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(irradiance[c] / sky.day.sky_irradiance()[c], 1.0, 0.01) << c;
}

// On a sphere the ray from an elevation e reaches a layer h higher after d = sqrt((R sin e)^2 +
// 2 R h + h^2) - R sin e, at an angle to the vertical whose sine is R cos e / (R + h).
TEST_F(CloudySkies, LieOnASphere) {
  scene::Scene scene = darkened(one_layer());
  scene.clouds[0].opacity = 0.2;
  scene.clouds[0].thickness_m = 40.0;  // so thin that it has no sides
  const Sky sky(scene);
  constexpr double h = 2000.0;
  int clouded = 0;
  for (int i = 0; i < 200; ++i) {
    const double elevation = 90.0 * deg * std::pow(0.965, i);  // down to 4 minutes of arc
    const double azimuth = 0.61 * i;
    const double down_m = earth_radius_m * std::sin(elevation);
    const double distance_m =
        std::sqrt(down_m * down_m + 2.0 * earth_radius_m * h + h * h) - down_m;
    const double sine = earth_radius_m * std::cos(elevation) / (earth_radius_m + h);
    const double cosine = std::sqrt(1.0 - sine * sine);
    const glm::dvec2 place =
        glm::dvec2(eye_m) +
        distance_m * std::cos(elevation) * glm::dvec2(std::sin(azimuth), std::cos(azimuth));
    const double depth = cloud::optical_depth_at(sky.clouds.layers[0], pixel_m, place);
    const double seen = -std::log(sky.through(light::direction_of(azimuth, elevation))) * cosine;
    // Nearer than this an eye sees detail that is finer than the layer's map.
    if (distance_m < 30000.0) continue;
    EXPECT_NEAR(seen, depth, 0.01) << i;
    clouded += depth > 0.05;
  }
  EXPECT_GT(clouded, 10);
  EXPECT_NEAR(std::sqrt(2.0 * earth_radius_m * h), 159637.0, 1.0);  // as far as it is seen
}

TEST_F(CloudySkies, LetThroughWhatBeerAndLambertSay) {
  constexpr double opacity = 0.3;
  const Sky sky(darkened(veil(opacity)));
  EXPECT_NEAR(sky.through(zenith), 1.0 - opacity, 1e-3);
  for (const double elevation : {60.0, 30.0, 10.0, 1.0}) {
    const double sine = std::cos(elevation * deg) / (1.0 + 2000.0 / earth_radius_m);
    const double wanted = std::pow(1.0 - opacity, 1.0 / std::sqrt(1.0 - sine * sine));
    EXPECT_NEAR(sky.through(light::direction_of(4.0, elevation * deg)), wanted,
                2e-3 * wanted + 1e-6)
        << elevation;
  }
}

/// What a veil sends by itself, of the sun's green: a layer of that thickness, 30 degrees high.
struct Shine {
  double near_sun, far_from_sun;
};
Shine shine(scene::Scene scene, double opacity) {
  scene.sun.azimuth_deg = 180.0;
  scene.sun.elevation_deg = 30.0;
  const Sky sky(scene);
  const auto sent = [&](double azimuth) {
    const glm::dvec3 direction = light::direction_of(azimuth * deg, 30.0 * deg);
    const double sine = std::cos(30.0 * deg) / (1.0 + 2000.0 / earth_radius_m);
    const double through = std::pow(1.0 - opacity, 1.0 / std::sqrt(1.0 - sine * sine));
    return (double{sky.seen.radiance(direction).g} -
            through * double{sky.day.seen_radiance(direction).g}) /
           sky.sun_up_there();
  };
  return {sent(188.0), sent(8.0)};
}

// While a wind draws thick clouds out, two shapes share their optical depth. They are one cloud to
// sunlight: where both are everywhere alike nothing changes, not even near the sun.
TEST_F(CloudySkies, ShineAsOneCloudWhileShapesChange) {
  scene::Scene scene = veil(0.995, scene::CloudKind::stratus);
  scene.sun.azimuth_deg = 180.0;
  scene.sun.elevation_deg = 30.0;
  scene.cloud_events.push_back({.kind = scene::CloudEventKind::wind,
                                .start_s = 10.0,
                                .duration_s = 100.0,
                                .heading_deg = 150.0,
                                .shear = 0.8});
  const Sky before(scene, 5.0);
  const glm::dvec3 direction = light::direction_of(186.0 * deg, 30.0 * deg);
  const float wanted = before.seen.radiance(direction).g;
  for (const double time_s : {14.0, 30.0, 60.0, 90.0}) {
    const Sky meanwhile(scene, time_s);
    ASSERT_EQ(cloud::sheets_of(meanwhile.clouds.layers[0], pixel_m).size(), 2u);
    EXPECT_NEAR(meanwhile.seen.radiance(direction).g, wanted, 0.01 * wanted) << time_s;
  }
}

// As much as 0.01 of optical depth scatters once by Henyey and Greenstein's law, and a little of
// the diffuse light, at most a veil's fraction of a white card's radiance.
TEST_F(CloudySkies, HaveASilverLining) {
  constexpr double depth = 0.01, g = 0.8, slant = 2.0;
  const double opacity = -std::expm1(-depth);
  scene::Scene scene = veil(opacity);
  scene.clouds[0].thickness_m = 10.0;  // of ice that weakens light by 1 / km
  const Shine thin = shine(scene, opacity);
  const double cosine =
      std::pow(std::sin(30 * deg), 2) + std::pow(std::cos(30 * deg), 2) * std::cos(8 * deg);
  const double phase =
      (1 - g * g) / (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
  const double once = phase * depth * slant;
  EXPECT_GT(thin.near_sun, 0.95 * once);
  EXPECT_LT(thin.near_sun, once + depth * slant / std::numbers::pi * 1.5);
  EXPECT_GT(thin.near_sun, 5.0 * thin.far_from_sun);

  scene.clouds[0].kind = scene::CloudKind::stratus;  // optical depth 59
  scene.clouds[0].thickness_m = 1000.0;
  scene.clouds[0].opacity = 0.995;
  const Shine thick = shine(scene, 0.995);
  EXPECT_NEAR(thick.near_sun, thick.far_from_sun, 0.02 * thick.near_sun);
}

// Under a sun at the zenith: two-stream diffusion lets 1 / (1 + 3/4 (1 - g) tau) through, a fifth
// of the rest comes from the ground. Clouds have more of the sun than the ground, where the
// daylight is 1, for most of the haze lies below them. What of the sun's is still in the forward
// peak does not come evenly, but by the law of cloud/scattering.h.
TEST_F(CloudySkies, HaveBasesThatDarkenWithThickness) {
  scene::Scene scene = veil(0.995, scene::CloudKind::stratus);
  scene.sun.elevation_deg = 90.0;
  const auto base = [&](double thickness_m) {
    scene.clouds[0].thickness_m = thickness_m;
    return double{Sky(scene).seen.radiance(light::direction_of(1.0, 40.0 * deg)).g};
  };
  const auto wanted = [&](double thickness_m) {
    const double depth = 0.0594 * thickness_m;
    const double through = 1.0 / (1.0 + 0.75 * (1.0 - 0.865) * depth);
    scene.clouds[0].thickness_m = thickness_m;
    const Sky sky(scene);
    const double sun = sky.sun_up_there();
    return (sun + double{sky.day.sky_irradiance().g}) * (through + 0.2 * (1.0 - through)) /
               std::numbers::pi +
           sun * (cloud::forward_through(0.865, depth, std::cos(50.0 * deg)) -
                  std::exp(-(1.0 - 0.865 * 0.865) * depth) / std::numbers::pi);
  };
  EXPECT_NEAR(base(200.0), wanted(200.0), 0.02 * wanted(200.0));
  EXPECT_NEAR(base(1000.0), wanted(1000.0), 0.02 * wanted(1000.0));
  EXPECT_LT(base(1000.0), 0.6 * base(200.0));
}

/// Green of the places on a west-east line through the layer above the eye, a step apart.
std::vector<double> line_of_sky(const CloudySky& sky, double north_m, double step_m, int places) {
  std::vector<double> line;
  for (int i = 0; i < places; ++i)
    line.push_back(double{
        sky.radiance(glm::normalize(glm::dvec3((i - places / 2) * step_m, north_m, 2000.0))).g});
  return line;
}

// What stands on bases is farther away than these, and moves less across the sky: low heaps.
TEST_F(CloudySkies, MoveByMetresPerSecond) {
  constexpr double speed_m_s = 12.0, seconds = 20.0, step_m = 2.0;
  constexpr int places = 700, max = 200;
  scene::Scene scene = one_layer();
  scene.clouds[0].thickness_m = 100.0;
  scene.clouds[0].speed_m_s = speed_m_s;
  scene.clouds[0].heading_deg = 90.0;
  const Sky before(scene, 0.0), after(scene, seconds);
  std::vector<double> differences(max);
  for (const double north_m : {-900.0, -300.0, 400.0, 800.0}) {
    const auto first = line_of_sky(before.seen, north_m, step_m, places);
    const auto last = line_of_sky(after.seen, north_m, step_m, places);
    for (int shift = 0; shift < max; ++shift)
      for (int i = max; i < places; ++i) {
        const double d =
            last[static_cast<std::size_t>(i)] - first[static_cast<std::size_t>(i - shift)];
        differences[static_cast<std::size_t>(shift)] += d * d;
      }
  }
  const auto best = std::ranges::min_element(differences) - differences.begin();
  EXPECT_NEAR(static_cast<double>(best) * step_m / seconds, speed_m_s, 0.02 * speed_m_s);
  EXPECT_LT(differences[static_cast<std::size_t>(best)], 0.1 * differences[0]);
}

TEST_F(CloudySkies, AreOnTheirBackdropWhereTheCameraSeesThem) {
  const Sky sky(veil(0.4));
  const landscape::Camera camera{eye_m, eye_m + glm::dvec3(3.0, 10.0, 4.0), 70.0};
  constexpr double distance_m = 500.0;
  const landscape::Backdrop backdrop = sky_backdrop(sky.seen, camera, 160, 90, distance_m);
  const Image& picture = backdrop.picture;
  for (int y = 2; y < picture.height; y += 11)
    for (int x = 3; x < picture.width; x += 13) {
      const glm::dvec3 at = backdrop.corner_m + backdrop.right_m * ((x + 0.5) / picture.width) +
                            backdrop.up_m * (1.0 - (y + 0.5) / picture.height);
      const glm::vec3 wanted = sky.seen.radiance(glm::normalize(at - eye_m));
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(picture.pixel(x, y)[c], wanted[c], 0.002F * wanted[c]) << x << ' ' << y;
    }
  // Its middle lies on the axis, and its width sees more than the field of view.
  const glm::dvec3 middle = backdrop.corner_m + 0.5 * (backdrop.right_m + backdrop.up_m);
  EXPECT_NEAR(glm::distance(middle, eye_m + distance_m * glm::normalize(glm::dvec3(3, 10, 4))), 0.0,
              1e-6);
  EXPECT_GT(glm::length(backdrop.right_m), 2.0 * distance_m * std::tan(35.0 * deg));
  EXPECT_NEAR(glm::length(backdrop.right_m) / glm::length(backdrop.up_m),
              static_cast<double>(picture.width) / picture.height, 1e-9);
}

}  // namespace
}  // namespace wold::sky
