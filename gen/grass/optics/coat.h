#pragma once

#include "grass/optics/leaf_optics.h"
#include "scene/scene.h"

namespace wold::grass {

/// What a hair does with light when the fraction `wet`, in [0, 1], of it is under water.
///
/// Dry, 5 % is reflected by the surface (refractive index 1.55) and the rest crosses the pigments
/// (Beer and Lambert), half of it leaving forwards. Water darkens because light that the hair sends
/// back is turned round again at the water's surface (Lekner and Dorf 1988, Applied Optics
/// 27:1278):
///   A_wet = (1 - r) A / (1 - p (1 - A)),  p = 1 - (1 - r) / n^2,
/// A the absorption of the dry hair, n = 1.33, r = 0.066 the mean reflectance of water.
LeafSpectrum hair_spectrum(const scene::Fur& fur, const LeafSpectra& spectra, double wet);

}  // namespace wold::grass
