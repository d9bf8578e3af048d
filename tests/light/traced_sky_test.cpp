#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "core/colour.h"
#include "light/air.h"
#include "light/air_columns.h"
#include "light/atmosphere.h"

/// The sky beside paths traced through the same air, with all orders of scattering, from the ground
/// to where they leave it; each scattering adds what the sun sends that way.
namespace wold::light {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180.0;
constexpr double turbidity = 2.5, ground_albedo = 0.2;

class Dice {
 public:
  double operator()() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 bits_{7};
};

/// A unit vector at an angle of that cosine to another one.
glm::dvec3 turned(const glm::dvec3& from, double cosine, double around) {
  const glm::dvec3 other = std::abs(from.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(other, from)), v = glm::cross(from, u);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return u * (sine * std::cos(around)) + v * (sine * std::sin(around)) + from * cosine;
}

/// Cosines as often as a phase function has them.
class PhaseCosines {
 public:
  explicit PhaseCosines(double (*phase)(double)) {
    for (int i = 0; i < steps; ++i) sums_.push_back(sums_.back() + phase(-1.0 + (i + 0.5) * step));
  }
  double at(double fraction) const {
    const auto above =
        std::upper_bound(sums_.begin() + 1, sums_.end() - 1, fraction * sums_.back());
    const double part = (fraction * sums_.back() - *(above - 1)) / (*above - *(above - 1));
    return -1.0 + step * (static_cast<double>(above - sums_.begin() - 1) + part);
  }

 private:
  static constexpr int steps = 20000;
  static constexpr double step = 2.0 / steps;
  std::vector<double> sums_{0.0};
};

class TracedSky {
 public:
  explicit TracedSky(double sun_deg) {
    const double sun_rad = columns_.elevation_without_air_rad(sun_deg * degree);
    to_sun_ = {std::cos(sun_rad), 0.0, std::sin(sun_rad)};
    for (std::size_t w = 0; w < wavelengths; ++w) {
      Spectrum one{};
      one[w] = 1.0;
      weights_[w] = luminance(SunSpectrum().klx(one));
      all_ += weights_[w];
    }
  }

  /// Illuminance of level ground by the sky.
  double klx(int paths) {
    double sum = 0.0;
    for (int i = 0; i < paths; ++i)
      sum += along(turned({0.0, 0.0, 1.0}, std::sqrt(dice_()), 2.0 * pi * dice_()));
    return pi * sum / paths;
  }

  /// Luminance in a direction.
  double kcd_m2(const glm::dvec3& to, int paths) {
    double sum = 0.0;
    for (int i = 0; i < paths; ++i) sum += along(to);
    return sum / paths;
  }

 private:
  double along(glm::dvec3 to) {
    const std::size_t w = wavelength();
    glm::dvec3 at(0.0, 0.0, ground_radius_m + 2.0);
    double weight = all_, sum = 0.0;
    for (int order = 1; order < 60; ++order) {
      const double height_m = glm::length(at) - ground_radius_m;
      const WayEnd end = way_end(std::max(height_m, 0.0), glm::dot(at, to) / glm::length(at));
      if (const auto met_m = meets(at, to, end.length_m, w)) {
        at += to * *met_m;
        sum += scatter(at, to, weight, w);
      } else if (end.on_ground) {
        at = glm::normalize(at + to * end.length_m) * (ground_radius_m + 1.0);
        weight *= ground_albedo;
        const double cosine = glm::dot(glm::normalize(at), to_sun_);
        sum += weight * std::max(cosine, 0.0) / pi * sunlight(at, w);
        to = turned(glm::normalize(at), std::sqrt(dice_()), 2.0 * pi * dice_());
      } else {
        break;
      }
    }
    return sum;
  }

  std::size_t wavelength() {
    double left = dice_() * all_;
    std::size_t w = 0;
    while (w + 1 < wavelengths && left > weights_[w]) left -= weights_[w++];
    return w;
  }

  /// How far it is to where the path meets air that scatters or absorbs: Woodcock 1965, with the
  /// most that is met within 3 km of height.
  std::optional<double> meets(const glm::dvec3& at, const glm::dvec3& to, double length_m,
                              std::size_t w) {
    constexpr double stretch_m = 3000.0;
    double gone_m = 0.0;
    while (true) {
      const glm::dvec3 here = at + to * gone_m;
      const double up = std::abs(glm::dot(here, to)) / glm::length(here);
      AirAmounts most = air_at(std::max(glm::length(here) - ground_radius_m - stretch_m, 0.0));
      most.ozone = 1.0;
      const double most_per_m = air_.extinction_per_m(most)[w];
      const double step_m = -std::log(1.0 - dice_()) / most_per_m;
      const double longest_m = stretch_m / std::max(up, 0.05);
      gone_m += std::min(step_m, longest_m);
      if (gone_m >= length_m) return std::nullopt;
      if (step_m > longest_m) continue;
      if (dice_() * most_per_m < air_.extinction_per_m(amounts(at + to * gone_m))[w]) return gone_m;
    }
  }

  static AirAmounts amounts(const glm::dvec3& at) {
    return air_at(std::max(glm::length(at) - ground_radius_m, 0.0));
  }

  /// What comes from the sun by this scattering; the path goes on another way with less weight.
  double scatter(const glm::dvec3& at, glm::dvec3& to, double& weight, std::size_t w) {
    const AirAmounts here = amounts(at);
    const double molecules = air_.molecules_scattering_per_m(here)[w];
    const double aerosol = air_.aerosol_scattering_per_m(here)[w];
    weight *= (molecules + aerosol) / air_.extinction_per_m(here)[w];
    const double of_molecules = molecules / (molecules + aerosol), cosine = glm::dot(to, to_sun_);
    const double sent =
        of_molecules * rayleigh_phase(cosine) + (1.0 - of_molecules) * aerosol_phase(cosine);
    const PhaseCosines& phase = dice_() < of_molecules ? by_molecules_ : by_aerosol_;
    to = turned(to, phase.at(dice_()), 2.0 * pi * dice_());
    return weight * sent * sunlight(at, w);
  }

  double sunlight(const glm::dvec3& at, std::size_t w) const {
    const auto ray = columns_.from_sun(glm::length(at) - ground_radius_m,
                                       glm::dot(at, to_sun_) / glm::length(at));
    return ray ? ray->brightness * air_.transmittance(ray->on_way_m)[w] : 0.0;
  }

  Air air_{turbidity};
  AirColumns columns_;
  PhaseCosines by_molecules_{rayleigh_phase}, by_aerosol_{aerosol_phase};
  std::array<double, wavelengths> weights_{};
  double all_ = 0.0;
  glm::dvec3 to_sun_{0.0};
  Dice dice_;
};

double sky_kcd_m2(const Atmosphere& air, double sun_deg, double elevation_deg, double azimuth_deg) {
  const double e = elevation_deg * degree, s = sun_deg * degree, a = azimuth_deg * degree;
  const double cosine = std::sin(e) * std::sin(s) + std::cos(e) * std::cos(s) * std::cos(a);
  return luminance(air.sky_kcd_m2(e, a, std::clamp(cosine, -1.0, 1.0)));
}

TEST(TracedSky, LightsTheGroundAlike) {
  for (const double sun_deg : {60.0, 30.0, 10.0, 2.0, -2.0}) {
    const Atmosphere air(sun_deg * degree, turbidity);
    double klx = 0.0;
    for (double e = 0.5; e < 90.0; e += 1.0)
      for (double a = 1.5; a < 180.0; a += 3.0)
        klx += sky_kcd_m2(air, sun_deg, e, a) * std::sin(e * degree) * std::cos(e * degree);
    klx *= 6.0 * degree * degree;
    const double traced_klx = TracedSky(sun_deg).klx(120000);
    EXPECT_NEAR(klx, traced_klx, 0.08 * traced_klx) << sun_deg;
  }
}

TEST(TracedSky, IsAsBrightInDirections) {
  struct Look {
    double sun_deg, elevation_deg, azimuth_deg, within;
  };
  for (const Look& look :
       {Look{40.0, 90.0, 0.0, 0.05}, Look{40.0, 45.0, 180.0, 0.05}, Look{40.0, 45.0, 0.0, 0.05},
        Look{40.0, 15.0, 45.0, 0.08}, Look{40.0, 5.0, 180.0, 0.05}, Look{40.0, 1.0, 90.0, 0.1},
        Look{60.0, 1.0, 0.0, 0.1}, Look{10.0, 1.0, 90.0, 0.12}, Look{10.0, 3.0, 180.0, 0.08},
        Look{5.0, 90.0, 0.0, 0.06}, Look{5.0, 45.0, 180.0, 0.08}, Look{5.0, 15.0, 0.0, 0.1},
        Look{5.0, 5.0, 0.0, 0.1}, Look{5.0, 1.0, 90.0, 0.2}}) {
    const double e = look.elevation_deg * degree, a = look.azimuth_deg * degree;
    const glm::dvec3 to(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    const double traced = TracedSky(look.sun_deg).kcd_m2(to, 60000);
    EXPECT_NEAR(sky_kcd_m2(Atmosphere(look.sun_deg * degree, turbidity), look.sun_deg,
                           look.elevation_deg, look.azimuth_deg),
                traced, look.within * traced)
        << look.sun_deg << " " << look.elevation_deg << " " << look.azimuth_deg;
  }
}

}  // namespace
}  // namespace wold::light
