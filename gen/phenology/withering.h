#pragma once

#include <span>
#include <vector>

namespace wold::phenology {

/// The weathering degree, 0 fresh to 1 straw, on each day of a meadow's greenness, 0 to 1.
///
/// Pictures of the default meadow are as green at that degree (see greenness_of()). While a meadow
/// pales the degree never falls back; when it greens again by more than a few hundredths, new
/// blades take the place of dead ones.
std::vector<double> weathering_degrees(std::span<const double> greenness);

/// How green a meadow looks at a weathering degree, 1 fresh to 0 straw: 1 / (1 + exp(5 (wd -
/// 0.43))), rescaled to 1 at 0 and 0 at 1. So the green chromatic coordinate of pictures of the
/// default meadow falls (docs/measurements.md). It is less than leaves' chlorophyll, since dead
/// blades are seen among the green.
double greenness_of(double weathering_degree);

/// Its inverse; `greenness` from 0 to 1.
double weathering_degree_of(double greenness);

}  // namespace wold::phenology
