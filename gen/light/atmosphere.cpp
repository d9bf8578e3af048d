#include "light/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/interpolation.h"
#include "core/parallel.h"
#include "light/air.h"
#include "light/air_columns.h"

namespace wold::light {
namespace {

using std::numbers::pi;

constexpr double eye_height_m = 2.0;
constexpr double ground_albedo = 0.2;  // meadows, woods and fields

// The table of lines of sight: elevations close to each other at the horizon.
constexpr int elevations = 60, azimuths = 17, line_steps = 32;

double elevation_of(int step) {
  const double part = static_cast<double>(step) / (elevations - 1);
  return 0.5 * pi * part * part * part;
}

/// A place on a way through the air, and how the sun stands there.
struct Place {
  double height_m;
  double sun_cosine;  ///< of its zenith angle without air
};

/// A straight way from a height: `up` is the cosine of its zenith angle, `to_sun` of its angle to
/// the sun, `sun_up` of the sun's zenith angle where it begins.
struct Way {
  double height_m, up, to_sun, sun_up;

  Place at(double length_m) const {
    const double there_m = height_along_m(height_m, up, length_m);
    const double along_sun_m = (ground_radius_m + height_m) * sun_up + length_m * to_sun;
    return {there_m, std::clamp(along_sun_m / (ground_radius_m + there_m), -1.0, 1.0)};
  }
};

/// What scattering needs to know of the air and of the sun's light in it.
struct LitAir {
  const AirColumns& columns;
  Air air;  ///< that light goes through

  /// The fraction of the sun's light that arrives.
  Spectrum sunlight(const Place& place) const {
    const auto ray = columns.from_sun(place.height_m, place.sun_cosine);
    if (!ray) return {};
    Spectrum fraction = air.transmittance(ray->on_way_m);
    for (double& of_wavelength : fraction) of_wavelength *= ray->brightness;
    return fraction;
  }
};

/// The same for every air: made when it is first asked for.
const AirColumns& air_columns() {
  static const AirColumns columns;
  return columns;
}

/// Goes along a way in steps: visit(place, its air's densities, the step's length in metres as it
/// is seen from the beginning, by wavelength). Returns the transmittance to the end.
template <class Visit>
Spectrum go_along(const Air& air, const Way& way, double length_m, int steps, const Visit& visit) {
  Spectrum through;
  through.fill(1.0);
  for (int i = 0; i < steps; ++i) {
    const double from = 1.0 * i / steps, to = (i + 1.0) / steps;
    const double begin_m = from * from * length_m, step_m = to * to * length_m - begin_m;
    const Place place = way.at(begin_m + 0.5 * step_m);
    const AirAmounts amounts = air_at(place.height_m);
    const Spectrum extinction = air.extinction_per_m(amounts);
    Spectrum seen_m;
    for (std::size_t w = 0; w < wavelengths; ++w) {
      const double hidden = -math::expm1(-extinction[w] * step_m);
      seen_m[w] = extinction[w] > 0.0 ? through[w] * hidden / extinction[w] : step_m * through[w];
      through[w] *= 1.0 - hidden;
    }
    visit(place, amounts, seen_m);
  }
  return through;
}

/// Light that was scattered more than once, per unit of the sun's: tabulated by height and by the
/// sun's elevation, as far as it changes along lines of sight from one place.
class OftenScattered {
 public:
  OftenScattered(const LitAir& lit, double sun_elevation_rad)
      : lowest_sun_rad_(sun_elevation_rad - 0.5 * suns_rad), values_(std::size_t{heights} * suns) {
    parallel_for(values_.size(), [&](std::size_t i) {
      const double sun_rad =
          lowest_sun_rad_ + suns_rad * static_cast<double>(i % suns) / (suns - 1);
      values_[i] = at_place(lit, {height_of(static_cast<int>(i / suns)), math::sin(sun_rad)});
    });
  }

  Spectrum at(const Place& place) const {
    const double row = std::sqrt(std::clamp(place.height_m / air_top_m, 0.0, 1.0)) * (heights - 1);
    const double sun_rad = math::asin(place.sun_cosine);
    const double column = std::clamp((sun_rad - lowest_sun_rad_) / suns_rad, 0.0, 1.0) * (suns - 1);
    const int i = std::min(static_cast<int>(row), heights - 2);
    const int j = std::min(static_cast<int>(column), suns - 2);
    const double u = row - i, v = column - j;
    const auto value = [&](int k, int l) -> const Spectrum& {
      return values_[static_cast<std::size_t>(k) * suns + static_cast<std::size_t>(l)];
    };
    Spectrum mean;
    for (std::size_t w = 0; w < wavelengths; ++w)
      mean[w] = bilinear(value(i, j)[w], value(i, j + 1)[w], value(i + 1, j)[w],
                         value(i + 1, j + 1)[w], v, u);
    return mean;
  }

 private:
  static constexpr int heights = 12, suns = 13;
  static constexpr double suns_rad = 0.42;  // 12 degrees to each side: 1300 km

  static double height_of(int step) {
    const double part = static_cast<double>(step) / (heights - 1);
    return part * part * air_top_m;
  }

  /// Radiance of the second time, and the fraction of light that comes back from all around each
  /// time more: their sum has no end (Hillaire 2020, equations 5 to 10).
  static Spectrum at_place(const LitAir& lit, const Place& place) {
    constexpr int rings = 8, sides = 6, steps = 16;
    Spectrum second{}, again{};
    for (int ring = 0; ring < rings; ++ring)
      for (int side = 0; side < sides; ++side)
        add_from(lit, way_of(place, (ring + 0.5) * 2.0 / rings - 1.0, (side + 0.5) * pi / sides),
                 steps, second, again);
    constexpr double directions = rings * sides;
    Spectrum sum;
    for (std::size_t w = 0; w < wavelengths; ++w)
      sum[w] = second[w] / directions / (1.0 - again[w] / directions);
    return sum;
  }

  static Way way_of(const Place& place, double up, double from_sun_rad) {
    const double level = std::sqrt(1.0 - up * up);
    const double sun_level = std::sqrt(1.0 - place.sun_cosine * place.sun_cosine);
    return {place.height_m, up, up * place.sun_cosine + level * sun_level * math::cos(from_sun_rad),
            place.sun_cosine};
  }

  static void add_from(const LitAir& lit, const Way& way, int steps, Spectrum& second,
                       Spectrum& again) {
    constexpr double even = 0.25 / pi;
    const WayEnd end = way_end(way.height_m, way.up);
    const Spectrum through =
        go_along(lit.air, way, end.length_m, steps,
                 [&](const Place& place, const AirAmounts& amounts, const Spectrum& seen_m) {
                   const Spectrum sunlight = lit.sunlight(place);
                   const Spectrum molecules = lit.air.molecules_scattering_per_m(amounts);
                   const Spectrum aerosol = lit.air.aerosol_scattering_per_m(amounts);
                   for (std::size_t w = 0; w < wavelengths; ++w) {
                     const double scattered = (molecules[w] + aerosol[w]) * seen_m[w];
                     second[w] += even * scattered * sunlight[w];
                     again[w] += scattered;
                   }
                 });
    if (!end.on_ground) return;
    const Place there = way.at(end.length_m);
    const Spectrum sunlight = lit.sunlight({0.0, there.sun_cosine});
    const double lit_fraction = std::max(there.sun_cosine, 0.0) * ground_albedo / pi;
    for (std::size_t w = 0; w < wavelengths; ++w)
      second[w] += through[w] * lit_fraction * sunlight[w];
  }

  double lowest_sun_rad_;
  std::vector<Spectrum> values_;
};

/// What a line of sight gains of light per unit of the sun's, by kind of scattering.
struct GainedSpectra {
  Spectrum molecules{}, aerosol{}, aerosol_again{}, often{};
};

/// What aerosol scatters once on its way to the eye, the sun's light of which nothing came in
/// before by forward scattering.
Spectrum gained_of_aerosol(const LitAir& lit, const Way& way, double length_m) {
  Spectrum gained{};
  go_along(lit.air, way, length_m, line_steps,
           [&](const Place& place, const AirAmounts& amounts, const Spectrum& seen_m) {
             const Spectrum sunlight = lit.sunlight(place);
             const Spectrum aerosol = lit.air.aerosol_scattering_per_m(amounts);
             for (std::size_t w = 0; w < wavelengths; ++w)
               gained[w] += aerosol[w] * seen_m[w] * sunlight[w];
           });
  return gained;
}

/// Of what aerosol scatters nearly straight on into a line of sight, the fraction that comes from
/// the sky. At the horizon half of that lobe looks at the ground, which is dark beside the sky; the
/// lobe has left the ground some 10 degrees higher.
double forward_from_sky(double up) { return 1.0 - 0.5 * math::exp(-up / 0.1); }

/// `lit` has the whole air, `on` that without forward peak.
GainedSpectra gained_along(const LitAir& lit, const LitAir& on, const OftenScattered& often,
                           const Way& way) {
  const double length_m = way_end(way.height_m, way.up).length_m;
  GainedSpectra gained;
  const Air seen_through = lit.air.without_forward_peak(forward_from_sky(way.up));
  go_along(seen_through, way, length_m, line_steps,
           [&](const Place& place, const AirAmounts& amounts, const Spectrum& seen_m) {
             const Spectrum sunlight = on.sunlight(place), around = often.at(place);
             const Spectrum molecules = on.air.molecules_scattering_per_m(amounts);
             const Spectrum aerosol = on.air.aerosol_scattering_per_m(amounts);
             for (std::size_t w = 0; w < wavelengths; ++w) {
               gained.molecules[w] += molecules[w] * seen_m[w] * sunlight[w];
               gained.aerosol_again[w] +=
                   aerosol[w] / (1.0 - forward_fraction) * seen_m[w] * sunlight[w];
               gained.often[w] += (molecules[w] + aerosol[w]) * seen_m[w] * around[w];
             }
           });
  gained.aerosol = gained_of_aerosol(lit, way, length_m);
  for (std::size_t w = 0; w < wavelengths; ++w) gained.aerosol_again[w] -= gained.aerosol[w];
  return gained;
}

/// aerosol_phase() of light that was scattered forward before, Henyey and Greenstein 1941: its
/// asymmetry is that of the first scattering, squared.
double blurred_aerosol_phase(double cosine) {
  constexpr double g = 0.702 * 0.702;
  const double base = 1.0 + g * g - 2.0 * g * cosine;
  return 0.25 / pi * (1.0 - g * g) / (base * std::sqrt(base));
}

/// What is seen of the sun's disc over the horizon.
struct SeenDisc {
  double fraction;
  double elevation_rad;  ///< of its middle
};

/// `over_rad`: how far the disc's middle stands over the horizon. A circle that a line cuts.
SeenDisc seen_disc(double elevation_rad, double over_rad) {
  constexpr double radius_rad = 0.00465;
  const double over = std::clamp(over_rad / radius_rad, -1.0, 1.0);
  if (over == 1.0) return {1.0, elevation_rad};
  const double fraction = 0.5 + (over * std::sqrt(1.0 - over * over) + math::asin(over)) / pi;
  const double middle_over_rad = 0.5 * radius_rad * (1.0 + over);
  return {fraction, elevation_rad - over_rad + middle_over_rad};
}

/// How far below the level the horizon lies, seen from a height.
double horizon_dip_rad(double height_m) {
  return math::acos(ground_radius_m / (ground_radius_m + std::max(height_m, 0.0)));
}

}  // namespace

glm::dvec3 sunlight_klx(double sun_elevation_rad, double turbidity, double height_m) {
  const SeenDisc disc = seen_disc(sun_elevation_rad, sun_elevation_rad + horizon_dip_rad(height_m));
  if (disc.fraction <= 0.0) return glm::dvec3(0.0);
  const auto way = air_columns().to_space_m(height_m, math::sin(disc.elevation_rad));
  if (!way) return glm::dvec3(0.0);
  return disc.fraction * SunSpectrum().klx(Air(turbidity).transmittance(*way));
}

Atmosphere::Atmosphere(double sun_elevation_rad, double turbidity)
    : gained_(std::size_t{elevations} * azimuths),
      sun_elevation_rad_(sun_elevation_rad),
      turbidity_(turbidity) {
  const Air air(turbidity);
  const LitAir lit{air_columns(), air}, on{air_columns(), air.without_forward_peak()};
  const double sun_rad = lit.columns.elevation_without_air_rad(sun_elevation_rad);
  const OftenScattered often(on, sun_rad);
  const SunSpectrum sun;
  const double sun_up = math::sin(sun_rad), sun_level = math::cos(sun_rad);
  parallel_for(std::size_t{elevations}, [&](std::size_t row) {
    const double elevation_rad = elevation_of(static_cast<int>(row));
    const double up = math::sin(elevation_rad), level = math::cos(elevation_rad);
    for (int i = 0; i < azimuths; ++i) {
      const double to_sun = up * sun_up + level * sun_level * math::cos(pi * i / (azimuths - 1));
      const GainedSpectra gained = gained_along(lit, on, often, {eye_height_m, up, to_sun, sun_up});
      gained_[row * azimuths + static_cast<std::size_t>(i)] = {
          sun.klx(gained.molecules), sun.klx(gained.aerosol), sun.klx(gained.aerosol_again),
          sun.klx(gained.often)};
    }
  });
}

glm::dvec3 Atmosphere::sky_kcd_m2(double elevation_rad, double from_sun_rad, double cosine) const {
  const double row =
      math::cbrt(std::clamp(elevation_rad / (0.5 * pi), 0.0, 1.0)) * (elevations - 1);
  const double column = std::clamp(from_sun_rad / pi, 0.0, 1.0) * (azimuths - 1);
  const int i = std::min(static_cast<int>(row), elevations - 2);
  const int j = std::min(static_cast<int>(column), azimuths - 2);
  const double u = row - i, v = column - j;
  const auto value = [&](int k, int l) {
    const Gained& gained =
        gained_[static_cast<std::size_t>(k) * azimuths + static_cast<std::size_t>(l)];
    return gained.molecules * rayleigh_phase(cosine) + gained.aerosol * aerosol_phase(cosine) +
           gained.aerosol_again * blurred_aerosol_phase(cosine) + gained.often;
  };
  return bilinear(value(i, j), value(i, j + 1), value(i + 1, j), value(i + 1, j + 1), v, u);
}

}  // namespace wold::light
