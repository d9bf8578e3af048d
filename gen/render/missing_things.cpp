#include "render/missing_things.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/image.h"
#include "render/shown_fraction.h"

namespace wold::render {
namespace {

/// What to do, after what is missing.
std::string advice(const Renderer& renderer, const std::string& things) {
  const std::string own = renderer.advice ? renderer.advice(things) : "";
  return own.empty() ? "; it did not read or did not draw some of its files" : own;
}

}  // namespace

std::string missing_things(const std::filesystem::path& picture, const ExpectedPicture& expected,
                           const Renderer& renderer) {
  if (expected.things.empty()) return {};
  const Image image = read_image(picture);
  for (const ExpectedThings& things : expected.things) {
    const ShownFraction shown = shown_fraction(image, expected, things);
    if (shown.contrast < min_contrast || shown.fraction >= things.min_fraction) continue;
    return fmt::format("its picture shows {:.0f} % of the {} that should be there{}",
                       100.0 * std::max(0.0, shown.fraction), things.name,
                       advice(renderer, things.name));
  }
  return {};
}

}  // namespace wold::render
