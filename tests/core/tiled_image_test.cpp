#include "core/tiled_image.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/temporary_folder.h"

namespace wold {
namespace {

constexpr glm::ivec2 size_px(48, 32);
constexpr int tile_px = 16;

double value_at(int x, int y, int channel) { return x + 100.0 * y + 10000.0 * channel; }

// Every pixel of the half is the mean of four; these say where they come from.
TEST(TiledImage, OfHalfTheSizeHasTheMeansOfFour) {
  const test::TemporaryFolder folder("tiled_image");
  const TiledExtent whole{size_px, 2, tile_px};
  write_tiled_image(
      folder.path() / "whole.tif", whole, 3, [&](const glm::ivec2& tile, std::span<float> values) {
        for (int y = 0; y < tile_px; ++y)
          for (int x = 0; x < tile_px; ++x)
            for (int channel = 0; channel < 2; ++channel)
              values[static_cast<std::size_t>((y * tile_px + x) * 2 + channel)] =
                  static_cast<float>(value_at(tile.x * tile_px + x, tile.y * tile_px + y, channel));
      });
  const TiledImages images(16.0);
  write_halved(images, folder.path() / "whole.tif", whole, folder.path() / "half.tif", 2);
  const TiledExtent half = halved(whole);
  ASSERT_EQ(half.size_px, glm::ivec2(24, 16));
  std::vector<float> values(24 * 16 * 2);
  images.read(folder.path() / "half.tif", {0, 0}, half.size_px, 2, values);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      for (int channel = 0; channel < 2; ++channel)
        ASSERT_NEAR(values[static_cast<std::size_t>((y * 24 + x) * 2 + channel)],
                    value_at(2 * x, 2 * y, channel) + 0.5 + 50.0, 1e-2)
            << x << ' ' << y;
}

}  // namespace
}  // namespace wold
