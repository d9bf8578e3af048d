#include "render/missing_things.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/image.h"
#include "render/shown_share.h"

namespace wold::render {
namespace {

/// What to do, after what is missing.
std::string advice(Renderer renderer, const std::string& things) {
  const bool volumes = things == "grass" || things == "clouds";
  if (renderer != Renderer::blender || !volumes)
    return "; it did not read or did not draw some of its files";
  return fmt::format("; this Blender may not show volumes: `wold doctor` says whether it does{}",
                     things == "grass" ? ", `--grass blades` does without them" : "");
}

}  // namespace

std::string missing_things(const std::filesystem::path& picture, const ExpectedPicture& expected,
                           Renderer renderer) {
  if (expected.things.empty()) return {};
  const Image image = read_image(picture);
  for (const ExpectedThings& things : expected.things) {
    const ShownShare shown = shown_share(image, expected, things);
    if (shown.contrast < least_contrast || shown.share >= things.least_share) continue;
    return fmt::format("its picture shows {:.0f} % of the {} that should be there{}",
                       100.0 * std::max(0.0, shown.share), things.name,
                       advice(renderer, things.name));
  }
  return {};
}

}  // namespace wold::render
