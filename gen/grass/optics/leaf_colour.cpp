#include "grass/optics/leaf_colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/colour.h"
#include "core/curve.h"
#include "core/parallel.h"
#include "grass/ageing/ageing_curves.h"
#include "grass/optics/coat.h"
#include "grass/optics/pigments.h"

namespace wold::grass {
namespace {

constexpr std::size_t table_size = 1025;

/// An albedo of 1 would scatter for ever.
constexpr double highest_albedo = 0.99;

// A turgid grass leaf: 240 % water of 0.005 g/cm2 dry mass (rice and maize of LOPEX93, Hosgood et
// al. 1994, hold 0.010 to 0.015 cm of water and 0.0044 to 0.0048 g/cm2).
constexpr double turgid_water_cm = 0.012;
constexpr double dry_mass_g_cm2 = 0.005;

// Living leaf and straw. Air fills the cells of a dead leaf (N rises), brown pigment forms and
// carotenoids, which outlast chlorophyll (Merzlyak and Gitelson 1995, Journal of Plant Physiology
// 145:315), bleach. How far is a modelling choice, made by the colour of straw.
constexpr double living_structure = 1.5;
constexpr double straw_structure = 2.0;
constexpr double straw_carotenoid = 0.3;

/// Fraction of the leaf that has died, by its water: none above 48 % of the dry mass (colouring
/// grass has 50 %, cured grass less than 30 %: Rothermel 1983, INT-143), all below 19 %.
double dead_fraction(double water) {
  const double t = std::clamp((0.20 - water) / (0.20 - 0.08), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Where R + T leaves the gamut (a yellow leaf's red is above 1), hue counts more than saturation.
LeafShade prospect_shade(const Observer& observer, const LeafSpectrum& leaf) {
  const glm::dvec3 reflected = observer.linear_srgb(leaf.reflectance);
  const glm::dvec3 transmitted = observer.linear_srgb(leaf.transmittance);
  return {in_gamut(reflected, highest_albedo), in_gamut(transmitted, highest_albedo),
          in_gamut(reflected + transmitted, highest_albedo)};
}

/// A leaf that lets no light through.
LeafSpectrum opaque(std::vector<double> reflectance) {
  std::vector<double> transmittance(reflectance.size(), 0.0);
  return {std::move(reflectance), std::move(transmittance)};
}

/// [TVT]'s colours are so pale that only clamping keeps their tint.
LeafShade paper_shade(const Observer& observer, const LeafSpectrum& leaf) {
  const glm::vec3 rgb = glm::clamp(observer.linear_srgb(leaf.reflectance), 0.0, highest_albedo);
  return {rgb, glm::vec3(0.0F), rgb};
}

}  // namespace

LeafContent withered_leaf(const scene::Physiology& ageing, double chlorophyll, double water) {
  const double dead = dead_fraction(water);
  LeafContent leaf;
  leaf.structure = std::lerp(living_structure, straw_structure, dead);
  leaf.chlorophyll_ug_cm2 = ageing.chlorophyll_ug_cm2 * chlorophyll;
  leaf.carotenoid_ug_cm2 = ageing.carotenoid_ug_cm2 * std::lerp(1.0, straw_carotenoid, dead);
  leaf.brown = ageing.brown_pigment * dead;
  leaf.water_cm = turgid_water_cm * water;
  leaf.dry_g_cm2 = dry_mass_g_cm2;
  return leaf;
}

LeafSpectrum withered_spectrum(const scene::Physiology& ageing, const LeafOptics& optics,
                               double chlorophyll, double water) {
  switch (ageing.colour) {
    case scene::ColourModel::prospect:
      return optics(withered_leaf(ageing, chlorophyll, water));
    case scene::ColourModel::paper:
      return opaque(paper_reflectance(optics.spectra(), chlorophyll));
    case scene::ColourModel::melanin:
      return hair_spectrum(ageing.fur, optics.spectra(), water);
  }
  return {};
}

LeafColour::LeafColour(const scene::Physiology& ageing) : table_(table_size) {
  const Curve water = load_curve(CurveKind::water, ageing.water);
  const Curve chlorophyll = load_curve(CurveKind::chlorophyll, ageing.chlorophyll);
  const LeafOptics optics(load_leaf_spectra());
  const std::vector<double>& wavelength_nm = optics.spectra().wavelength_nm;
  const Observer observer = load_observer(wavelength_nm.front(), wavelength_nm.back());
  const auto shade = ageing.colour == scene::ColourModel::paper ? paper_shade : prospect_shade;
  parallel_for(table_size, [&](std::size_t i) {
    const double weathering = static_cast<double>(i) / (table_size - 1);
    table_[i] = shade(
        observer, withered_spectrum(ageing, optics, chlorophyll(weathering), water(weathering)));
  });
}

LeafShade LeafColour::operator()(double weathering) const {
  const double position = std::clamp(weathering, 0.0, 1.0) * (table_size - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(position), table_size - 2);
  const auto t = static_cast<float>(position - static_cast<double>(i));
  const LeafShade& a = table_[i];
  const LeafShade& b = table_[i + 1];
  return {glm::mix(a.reflectance, b.reflectance, t), glm::mix(a.transmittance, b.transmittance, t),
          glm::mix(a.albedo, b.albedo, t)};
}

}  // namespace wold::grass
