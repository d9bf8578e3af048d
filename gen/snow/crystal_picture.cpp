#include "snow/crystal_picture.h"

#include <fmt/format.h>

#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "snow/crystal_drawing.h"

namespace wold::snow {
namespace {

/// Each pixel the mean of four.
Image halved(const Image& image) {
  Image half(image.width / 2, image.height / 2, 1);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      *half.pixel(x, y) =
          0.25F * (*image.pixel(2 * x, 2 * y) + *image.pixel(2 * x + 1, 2 * y) +
                   *image.pixel(2 * x, 2 * y + 1) + *image.pixel(2 * x + 1, 2 * y + 1));
  return half;
}

}  // namespace

FlakePictures::FlakePictures(std::uint64_t seed) {
  std::vector<Image> drawn(crystal_kinds * individuals);
  parallel_for(drawn.size(), [&](std::size_t i) {
    drawn[i] = drawn_crystal(static_cast<Crystal>(i / individuals), finest_px,
                             random_bits({seed, key_of("crystal"), i, 0}));
  });
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    Image picture = std::move(drawn[i]);
    for (int level = 0; level < levels; ++level) {
      if (level > 0) picture = halved(picture);
      add(fmt::format("{}_{}_{}", scene::word_of(single_crystals[i / individuals]),
                      i % individuals + 1, picture.width),
          picture);
    }
  }
  constexpr int soft_px = 32;
  add("disc", drawn_disc(soft_px));
  add("streak", drawn_streak(soft_px));
}

void FlakePictures::add(std::string name, Image opacity) {
  means_.push_back(static_cast<float>(mean(opacity.values)));
  pictures_.push_back({std::move(name), std::move(opacity)});
}

int FlakePictures::crystal(Crystal crystal, int individual, int level) const {
  return (static_cast<int>(crystal) * individuals + individual) * levels + level;
}

}  // namespace wold::snow
