#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace wold {

/// A number that stands at the beginning of a text.
template <class Number>
struct LeadingNumber {
  Number value{};
  std::size_t length = 0;  ///< characters that it takes
};

/// The number that a text begins with, in the form of std::from_chars(): no blank and no plus
/// before it, whatever the locale. A floating-point number may be "inf" or "nan". Nothing when the
/// text begins with something else or the number does not fit its type.
template <class Number>
std::optional<LeadingNumber<Number>> leading_number(std::string_view text) {
  LeadingNumber<Number> number;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  if (error != std::errc()) return std::nullopt;
  number.length = static_cast<std::size_t>(end - text.data());
  return number;
}

/// The number that a whole text is, in the form of leading_number(); nothing when it is none.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  const auto number = leading_number<Number>(text);
  if (!number || number->length != text.size()) return std::nullopt;
  return number->value;
}

}  // namespace wold
