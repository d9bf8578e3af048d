#pragma once

#include <vector>

#include "core/colour.h"

namespace wold::grass {

/// Optical constants of leaf material, one value per wavelength; absorption for the natural
/// logarithm. Sources: models/leaf/prospect_d.toml, models/fur/melanin.toml.
struct LeafSpectra {
  std::vector<double> wavelength_nm;
  std::vector<double> refractive_index;
  std::vector<double> chlorophyll_cm2_ug;
  std::vector<double> chlorophyll_a_cm2_ug;
  std::vector<double> chlorophyll_b_cm2_ug;
  std::vector<double> carotenoid_cm2_ug;
  std::vector<double> brown;     ///< per arbitrary unit
  std::vector<double> water_cm;  ///< 1/cm
  std::vector<double> dry_cm2_g;
  std::vector<double> eumelanin_mm;  ///< of hair, 1/mm of the pigment alone
  std::vector<double> pheomelanin_mm;
};

/// Reads the constants that ship with the program: 400 to 780 nm, every 5 nm. Throws FileError.
LeafSpectra load_leaf_spectra();

/// The CIE 1931 observer under D65 at the wavelengths of models/colour/cie1931_d65.toml from
/// `first_nm` to `last_nm`, every 5 nm. Throws FileError.
Observer load_observer(double first_nm, double last_nm);

/// Reflectance by [TVT]'s subtraction, R = L - [Pc C + (Pa Chl-a + Pb Chl-b)], with L = 1
/// (the light enters with the observer), pigments Pa : Pb : Pc = 27 : 9 : 4 as fractions of their
/// sum, each spectrum divided by its own maximum, and both chlorophylls scaled by `chlorophyll` in
/// [0, 1].
std::vector<double> paper_reflectance(const LeafSpectra& spectra, double chlorophyll);

}  // namespace wold::grass
