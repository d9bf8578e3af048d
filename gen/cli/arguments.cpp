#include "cli/arguments.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/number_text.h"
#include "scene/text.h"

namespace wold::cli {
namespace {

/// A scene has at most as many frames (scene/keys.cpp).
constexpr int max_frames = 10000;

/// The text before and after the first separator; nothing when there is none.
std::optional<std::pair<std::string_view, std::string_view>> split(std::string_view text,
                                                                   char separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  return std::pair{text.substr(0, at), text.substr(at + 1)};
}

struct FrameRange {
  int first;
  int last;
};

std::optional<FrameRange> frame_range(std::string_view text) {
  const auto [first_text, last_text] = split(text, '-').value_or(std::pair{text, text});
  const auto first = number_in<int>(first_text);
  const auto last = number_in<int>(last_text);
  if (!first || !last || *first < 1 || *last < *first || *last > max_frames) return std::nullopt;
  return FrameRange{*first, *last};
}

}  // namespace

std::vector<int> parse_frames(const std::string& text) {
  std::set<int> frames;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const auto parts = split(rest, ',');
    const std::string_view item = parts ? parts->first : rest;
    const auto range = frame_range(item);
    if (!range)
      throw InputError(
          fmt::format("--frames: found {} in {}, expected frames from 1 to {} like 1,5,9-12",
                      scene::in_quotes(item), scene::in_quotes(text), max_frames));
    for (int frame = range->first; frame <= range->last; ++frame) frames.insert(frame);
    more = parts.has_value();
    if (more) rest = parts->second;
  }
  return {frames.begin(), frames.end()};
}

std::string size_override(const std::string& text) {
  const auto parts = split(text, 'x');
  const auto width = parts ? number_in<int>(parts->first) : std::nullopt;
  const auto height = parts ? number_in<int>(parts->second) : std::nullopt;
  if (!width || !height)
    throw InputError(fmt::format("--size: found {}, expected WIDTHxHEIGHT in px like 960x540",
                                 scene::in_quotes(text)));
  return fmt::format("render.size=[{}, {}]", *width, *height);
}

place::WindPoint parse_wind_point(const std::string& text) {
  constexpr double highest_m = 1000.0, longest_s = 1e9;
  std::array<double, 4> numbers{};
  std::string_view rest = text;
  bool fits = true;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto parts = split(rest, ',');
    const auto number = number_in<double>(parts ? parts->first : rest);
    fits =
        fits && number && std::isfinite(*number) && parts.has_value() == (i + 1 < numbers.size());
    numbers[i] = number.value_or(0.0);
    rest = parts ? parts->second : std::string_view();
  }
  const auto [east_m, north_m, height_m, time_s] = numbers;
  if (!fits || height_m < 0.0 || height_m > highest_m || time_s < 0.0 || time_s > longest_s)
    throw InputError(fmt::format(
        "--at: found {}, expected metres east and north, metres above the ground from 0 to {} and "
        "seconds from 0 like 21,20,0.3,4.5",
        scene::in_quotes(text), highest_m));
  return {{east_m, north_m}, height_m, time_s};
}

}  // namespace wold::cli
