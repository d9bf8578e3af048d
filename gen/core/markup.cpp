#include "core/markup.h"

namespace wold {

std::string markup_escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string filled(std::string page, std::string_view mark, std::string_view text) {
  for (std::size_t at = page.find(mark); at != std::string::npos;
       at = page.find(mark, at + text.size()))
    page.replace(at, mark.size(), text);
  return page;
}

}  // namespace wold
