#include "landscape/emitted_light.h"

#include <gtest/gtest.h>

#include <random>

#include "core/colour.h"

namespace wold::landscape {
namespace {

/// A box of 4 x 4 x 4 voxels of which some have matter, of any colour.
struct LitBox {
  glm::ivec3 voxels{4, 4, 4};
  std::vector<float> extinction_per_m = std::vector<float>(64, 0.0F);
  std::vector<glm::vec3> radiance = std::vector<glm::vec3>(64, glm::vec3(0.0F));

  LitBox() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(0.01F, 1.0F);
    for (std::size_t i = 0; i < 64; ++i)
      if (number(random) < 0.6F) {
        extinction_per_m[i] = 500.0F * number(random);
        radiance[i] = {number(random), number(random), number(random)};
      }
  }
};

// CIE 1931: the luminance of red, green and blue of sRGB is 0.2126, 0.7152 and 0.0722.
TEST(EmittedLight, LuminanceIsOfWhatAMetreAdds) {
  const LitBox box;
  const EmittedLight light = emitted_light(box.extinction_per_m, box.radiance, box.voxels);
  for (std::size_t i = 0; i < 64; ++i) {
    const glm::vec3 gained = box.extinction_per_m[i] * box.radiance[i];
    const float wanted = 0.2126F * gained.r + 0.7152F * gained.g + 0.0722F * gained.b;
    EXPECT_NEAR(light.luminance_per_m[i], wanted, 1e-3F * wanted + 1e-6F);
  }
}

// Luminance times colour is, over all eight voxels of a coarse one, what they emit.
TEST(EmittedLight, LuminanceTimesColourIsWhatIsEmitted) {
  const LitBox box;
  const EmittedLight light = emitted_light(box.extinction_per_m, box.radiance, box.voxels);
  std::vector<glm::vec3> wrong(light.colours.values.size(), glm::vec3(0.0F));
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        const auto fine = static_cast<std::size_t>((z * 4 + y) * 4 + x);
        const auto coarse = static_cast<std::size_t>((z / 2 * 2 + y / 2) * 2 + x / 2);
        wrong[coarse] += light.luminance_per_m[fine] * light.colours.values[coarse] -
                         box.extinction_per_m[fine] * box.radiance[fine];
      }
  for (const glm::vec3& sum : wrong)
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(sum[channel], 0.0F, 1e-2F);
}

TEST(EmittedLight, ColoursHaveLuminanceOne) {
  const LitBox box;
  for (const glm::vec3& colour :
       emitted_light(box.extinction_per_m, box.radiance, box.voxels).colours.values)
    EXPECT_NEAR(luminance(colour), 1.0, 1e-5);
}

}  // namespace
}  // namespace wold::landscape
