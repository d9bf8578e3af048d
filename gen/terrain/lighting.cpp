#include "terrain/lighting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/angle.h"
#include "core/colour.h"
#include "core/elementary.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "terrain/horizon.h"
#include "terrain/land_shadow.h"
#include "terrain/relief.h"
#include "terrain/rock.h"
#include "terrain/soil.h"
#include "terrain/sun_disc.h"
#include "terrain/surface.h"

namespace wold::terrain {
namespace {

using std::numbers::pi;

/// The sky cut into patches: azimuths times bands of elevation.
struct SkyPatches {
  static constexpr int azimuths = 16;
  static constexpr int bands = 18;
  static constexpr double band_rad = 0.5 * pi / bands;

  struct Patch {
    glm::dvec3 direction;
    glm::dvec4 power;  ///< radiance times solid angle: of the clear sky, and of an overcast one
  };
  std::vector<Patch> patches;  ///< azimuth by azimuth, bands upwards

  explicit SkyPatches(const light::Daylight& day) {
    for (int a = 0; a < azimuths; ++a)
      for (int b = 0; b < bands; ++b) {
        const double elevation_rad = (b + 0.5) * band_rad;
        const glm::dvec3 to = light::direction_of(azimuth_rad(a), elevation_rad);
        const double solid_angle = math::cos(elevation_rad) * band_rad * 2.0 * pi / azimuths;
        const glm::dvec4 radiance(glm::dvec3(day.sky_radiance(to)), 1.0 + 2.0 * to.z);
        patches.push_back({to, radiance * solid_angle});
      }
  }

  static double azimuth_rad(int a) { return 2.0 * pi * a / azimuths; }
};

/// Level, towards an azimuth.
glm::dvec2 level_direction(double azimuth_rad) {
  return glm::dvec2(light::direction_of(azimuth_rad, 0.0));
}

/// The terrain's horizons towards the sky's patches, azimuth by azimuth.
Horizons horizons_of_sky(const Heightfield& terrain) {
  std::vector<glm::dvec2> directions;
  for (int a = 0; a < SkyPatches::azimuths; ++a)
    directions.push_back(level_direction(SkyPatches::azimuth_rad(a)));
  return {terrain, std::move(directions), 0.12};
}

/// Fraction of a band of elevations that lies above the horizon; continuous, so nothing steps.
double fraction_above(int band, double horizon) {
  return std::clamp(band + 1.0 - horizon / SkyPatches::band_rad, 0.0, 1.0);
}

/// By the clear sky, and by an overcast one.
glm::dvec4 sky_light(const Horizons& horizons, const glm::dvec2& at_m, const glm::dvec3& up,
                     const SkyPatches& sky) {
  constexpr double level = 0.0;  // no patch lies below
  glm::dvec4 sum(0.0);
  auto patch = sky.patches.begin();
  for (std::size_t a = 0; a < horizons.directions(); ++a) {
    const double horizon = horizons.elevation_rad(a, at_m, level);
    for (int b = 0; b < SkyPatches::bands; ++b, ++patch)
      sum += patch->power *
             (std::max(0.0, glm::dot(up, patch->direction)) * fraction_above(b, horizon));
  }
  return sum;
}

/// What hides the sun from places on the terrain: its own ground and the land around.
class SunHiding {
 public:
  SunHiding(const Heightfield& terrain, const glm::dvec3& to_sun, const LandShadow* around)
      : terrain_(&terrain),
        elevation_rad_(math::asin(to_sun.z)),
        horizons_(terrain, azimuths(to_sun), 0.02),
        around_(around) {}

  /// Fraction of the sun's disc that is seen from the ground.
  double seen(const glm::dvec2& at_m) const {
    const double over_terrain = seen_over_terrain(at_m);
    if (around_ == nullptr || over_terrain <= 0.0) return over_terrain;
    return std::min(over_terrain, around_->sun_seen({at_m, terrain_->sample(at_m.x, at_m.y)}));
  }

 private:
  static std::vector<glm::dvec2> azimuths(const glm::dvec3& to_sun) {
    const double azimuth_rad = math::atan2(to_sun.x, to_sun.y);
    std::vector<glm::dvec2> directions;
    for (const double offset_rad : sun_disc::offsets_rad)
      directions.push_back(level_direction(azimuth_rad + offset_rad));
    return directions;
  }

  double seen_over_terrain(const glm::dvec2& at_m) const {
    double seen = 0.0;
    for (std::size_t i = 0; i < horizons_.directions(); ++i) {
      const double above = elevation_rad_ - horizons_.elevation_rad(i, at_m, below_sun_);
      seen += sun_disc::seen(0.5 + 0.5 * above / sun_disc::half_width_rad) /
              static_cast<double>(horizons_.directions());
    }
    return seen;
  }

  const Heightfield* terrain_;
  double elevation_rad_;
  Horizons horizons_;
  const LandShadow* around_;
  /// What is less steep hides nothing of the disc.
  double below_sun_ = math::tan(elevation_rad_ - 1.01 * sun_disc::half_width_rad);
};

glm::dvec3 sun_light(const SunHiding& hiding, const glm::dvec2& at_m, const glm::dvec3& up,
                     const light::Daylight& day) {
  const double lambert = glm::dot(up, day.sun_direction());
  if (lambert <= 0.0) return glm::dvec3(0.0);
  return glm::dvec3(day.sun_irradiance()) * (lambert * hiding.seen(at_m));
}

/// Irradiance of level ground under nothing but the patches: what the sum over patches makes of
/// the sky's irradiance.
glm::dvec4 flat_sky_light(const SkyPatches& sky) {
  glm::dvec4 sum(0.0);
  for (const SkyPatches::Patch& patch : sky.patches) sum += patch.power * patch.direction.z;
  return sum;
}

/// The keyed fields that colour the ground.
struct GroundColour {
  static constexpr double border_m = 1.5;

  Soil soil;
  glm::vec3 rock_albedo;
  Rock rock;
  double rock_slope_deg;
  Fbm border;
  double border_shown;  ///< fraction of it that the map shows

  GroundColour(const scene::Terrain& terrain, std::uint64_t seed, double step_m)
      : soil(terrain, seed, step_m),
        rock_albedo(terrain.rock_albedo[0], terrain.rock_albedo[1], terrain.rock_albedo[2]),
        rock(rock_albedo, seed, step_m),
        rock_slope_deg(terrain.rock_slope_deg),
        border{random_bits({seed, key_of("ground"), 0, key_of("border")}), 6, 0.95},
        border_shown(shown_fraction(border_m, step_m)) {}

  /// Of a place, and what it is there on the mean.
  struct Albedo {
    glm::vec3 here, mean;
    /// How much brighter than the mean the place is.
    float detail() const {
      return static_cast<float>(luminance(here) / std::max(luminance(mean), 1e-6));
    }
  };

  Albedo debris(const glm::dvec3& place_m, const glm::dvec3& up, const glm::dvec3& to_sun) const {
    return {rock.debris_at(place_m, up, to_sun), rock_albedo};
  }

  /// Rock shows where it is steep, over 5 degrees and along a ragged border, sooner where it stands
  /// out, and where no grass holds soil on it. `trodden`: Surface::worn().
  Albedo albedo(const glm::dvec3& place_m, const glm::dvec3& up, const glm::dvec3& to_sun,
                double exposure, float growth, double trodden) const {
    constexpr double paler = 0.35;  // trodden soil is dry and smooth; a modelling choice
    const glm::dvec2 at_m(place_m);
    const double beyond =
        beyond_rock_deg(math::acos(up.z) / radians_per_degree, exposure, rock_slope_deg);
    const glm::vec3& mean = soil.mean_albedo();
    const float no_brighter = std::max(1.0F, 1.0F / std::max({mean.r, mean.g, mean.b, 1e-6F}));
    const float worn = std::min(static_cast<float>(1.0 + paler * trodden), no_brighter);
    const Albedo earth{worn * soil.at(at_m, up, to_sun), worn * mean};
    if (beyond < -8.0) return earth;
    const double ragged = beyond + 2.5 * border_shown * border.at(at_m / border_m);
    const double bare = (1.0 - double{growth}) * glm::smoothstep(-2.5, 2.5, ragged);
    if (bare <= 0.0) return earth;
    const auto share = static_cast<float>(bare);
    return {glm::mix(earth.here, rock.at(place_m, up, to_sun), share),
            glm::mix(earth.mean, rock_albedo, share)};
  }
};

/// Ground of which a share is bare, in the colour that a cover gives to that.
glm::vec3 covered(const GroundColour::Albedo& albedo, const LandCover::Shares& cover, float bare) {
  const auto own = static_cast<float>(1.0 - cover.coloured * double{bare});
  return own * albedo.here + (bare * albedo.detail()) * cover.albedo;
}

GroundLight smoothed_light(const Heightfield& terrain, const light::Daylight& day,
                           const GroundGrid& grid, int passes, const LandShadow* around,
                           const RowParts& parts) {
  const ColourMap dark(grid.samples, grid.square);
  GroundLight light{dark, dark, FactorMap(grid.samples, grid.square)};
  const SkyPatches sky(day);
  const Horizons horizons = horizons_of_sky(terrain);
  const SunHiding hiding(terrain, day.sun_direction(), around);
  const glm::dvec4 sky_scale =
      glm::dvec4(glm::dvec3(day.sky_irradiance()), 1.0) / flat_sky_light(sky);
  parallel_for(static_cast<std::size_t>(dark.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(parts[row], [&](int i) {
      const glm::dvec2 at_m = dark.place_m(i, j);
      const glm::dvec3 up = normal(terrain, at_m.x, at_m.y);
      light.sun.at(i, j) = glm::vec3(sun_light(hiding, at_m, up, day));
      const glm::vec4 by_sky(sky_light(horizons, at_m, up, sky) * sky_scale);
      light.sky.at(i, j) = glm::vec3(by_sky);
      light.overcast.at(i, j) = by_sky.w;
    });
  });
  for (int pass = 0; pass < passes; ++pass) {
    smooth(light.sun);
    smooth(light.sky);
    smooth(light.overcast);
  }
  return light;
}

}  // namespace

ColourMap GroundLight::together() const {
  ColourMap sum = sun;
  for (std::size_t i = 0; i < sum.values().size(); ++i) sum.values()[i] += sky.values()[i];
  return sum;
}

GroundLight ground_light(const Heightfield& terrain, const light::Daylight& day,
                         const LandShadow* around) {
  // Steps finer than half of the terrain's would show nothing more and cost their square.
  const double step_m = std::max(0.2, 0.5 * terrain.step_m());
  const GroundGrid grid = {{.size_m = terrain.size_m()}, map_samples(terrain.size_m(), step_m)};
  // Grass takes its light from about its own height around: a deviation of 0.28 m, 4 passes of
  // 0.2 m.
  const double passes = 4.0 * 0.2 * 0.2 / (step_m * step_m);
  return smoothed_light(terrain, day, grid, std::max(1, static_cast<int>(std::lround(passes))),
                        around, whole_rows(grid.samples));
}

GroundLight ground_light(const Heightfield& terrain, const light::Daylight& day,
                         const GroundGrid& grid, const LandShadow* around, const RowParts& parts,
                         bool smoothed) {
  return smoothed_light(terrain, day, grid, /*passes=*/smoothed ? 1 : 0, around,
                        parts.empty() ? whole_rows(grid.samples) : parts);
}

ColourMap ground_reflectance(const Surface& surface, const glm::dvec3& sun_direction,
                             const scene::Terrain& look, std::uint64_t seed,
                             const FactorMap& growth) {
  const GroundGrid& grid = surface.grid();
  ColourMap map(grid.samples, grid.square);
  const GroundColour colour(look, seed, grid.step_m());
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(surface.part(j), [&](int i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      const float grown = growth.sample(at_m.x, at_m.y);
      const glm::dvec3 place_m(at_m, surface.height_m(i, j));
      const LandCover::Shares cover = surface.cover(i, j);
      glm::vec3 land = covered(colour.albedo(place_m, surface.up(i, j), sun_direction,
                                             surface.exposure(i, j), grown, surface.worn(i, j)),
                               cover, 1.0F - grown);
      if (const double scree = surface.scree(i, j) * (1.0 - double{grown}); scree > 0.0)
        land = glm::mix(
            land, covered(colour.debris(place_m, surface.up(i, j), sun_direction), cover, 1.0F),
            static_cast<float>(scree));
      if (const NearbyBoulders::Rise boulder = surface.boulder(i, j); boulder.cover > 0.0)
        land = glm::mix(land,
                        colour.rock.boulder_at(place_m + glm::dvec3(0.0, 0.0, boulder.height_m),
                                               surface.up(i, j), sun_direction),
                        static_cast<float>(boulder.cover));
      map.at(i, j) = glm::mix(land, water_albedo, static_cast<float>(surface.water(i, j))) *
                     static_cast<float>(1.0 / pi);
    });
  });
  return map;
}

}  // namespace wold::terrain
