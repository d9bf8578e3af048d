#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/registry.h"
#include "scene/text.h"

/// The checks of one value against its key.
namespace wold::scene {
namespace {

using MaybeFault = std::optional<Fault>;

template <class T>
bool in_range(const Key& key, T value) {
  if (!key.members.empty())
    return std::any_of(key.members.begin(), key.members.end(), [&](std::int64_t member) {
      return static_cast<double>(member) == static_cast<double>(value);
    });
  // Written so that NaN fails.
  return static_cast<double>(value) >= key.lowest && static_cast<double>(value) <= key.highest;
}

std::string with_unit(const Key& key, const auto& value) {
  return fmt::format("{}{}{}", value, key.unit.empty() ? "" : " ", key.unit);
}

MaybeFault count_fault(const ListRule& rule, std::size_t count) {
  if (count >= rule.min_items && count <= rule.max_items) return std::nullopt;
  return Fault{fmt::format("a list of {}", count)};
}

template <class T>
MaybeFault order_fault(const Key& key, const std::vector<T>& items) {
  if (key.list.order == Order::any) return std::nullopt;
  const bool up = key.list.order == Order::increasing;
  for (std::size_t i = 1; i < items.size(); ++i)
    if (!(up ? items[i] > items[i - 1] : items[i] < items[i - 1]))
      return Fault{fmt::format("{} after {}", items[i], items[i - 1]), {i}};
  return std::nullopt;
}

template <class T>
MaybeFault ends_fault(const Key& key, const std::vector<T>& items) {
  if (!key.list.spans_range || items.empty()) return std::nullopt;
  if (static_cast<double>(items.front()) != key.lowest)
    return Fault{fmt::format("{} as the first", items.front()), {0}};
  if (static_cast<double>(items.back()) != key.highest)
    return Fault{fmt::format("{} as the last", items.back()), {items.size() - 1}};
  return std::nullopt;
}

bool is_file_name(const std::string& name) {
  const auto letter_or_digit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  return !name.empty() && name.size() <= 64 && letter_or_digit(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return letter_or_digit(c) || c == '_' || c == '-' || c == '.';
         });
}

bool is_word(const Key& key, const std::string& text) {
  return std::find(key.words.begin(), key.words.end(), text) != key.words.end();
}

bool is_path(const std::string& text) {
  constexpr std::size_t longest = 4096;
  return text.size() <= longest && std::none_of(text.begin(), text.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
         });
}

/// "EPSG:" and a number.
bool is_system(std::string_view text) {
  constexpr std::string_view authority = "EPSG:";
  constexpr std::size_t max_digits = 6;
  if (!text.starts_with(authority)) return text.empty();
  const std::string_view digits = text.substr(authority.size());
  return !digits.empty() && digits.size() <= max_digits &&
         std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

bool is_text_of(const Key& key, const std::string& text) {
  if (key.kind == Kind::name) return is_file_name(text);
  if (key.kind == Kind::system) return is_system(text);
  return key.kind == Kind::file ? is_path(text) : is_word(key, text);
}

/// Of a list.
bool is_item_of(const Key& key, const std::string& text) {
  return key.kind == Kind::words ? is_word(key, text) : !text.empty() && is_path(text);
}

/// What is wrong with a value, by its type; each overload knows the kinds that hold it.
struct FaultFinder {
  const Key& key;

  MaybeFault operator()(const auto& number) const {
    if (in_range(key, number)) return std::nullopt;
    return Fault{with_unit(key, number)};
  }

  MaybeFault operator()(const std::optional<double>& number) const {
    return number ? (*this)(*number) : std::nullopt;
  }

  MaybeFault operator()(const std::vector<std::string>& texts) const {
    if (MaybeFault fault = count_fault(key.list, texts.size())) return fault;
    for (std::size_t i = 0; i < texts.size(); ++i)
      if (!is_item_of(key, texts[i])) return Fault{in_quotes(texts[i]), {i}};
    return std::nullopt;
  }

  MaybeFault operator()(const std::string& text) const {
    if (is_text_of(key, text)) return std::nullopt;
    return Fault{in_quotes(text)};
  }

  template <class T>
  MaybeFault operator()(const std::vector<T>& items) const {
    if (MaybeFault fault = count_fault(key.list, items.size())) return fault;
    for (std::size_t i = 0; i < items.size(); ++i)
      if (!in_range(key, items[i])) return Fault{with_unit(key, items[i]), {i}};
    if (MaybeFault fault = order_fault(key, items)) return fault;
    return ends_fault(key, items);
  }

  MaybeFault operator()(const CurveChoice& curve) const {
    return curve.points.empty() ? (*this)(curve.name) : points_fault(curve.points);
  }

  MaybeFault operator()(const std::vector<CurveChoice>& curves) const {
    if (MaybeFault fault = count_fault(key.list, curves.size())) return fault;
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (MaybeFault fault = (*this)(curves[i])) {
        fault->path.insert(fault->path.begin(), i);
        return fault;
      }
    return std::nullopt;
  }

  MaybeFault points_fault(const std::vector<glm::dvec2>& points) const {
    if (MaybeFault fault = count_fault(key.points, points.size())) return fault;
    const bool may_fall = key.points.order != Order::not_falling;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::dvec2& point = points[i];
      if (!in_range(key, point.x) || !in_range(key, point.y))
        return Fault{fmt::format("[{}, {}]", point.x, point.y), {i}};
      if (i == 0) continue;
      const glm::dvec2& before = points[i - 1];
      if (point.x <= before.x || (point.y < before.y && !may_fall))
        return Fault{fmt::format("[{}, {}] after [{}, {}]", point.x, point.y, before.x, before.y),
                     {i}};
    }
    if (points.front().x != 0.0)
      return Fault{fmt::format("{} as the first weathering degree", points.front().x), {0}};
    if (points.back().x != 1.0)
      return Fault{fmt::format("{} as the last weathering degree", points.back().x),
                   {points.size() - 1}};
    return std::nullopt;
  }
};

}  // namespace

std::optional<Fault> fault_of(const Key& key, const Value& value) {
  return std::visit(FaultFinder{key}, value);
}

}  // namespace wold::scene
