#include "grass/optics/flower_colour.h"

#include <cstddef>

#include "core/files.h"
#include "grass/ageing/model_table.h"
#include "grass/optics/pigments.h"

namespace wold::grass {
namespace {

// Thin and full of water; dry ones are brown as dead leaves are (modelling choices).
constexpr double fresh_water_cm = 0.012;
constexpr double dry_mass_g_cm2 = 0.003;
constexpr double withered_brown = 1.2;

LeafContent fresh_petal(scene::PetalColour colour) {
  const ModelTable table(shipped_file("models/flower/petals.toml"));
  const auto number = [&](const char* column) {
    return table.column(column, words_of(colour).size())[static_cast<std::size_t>(colour)];
  };
  LeafContent petal;
  petal.structure = number("structure");
  petal.pigment = number("pigment");
  petal.pigment_nm = number("pigment_nm");
  petal.water_cm = fresh_water_cm;
  petal.dry_g_cm2 = dry_mass_g_cm2;
  return petal;
}

LeafContent brown(LeafContent petal) {
  petal.pigment = 0.0;
  petal.brown = withered_brown;
  petal.water_cm = 0.0;
  return petal;
}

/// Flowers are known by their saturation: what leaves the gamut is cut off, channel by channel.
LeafShade petal_shade(const Observer& observer, const LeafSpectrum& petal) {
  constexpr double highest_albedo = 0.97;
  const glm::dvec3 reflected = glm::max(observer.linear_srgb(petal.reflectance), 0.0);
  const glm::dvec3 transmitted = glm::max(observer.linear_srgb(petal.transmittance), 0.0);
  const glm::dvec3 all = glm::max(reflected + transmitted, 1e-6);
  const glm::dvec3 scale = glm::min(highest_albedo / all, 1.0);
  return {scale * reflected, scale * transmitted, scale * all};
}

}  // namespace

LeafShade FlowerColour::Ageing::at(double withered) const {
  const auto t = static_cast<float>(withered);
  return {glm::mix(fresh.reflectance, brown.reflectance, t),
          glm::mix(fresh.transmittance, brown.transmittance, t),
          glm::mix(fresh.albedo, brown.albedo, t)};
}

FlowerColour::FlowerColour(scene::PetalColour petals) {
  const LeafOptics optics(load_leaf_spectra());
  const std::vector<double>& wavelength_nm = optics.spectra().wavelength_nm;
  const Observer observer = load_observer(wavelength_nm.front(), wavelength_nm.back());
  const auto ageing = [&](const LeafContent& fresh) {
    return Ageing{petal_shade(observer, optics(fresh)),
                  petal_shade(observer, optics(brown(fresh)))};
  };
  petal_ = ageing(fresh_petal(petals));
  disc_ = ageing(fresh_petal(scene::PetalColour::yellow));
  for (LeafShade* solid : {&disc_.fresh, &disc_.brown}) {
    solid->reflectance = solid->albedo;
    solid->transmittance = glm::vec3(0.0F);
  }
}

}  // namespace wold::grass
