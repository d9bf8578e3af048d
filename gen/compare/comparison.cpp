#include "compare/comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace wold::compare {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Limits& limits) {
  return {{"rmse", limits.rmse}, {"soft", limits.soft}, {"allowed_share", limits.allowed_fraction},
          {"hard", limits.hard}, {"flip", limits.flip}, {"ssim", limits.ssim}};
}

}  // namespace

std::vector<std::string> reasons(const Comparison& comparison) {
  std::vector<std::string> all = comparison.faults;
  for (std::string& reason : exceeded(comparison.measures)) all.push_back(std::move(reason));
  return all;
}

Json to_json(const Comparison& comparison, const Limits& limits) {
  return {{"got", comparison.got.string()}, {"want", comparison.want.string()},
          {"kind", comparison.kind},        {"same", is_same(comparison)},
          {"reasons", reasons(comparison)}, {"limits", to_json(limits)},
          {"metrics", comparison.metrics}};
}

Json to_json(const Differences& differences) {
  return {{"mean_abs", differences.mean_abs},
          {"rmse", differences.rmse},
          {"max_error", differences.max_error},
          {"share_over_soft", differences.fraction_over_soft},
          {"non_finite", differences.non_finite}};
}

std::string to_line(const Comparison& comparison) {
  return fmt::format(
      "{}: {}", comparison.name,
      is_same(comparison) ? "same" : fmt::format("{}", fmt::join(reasons(comparison), "; ")));
}

}  // namespace wold::compare
