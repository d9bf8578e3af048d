#pragma once

#include <string>
#include <vector>

namespace wold::report::chart {

/// From `low` to `high`, with a label and a grid line at every tick.
struct Axis {
  std::string title;  ///< with the unit
  double low = 0.0;
  double high = 1.0;
  std::vector<double> ticks;        ///< rising, within the axis
  std::vector<double> minor_ticks;  ///< without a label
  bool logarithmic = false;
};

/// A linear axis with ticks at the multiples of `step`, widened to whole steps; step 0 takes 1, 2
/// or 5 times a power of ten such that there are at most eight ticks. Equal bounds are set one
/// apart. Throws std::invalid_argument when a bound is not finite, low > high or step < 0.
Axis linear_axis(const std::string& title, double low, double high, double step = 0.0);

/// A logarithmic axis of whole decades with ticks at the powers of ten, minor ones at 2 to 9 times
/// them. Throws std::invalid_argument unless 0 < low <= high, finite.
Axis logarithmic_axis(const std::string& title, double low, double high);

/// The ticks' labels; all of a linear axis have the same number of decimals.
std::vector<std::string> tick_labels(const Axis& axis);

/// Where a value is on the axis: 0 at low, 1 at high. Not a number for what a logarithmic axis
/// cannot show.
double axis_position(const Axis& axis, double value);

/// Whether the value is on the axis, up to rounding.
bool is_on(const Axis& axis, double value);

}  // namespace wold::report::chart
