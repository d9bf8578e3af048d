#include "compare/differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wold::compare {

void DifferenceSum::add(double got, double want) {
  ++values_;
  const double difference = std::abs(got - want) / range_;
  if (!std::isfinite(difference)) {
    ++sums_.non_finite;
    return;
  }
  sums_.mean_abs += difference;
  sums_.rmse += difference * difference;
  sums_.max_error = std::max(sums_.max_error, difference);
  is_over_ = is_over_ || difference > soft_;
}

void DifferenceSum::end_sample() {
  ++samples_;
  if (is_over_) ++samples_over_;
  is_over_ = false;
}

Differences DifferenceSum::result() const {
  Differences result = sums_;
  const auto values = static_cast<double>(std::max<std::size_t>(values_, 1));
  const auto samples = static_cast<double>(std::max<std::size_t>(samples_, 1));
  result.mean_abs /= values;
  result.rmse = std::sqrt(result.rmse / values);
  result.fraction_over_soft = static_cast<double>(samples_over_) / samples;
  return result;
}

std::vector<Measure> measures(const Differences& differences, const Limits& limits) {
  return {{.name = "rmse", .value = differences.rmse, .max = limits.rmse},
          {.name = fmt::format("share over {:.4g}", limits.soft),
           .value = differences.fraction_over_soft,
           .max = limits.allowed_fraction},
          {.name = "largest difference", .value = differences.max_error, .max = limits.hard},
          {.name = "values that are not finite",
           .value = static_cast<double>(differences.non_finite),
           .max = 0.0}};
}

std::vector<std::string> exceeded(const std::vector<Measure>& measures) {
  std::vector<std::string> reasons;
  for (const Measure& measure : measures) {
    if (measure.is_good()) continue;
    const bool is_low = measure.value < measure.min;
    reasons.push_back(fmt::format("{} is {:.4g}, at {} {:.4g} is allowed", measure.name,
                                  measure.value, is_low ? "least" : "most",
                                  is_low ? measure.min : measure.max));
  }
  return reasons;
}

}  // namespace wold::compare
