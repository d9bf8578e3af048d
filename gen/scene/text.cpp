#include "scene/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace wold::scene {
namespace {

constexpr std::size_t longest_bytes = 40;

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }

}  // namespace

std::string shown(std::string_view text) {
  std::size_t length = std::min(text.size(), longest_bytes);
  while (length > 0 && length < text.size() && is_continuation(text[length])) --length;
  std::string result(text.substr(0, length));
  std::replace_if(result.begin(), result.end(), is_control, '?');
  return length < text.size() ? result + "..." : result;
}

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", shown(text)); }

std::string item_name(std::string_view array, std::size_t item) {
  return fmt::format("{}[{}]", array, item + 1);
}

std::string number_text(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

}  // namespace wold::scene
