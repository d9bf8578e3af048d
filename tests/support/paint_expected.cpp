// paint_expected EXPECTED.json PICTURE.png WIDTH HEIGHT [without]: a picture that shows what is
// expected of it, or nothing of that; a ramp where nothing is.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "core/colour.h"
#include "core/expected_picture.h"
#include "core/image.h"

namespace {

using namespace wold;

void paint(Image& picture, const ExpectedPicture& expected, const ExpectedTile& tile,
           const glm::vec3& colour) {
  const auto border = [](int number, int tiles, int pixels) {
    return static_cast<int>(std::lround(static_cast<double>(number) * pixels / tiles));
  };
  const int x = tile.tile % expected.tiles.x, y = tile.tile / expected.tiles.x;
  for (int j = border(y, expected.tiles.y, picture.height);
       j < border(y + 1, expected.tiles.y, picture.height); ++j)
    for (int i = border(x, expected.tiles.x, picture.width);
         i < border(x + 1, expected.tiles.x, picture.width); ++i)
      for (int c = 0; c < 3; ++c)
        picture.pixel(i, j)[c] = static_cast<float>(srgb_encoded(double{colour[c]}));
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 5) return 2;
  try {
    const ExpectedPicture expected = read_expected_picture(arguments[1]);
    Image picture(std::atoi(arguments[3]), std::atoi(arguments[4]), 3);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
      picture.values[i] = static_cast<float>(i) / static_cast<float>(picture.values.size());
    const bool without = count > 5 && std::string_view(arguments[5]) == "without";
    for (const ExpectedThings& things : expected.things)
      for (const ExpectedTile& tile : things.tiles)
        paint(picture, expected, tile, without ? tile.without : tile.with);
    write_image(arguments[2], picture, PixelFormat::uint8);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
