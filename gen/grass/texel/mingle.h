#pragma once

#include <span>

#include "grass/texel/texel.h"

namespace wold::grass {

/// The sum of samples, [TVT] section 4.1, Algorithm 2: densities add up, so areas do, and every
/// other attribute is the mean weighted by density, rho Psi = sum_i rho_i Psi_i. What a mean is for
/// each attribute is said in texel_builder.h: tangents by their dyads, so that t and -t stay one
/// fibre; a normal that cancels out is the vein's.
///
/// At least one sample, all of one shape; throws std::invalid_argument otherwise.
Texel mingle(std::span<const Texel> samples);

}  // namespace wold::grass
