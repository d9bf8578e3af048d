#include "report/chart_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/elementary.h"

namespace wold::report::chart {
namespace {

/// Slack for what is a whole number but for rounding.
constexpr double rounding = 1e-9;

void check_bounds(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high) || low > high)
    throw std::invalid_argument(
        fmt::format("an axis needs finite bounds, low <= high, got {} and {}", low, high));
}

/// The smallest of 1, 2, 5 times a power of ten that divides `range` into at most six parts.
double round_step(double range) {
  constexpr double max_steps = 6.0;
  const double decade = math::pow(10.0, std::floor(math::log10(range / max_steps)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (range <= max_steps * factor * decade * (1.0 + rounding)) return factor * decade;
  return 10.0 * decade;
}

/// Fewest decimals that write all ticks exactly.
int decimals(const std::vector<double>& ticks) {
  const auto are_exact = [&](int digits) {
    const double scale = math::pow(10.0, digits);
    return std::all_of(ticks.begin(), ticks.end(), [&](double tick) {
      return std::abs(tick * scale - std::round(tick * scale)) < 1e-6;
    });
  };
  int digits = 0;
  while (digits < 15 && !are_exact(digits)) ++digits;
  return digits;
}

}  // namespace

Axis linear_axis(const std::string& title, double low, double high, double step) {
  check_bounds(low, high);
  if (step < 0.0) throw std::invalid_argument(fmt::format("an axis needs step >= 0, got {}", step));
  if (low == high) high = low + 1.0;
  if (step == 0.0) step = round_step(high - low);
  const double first = std::floor(low / step + rounding);
  const double last = std::ceil(high / step - rounding);
  Axis axis{title, first * step, last * step, {}, {}, false};
  const long steps = std::lround(last - first);
  for (long k = 0; k <= steps; ++k) axis.ticks.push_back((first + static_cast<double>(k)) * step);
  return axis;
}

Axis logarithmic_axis(const std::string& title, double low, double high) {
  check_bounds(low, high);
  if (low <= 0.0)
    throw std::invalid_argument(fmt::format("a logarithmic axis needs low > 0, got {}", low));
  const int first = static_cast<int>(std::floor(math::log10(low) + rounding));
  const int last = std::max(first + 1, static_cast<int>(std::ceil(math::log10(high) - rounding)));
  Axis axis{title, math::pow(10.0, first), math::pow(10.0, last), {}, {}, true};
  for (int k = first; k <= last; ++k) axis.ticks.push_back(math::pow(10.0, k));
  for (int k = first; k < last; ++k)
    for (int times = 2; times < 10; ++times) axis.minor_ticks.push_back(times * math::pow(10.0, k));
  return axis;
}

std::vector<std::string> tick_labels(const Axis& axis) {
  const int digits = axis.logarithmic ? 0 : decimals(axis.ticks);
  std::vector<std::string> labels;
  for (const double tick : axis.ticks)
    labels.push_back(axis.logarithmic ? fmt::format("{:g}", tick)
                                      : fmt::format("{:.{}f}", tick, digits));
  return labels;
}

double axis_position(const Axis& axis, double value) {
  if (!axis.logarithmic) return (value - axis.low) / (axis.high - axis.low);
  return math::log(value / axis.low) / math::log(axis.high / axis.low);
}

bool is_on(const Axis& axis, double value) {
  const double at = axis_position(axis, value);
  return at >= -rounding && at <= 1.0 + rounding;  // false for what is not a number
}

}  // namespace wold::report::chart
