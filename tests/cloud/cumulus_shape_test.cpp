/// Outlines of cumulus from above, against those of nature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cloud/tiling.h"

namespace wold::cloud {
namespace {

constexpr glm::ivec2 cells(4, 4);
constexpr int side_px = 1024;

/// From above, as pixels. Width and length are the deviations of its pixels' places along their
/// main axes.
struct Cloud {
  double area = 0.0, perimeter = 0.0, width = 0.0, length = 0.0;
};

/// Pixels of clouds that nobody has counted yet.
class Sky {
 public:
  Sky(const LayerMap& ranks, double cover) : cloudy_(ranks.values().size()) {
    for (std::size_t i = 0; i < cloudy_.size(); ++i)
      cloudy_[i] = ranks.values()[i] > 65536.0 * (1.0 - cover);
    left_ = cloudy_;
  }

  std::vector<Cloud> clouds() {
    std::vector<Cloud> found;
    for (int y = 0; y < side_px; ++y)
      for (int x = 0; x < side_px; ++x)
        if (left_[number(glm::ivec2(x, y))]) found.push_back(cloud_at({x, y}));
    return found;
  }

 private:
  static std::size_t number(const glm::ivec2& place) {
    const glm::ivec2 in_map = place & (side_px - 1);
    return static_cast<std::size_t>(in_map.y) * side_px + static_cast<std::size_t>(in_map.x);
  }

  Cloud cloud_at(const glm::ivec2& start) {
    Cloud cloud;
    glm::dvec2 sum(0.0), squares(0.0);
    double product = 0.0;
    std::vector<glm::ivec2> open = {start};
    left_[number(start)] = false;
    while (!open.empty()) {
      const glm::ivec2 place = open.back();
      open.pop_back();
      const glm::dvec2 from_start(place - start);
      cloud.area += 1.0;
      sum += from_start;
      squares += from_start * from_start;
      product += from_start.x * from_start.y;
      for (const glm::ivec2& step :
           {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const std::size_t beside = number(place + step);
        if (!cloudy_[beside]) cloud.perimeter += 1.0;
        if (!left_[beside]) continue;
        left_[beside] = false;
        open.push_back(place + step);
      }
    }
    const glm::dvec2 mean = sum / cloud.area, variance = squares / cloud.area - mean * mean;
    const double covariance = product / cloud.area - mean.x * mean.y;
    const double middle = 0.5 * (variance.x + variance.y);
    const glm::dvec2 apart(0.5 * (variance.x - variance.y), covariance);
    cloud.width = std::sqrt(std::max(middle - glm::length(apart), 0.0));
    cloud.length = std::sqrt(middle + glm::length(apart));
    return cloud;
  }

  std::vector<bool> cloudy_, left_;
};

/// Of four layers, without those of so few pixels that their outline is the pixels'.
std::vector<Cloud> clouds_of(double cover) {
  std::vector<Cloud> clouds;
  for (std::uint64_t key = 1; key <= 4; ++key) {
    const TextureSet textures =
        textures_of(scene::CloudLayer{}, recipe_of(scene::CloudKind::cumulus), 256, key);
    const LayerMap ranks = repeated_by_blending(textures, cells, glm::ivec2(side_px), key);
    for (const Cloud& cloud : Sky(ranks, cover).clouds())
      if (cloud.area >= 60.0) clouds.push_back(cloud);
  }
  return clouds;
}

/// D of the outlines' perimeters, which grow as area^(D / 2): a regression of logarithms.
double outline_dimension(const std::vector<Cloud>& clouds) {
  double area = 0.0, perimeter = 0.0, squares = 0.0, products = 0.0;
  for (const Cloud& cloud : clouds) {
    const double x = std::log(cloud.area), y = std::log(cloud.perimeter);
    area += x;
    perimeter += y;
    squares += x * x;
    products += x * y;
  }
  const auto count = static_cast<double>(clouds.size());
  return 2.0 * (count * products - area * perimeter) / (count * squares - area * area);
}

class Cumulus : public testing::TestWithParam<double> {};

// Lovejoy 1982 (Area-perimeter relation for rain and cloud areas, Science 216): D is 1.35 over six
// orders of area.
TEST_P(Cumulus, HaveOutlinesOfTheDimensionOfClouds) {
  const std::vector<Cloud> clouds = clouds_of(GetParam());
  ASSERT_GT(clouds.size(), 200U);
  const double dimension = outline_dimension(clouds);
  RecordProperty("dimension", std::to_string(dimension));
  EXPECT_NEAR(dimension, 1.35, 0.1);
}

// Heaps stand over round thermals. An ellipse with a cloud's deviations is mostly filled by it,
// which a hook or a ring would not do.
TEST_P(Cumulus, AreCompact) {
  double filled = 0.0, area = 0.0;
  for (const Cloud& cloud : clouds_of(GetParam())) {
    filled += cloud.area * cloud.area / (4.0 * std::numbers::pi * cloud.width * cloud.length);
    area += cloud.area;
  }
  RecordProperty("filled", std::to_string(filled / area));
  EXPECT_GT(filled / area, 0.61);  // over gradient noise 0.59 and 0.51, with hooks and bridges
}

INSTANTIATE_TEST_SUITE_P(Covers, Cumulus, testing::Values(0.32, 0.45));

}  // namespace
}  // namespace wold::cloud
