#include <fmt/format.h>

#include "scene/document.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

struct Describer {
  std::string operator()(std::int64_t integer) const { return std::to_string(integer); }
  std::string operator()(double number) const { return number_text(number); }
  std::string operator()(const std::string& text) const { return in_quotes(text); }
  std::string operator()(const std::vector<Node>& items) const {
    return fmt::format("a list of {}", items.size());
  }
  std::string operator()(const Unusable& unusable) const { return unusable.description; }
};

}  // namespace

std::string description(const Node& node) { return std::visit(Describer{}, node.value); }

}  // namespace wold::scene
