#include "cloud/texture_set.h"

#include <gtest/gtest.h>

#include <numbers>

#include "cloud/clouds.h"
#include "cloud/compose.h"
#include "core/image.h"
#include "core/random.h"
#include "support/temporary_folder.h"

namespace wold::cloud {
namespace {

/// Mean squared step of the ranks over `pixels`.
double variogram(const PeriodicMap<float>& map, const glm::ivec2& pixels) {
  double sum = 0.0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) {
      const double step = map.wrapped(x + pixels.x, y + pixels.y) - map.at(x, y);
      sum += step * step;
    }
  return sum / static_cast<double>(map.values().size());
}

TEST(Sheared, CloudsAreDrawnOutAlongTheWind) {
  const TextureSet made =
      textures_of(scene::CloudLayer{}, recipe_of(scene::CloudKind::cumulus), 128, 3);
  const double north_east = std::numbers::pi / 4.0;
  const TextureSet blown = sheared(made, north_east, 1.0);
  for (std::size_t t = 0; t < made.ranks.size(); ++t) {
    const double before = variogram(made.ranks[t], {6, 6}) / variogram(made.ranks[t], {6, -6});
    const double after = variogram(blown.ranks[t], {6, 6}) / variogram(blown.ranks[t], {6, -6});
    EXPECT_LT(after, 0.85 * before);
    std::vector<float> sorted;
    for (const PeriodicMap<float>& map : blown.ranks)
      sorted.insert(sorted.end(), map.values().begin(), map.values().end());
    std::ranges::sort(sorted);
    EXPECT_NEAR(sorted[sorted.size() / 4], 0.25F, 1e-3F);  // still ranks: cover stays
  }
  EXPECT_EQ(sheared(made, north_east, 0.0).ranks[0].values(), made.ranks[0].values());
}

TEST(TextureSet, KeysGiveOtherTexturesAndTheSameOnesAgain) {
  const auto first = [](std::uint64_t key) {
    return textures_of(scene::CloudLayer{}, recipe_of(scene::CloudKind::cirrus), 32, key)
        .ranks[0]
        .values();
  };
  EXPECT_EQ(first(1), first(1));
  EXPECT_NE(first(1), first(2));
}

TEST(TextureSet, LayersTakeTheSceneBeforeTheRecipe) {
  scene::CloudLayer layer;
  EXPECT_EQ(textures_of(layer, recipe_of(scene::CloudKind::cumulus), 16, 1).cover,
            recipe_of(scene::CloudKind::cumulus).cover);
  layer.cover = 0.75;
  layer.opacity = 0.5;
  const TextureSet textures = textures_of(layer, recipe_of(scene::CloudKind::cumulus), 16, 1);
  EXPECT_EQ(textures.cover, 0.75);
  EXPECT_EQ(textures.densest_opacity, 0.5);
}

TEST(TextureSet, AUsersPictureIsShownAsItIs) {
  const test::TemporaryFolder folder("picture");
  Image picture(64, 64, 1);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      picture.pixel(x, y)[0] =
          static_cast<float>(std::max(0.0, 0.4 + 0.5 * std::sin(x * std::numbers::pi / 16.0) *
                                                     std::cos(y * std::numbers::pi / 32.0)));
  write_image(folder.path() / "a.exr", picture, PixelFormat::float32);
  scene::Scene scene;
  scene.clouds.resize(1);
  scene.clouds[0].textures = {(folder.path() / "a.exr").string()};
  scene.clouds[0].repeat = scene::CloudRepeat::paper;
  scene.clouds[0].cell_m = 640.0;
  scene.clouds[0].cells = {2, 1};
  const Image shown = layer_picture(Clouds(scene, 10.0).at(0.0).layers[0], 10.0);
  ASSERT_EQ(shown.width, 128);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 128; ++x)
      EXPECT_NEAR(shown.pixel(x, y)[3], picture.pixel(x % 64, y)[0], 0.008) << x << ' ' << y;
}

}  // namespace
}  // namespace wold::cloud
