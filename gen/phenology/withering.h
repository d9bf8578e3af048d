#pragma once

#include <span>
#include <vector>

namespace wold::phenology {

/// The weathering degree, 0 fresh to 1 straw, on each day of a meadow's greenness, 0 to 1.
///
/// The greenness that is left of the season's greatest is what models/ageing's standard curve says
/// of chlorophyll at that degree (see chlorophyll_of()). While a meadow pales the degree never
/// falls back; when it greens again by more than a few hundredths, new blades take the place of
/// dead ones. The first day is held against the greenest there can be.
std::vector<double> weathering_degrees(std::span<const double> greenness);

/// Fraction of its chlorophyll that a meadow has at a weathering degree: 1 / (1 + exp(10 (wd -
/// 0.45))), rescaled to 1 at 0 and 0 at 1, the mean that models/ageing/chlorophyll's standard case
/// is made for.
double chlorophyll_of(double weathering_degree);

/// Its inverse; `chlorophyll` from 0 to 1.
double weathering_degree_of(double chlorophyll);

}  // namespace wold::phenology
