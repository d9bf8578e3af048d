#include "cli/option_faults.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "core/number_text.h"

namespace wold::cli {

std::string word_fault(const std::string& text, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) != words.end()) return "";
  return fmt::format("found {}, expected one of {}", text, fmt::join(words, ", "));
}

std::string whole_number_fault(const std::string& text, int min, int max) {
  const auto number = number_in<int>(text);
  if (number && *number >= min && *number <= max) return "";
  return fmt::format("found {}, expected a whole number from {} to {}", text, min, max);
}

std::string number_fault(const std::string& text, double min, double max) {
  const auto number = number_in<double>(text);
  if (number && std::isfinite(*number) && *number >= min && *number <= max) return "";
  return std::isfinite(max)
             ? fmt::format("found {}, expected a number from {} to {}", text, min, max)
             : fmt::format("found {}, expected a number from {}", text, min);
}

std::string size_fault(const std::string& text) {
  constexpr double min = 1024.0 * 1024.0;
  constexpr double max = 1e18;
  const bool begins_with_digit = !text.empty() && text[0] >= '0' && text[0] <= '9';
  std::string in_bytes = text;
  try {
    const bool is_size = begins_with_digit && CLI::AsSizeValue(false)(in_bytes).empty();
    const auto bytes = number_in<double>(in_bytes);
    if (is_size && bytes && *bytes >= min && *bytes <= max) return "";
  } catch (const CLI::ValidationError&) {  // what is before the unit is no whole number
  }
  return fmt::format("found {}, expected a whole size of 1M or more, such as 8G or 1500M", text);
}

}  // namespace wold::cli
