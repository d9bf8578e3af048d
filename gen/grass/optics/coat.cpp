#include "grass/optics/coat.h"

#include <cmath>
#include <cstddef>

#include "core/elementary.h"

namespace wold::grass {
namespace {

constexpr double hair_surface = 0.05;
constexpr double water_surface = 0.066;
constexpr double water_index = 1.33;
constexpr double turned_back = 1.0 - (1.0 - water_surface) / (water_index * water_index);

double under_water(double absorbed) {
  return (1.0 - water_surface) * absorbed / (1.0 - turned_back * (1.0 - absorbed));
}

}  // namespace

LeafSpectrum hair_spectrum(const scene::Fur& fur, const LeafSpectra& spectra, double wet) {
  constexpr double mm_per_um = 1e-3;
  LeafSpectrum hair;
  for (std::size_t i = 0; i < spectra.eumelanin_mm.size(); ++i) {
    const double depth = mm_per_um * (fur.eumelanin_um * spectra.eumelanin_mm[i] +
                                      fur.pheomelanin_um * spectra.pheomelanin_mm[i]);
    const double dry = (1.0 - hair_surface) * (1.0 - math::exp(-depth));
    const double albedo = 1.0 - std::lerp(dry, under_water(dry), wet);
    const double surface = hair_surface * (1.0 - wet);
    hair.reflectance.push_back(surface + (albedo - surface) / 2.0);
    hair.transmittance.push_back((albedo - surface) / 2.0);
  }
  return hair;
}

}  // namespace wold::grass
