#include "usd/text.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace wold::usd {
namespace {

void require_number(double value) {
  if (!std::isfinite(value))
    throw FileError(fmt::format(
        "found {} among the numbers for USD, expected a finite one: this is a fault of wold",
        value));
}

}  // namespace

std::string number(double value) {
  require_number(value);
  return fmt::format("{:.9g}", value);
}

std::string rounded(double value, int decimals) {
  require_number(value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string vector(const glm::dvec3& value) {
  return fmt::format("({}, {}, {})", number(value.x), number(value.y), number(value.z));
}

std::string pair(const glm::dvec2& value) {
  return fmt::format("({}, {})", number(value.x), number(value.y));
}

std::string rounded(const glm::dvec3& value, int decimals) {
  return fmt::format("({}, {}, {})", rounded(value.x, decimals), rounded(value.y, decimals),
                     rounded(value.z, decimals));
}

std::string rounded(const glm::dvec2& value, int decimals) {
  return fmt::format("({}, {})", rounded(value.x, decimals), rounded(value.y, decimals));
}

std::string matrix(const glm::dmat4& matrix) {
  std::string text = "(";
  for (int i = 0; i < 4; ++i) {
    const glm::dvec4& values = matrix[i];
    text += fmt::format("{}({}, {}, {}, {})", i > 0 ? ", " : " ", number(values.x),
                        number(values.y), number(values.z), number(values.w));
  }
  return text + " )";
}

std::string asset(const std::filesystem::path& from_layer) {
  return fmt::format("@./{}@", from_layer.generic_string());
}

std::string indented(std::string_view text, int steps) {
  const std::string space(4 * static_cast<std::size_t>(steps), ' ');
  std::string result;
  bool at_begin = true;
  for (const char c : text) {
    if (at_begin && c != '\n') result += space;
    at_begin = c == '\n';
    result += c;
  }
  return result;
}

std::string frame_layer(int frame) { return fmt::format("frame.{:04}.usda", frame); }

}  // namespace wold::usd
