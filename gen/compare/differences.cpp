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
  result.share_over_soft = static_cast<double>(samples_over_) / samples;
  return result;
}

std::vector<std::string> exceeded(const Differences& differences, const Limits& limits) {
  std::vector<std::string> reasons;
  const auto check = [&](const char* what, double value, double limit) {
    if (value > limit)
      reasons.push_back(fmt::format("{} {:.4g} is over {:.4g}", what, value, limit));
  };
  check("rmse", differences.rmse, limits.rmse);
  check("share over the soft limit", differences.share_over_soft, limits.allowed_share);
  check("largest difference", differences.max_error, limits.hard);
  if (differences.non_finite > 0)
    reasons.push_back(fmt::format("{} values are no finite numbers", differences.non_finite));
  return reasons;
}

}  // namespace wold::compare
