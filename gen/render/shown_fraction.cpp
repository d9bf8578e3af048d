#include "render/shown_fraction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/colour.h"

namespace wold::render {
namespace {

/// First pixel of a tile along an axis, or of the one after the last.
int border(int tile, int tiles, int pixels) {
  return static_cast<int>(std::lround(static_cast<double>(tile) * pixels / tiles));
}

/// The mean colour of a tile, as light.
glm::dvec3 mean_of_tile(const Image& picture, const glm::ivec2& tiles, int tile) {
  const int x = tile % tiles.x, y = tile / tiles.x;
  glm::dvec3 sum(0.0);
  int count = 0;
  for (int j = border(y, tiles.y, picture.height); j < border(y + 1, tiles.y, picture.height); ++j)
    for (int i = border(x, tiles.x, picture.width); i < border(x + 1, tiles.x, picture.width);
         ++i, ++count)
      for (int c = 0; c < 3; ++c) sum[c] += srgb_decoded(double{picture.pixel(i, j)[c]});
  return sum / static_cast<double>(std::max(count, 1));
}

}  // namespace

ShownFraction shown_fraction(const Image& picture, const ExpectedPicture& expected,
                             const ExpectedThings& things) {
  double shown = 0.0;
  double change = 0.0;
  for (const ExpectedTile& tile : things.tiles) {
    const glm::dvec3 without = srgb_encoded(glm::dvec3(tile.without));
    const glm::dvec3 difference = srgb_encoded(glm::dvec3(tile.with)) - without;
    const glm::dvec3 seen = srgb_encoded(mean_of_tile(picture, expected.tiles, tile.tile));
    shown += glm::dot(seen - without, difference);
    change += glm::dot(difference, difference);
  }
  if (change <= 0.0) return {};
  return {std::sqrt(change / (3.0 * expected.tiles.x * expected.tiles.y)), shown / change};
}

}  // namespace wold::render
