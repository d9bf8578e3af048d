#pragma once

namespace wold {

/// Quantiles of the standard normal distribution, of a probability in (0, 1), and back: the
/// probability of a value or a lower one. Boost.Math's would call the C library's exp() and log(),
/// whose last bits differ from system to system; these have core/elementary.h's.
double normal_quantile(double probability);
double normal_cdf(double value);

}  // namespace wold
