// The passes' edges are the pictures'. Skipped where a renderer is missing.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "passes/paint.h"
#include "support/constant_meadow.h"
#include "support/one_picture.h"
#include "support/plain_facts.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

using landscape::Landscape;

constexpr float dark = 0.02F, bright = 0.2F;

/// Ground and grass have one radiance and the sky another, so that a pixel's value says how much of
/// it is sky, whatever its filter.
Landscape silhouette(const test::ConstantMeadow& meadow, const std::filesystem::path& folder) {
  Landscape landscape = test::constant_meadow(meadow, folder);
  landscape.blade_cells.clear();
  landscape.samples = 16;
  return landscape;
}

/// Its voxels are half as large as pixels, as those of scenes are about: renderers blend between
/// them, and see farther around large ones.
constexpr test::ConstantMeadow meadow = {.voxels = 62,
                                         .height_voxels = 36,
                                         .extinction = 6.0F,
                                         .radiance = dark,
                                         .ground = dark,
                                         .sky = bright,
                                         .width_px = 240,
                                         .height_px = 135};

/// Hills with crests between the samples, before the sky. They are so large that the 4 mm by which
/// POV-Ray's ground lies too low are nothing.
Landscape hills(const std::filesystem::path& folder) {
  Landscape landscape = silhouette(meadow, folder);
  landscape.cells.clear();
  landscape.volumes.clear();
  landscape.width_px = 480;
  landscape.height_px = 270;
  constexpr double scale = 50.0;
  Heightfield hills(61, 3.0 * scale);
  for (int j = 0; j < hills.samples(); ++j)
    for (int i = 0; i < hills.samples(); ++i) {
      const glm::dvec2 at = hills.place_m(i, j) / scale;
      hills.at(i, j) = static_cast<float>(scale * 0.25 * std::sin(2.1 * at.y + 0.7) *
                                          (1.0 + 0.4 * std::sin(3.0 * at.x + at.y)));
    }
  landscape.terrain = hills;
  landscape.ground = landscape.light = ColourMap(2, hills.size_m(), glm::vec3(dark));
  landscape.extinction_factor = FactorMap(2, hills.size_m(), 1.0F);
  landscape.camera.eye_m *= scale;
  landscape.camera.target_m *= scale;
  return landscape;
}

double linear(float encoded) {
  const double value{encoded};
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// How much of a pixel is sky. The upper left and the lower middle pixel are all sky and all
/// ground.
class SkyFraction {
 public:
  explicit SkyFraction(const Image& picture)
      : picture_(picture),
        sky_(linear(*picture.pixel(2, 2))),
        ground_(linear(*picture.pixel(picture.width / 2, picture.height - 3))) {}
  double at(int x, int y) const {
    return (linear(*picture_.pixel(x, y)) - ground_) / (sky_ - ground_);
  }

 private:
  const Image& picture_;
  double sky_, ground_;
};

/// Rows of sky above the ground, by column.
std::vector<double> sky_rows(const Image& picture) {
  const SkyFraction sky(picture);
  std::vector<double> rows(static_cast<std::size_t>(picture.width), 0.0);
  for (int x = 0; x < picture.width; ++x)
    for (int y = 0; y < picture.height; ++y) rows[static_cast<std::size_t>(x)] += sky.at(x, y);
  return rows;
}

/// Rows down to where half of the sky is seen, by column.
std::vector<double> rows_to_half(const Image& picture) {
  const SkyFraction sky(picture);
  std::vector<double> rows;
  for (int x = 0; x < picture.width; ++x) {
    int y = 0;
    while (sky.at(x, y + 1) >= 0.5) ++y;
    rows.push_back(y + 0.5 + (sky.at(x, y) - 0.5) / (sky.at(x, y) - sky.at(x, y + 1)));
  }
  return rows;
}

std::vector<double> sky_rows(const LayeredImage& passes) {
  const std::vector<float>& covered = passes.find("depth.A")->values;
  std::vector<double> rows(static_cast<std::size_t>(passes.width), 0.0);
  for (std::size_t pixel = 0; pixel < covered.size(); ++pixel)
    rows[pixel % rows.size()] += 1.0 - double{covered[pixel]};
  return rows;
}

/// Rows without a depth, which has no parts of pixels.
std::vector<double> rows_without_depth(const LayeredImage& passes) {
  const std::vector<float>& depth = passes.find("depth.Z")->values;
  std::vector<double> rows(static_cast<std::size_t>(passes.width), 0.0);
  for (std::size_t pixel = 0; pixel < depth.size(); ++pixel)
    rows[pixel % rows.size()] += depth[pixel] >= 1e10F ? 1.0 : 0.0;
  return rows;
}

struct Offset {
  double mean_px = 0.0;      ///< with its sign
  double absolute_px = 0.0;  ///< mean of its size
};

/// Where an edge goes through whole columns.
Offset offset(const std::vector<double>& got, const std::vector<double>& want) {
  Offset offset;
  constexpr std::size_t margin = 4;
  const auto columns = static_cast<double>(got.size() - 2 * margin);
  for (std::size_t x = margin; x + margin < got.size(); ++x) {
    offset.mean_px += (got[x] - want[x]) / columns;
    offset.absolute_px += std::abs(got[x] - want[x]) / columns;
  }
  return offset;
}

class PassesAlignment : public test::OnePicture {
 protected:
  void expect_aligned(const Landscape& landscape, const std::filesystem::path& folder) {
    const LayeredImage passes = passes::paint(landscape, test::plain_facts(landscape),
                                              std::vector<passes::Pass>{passes::Pass::depth});
    for (const auto& [name, picture] :
         {std::pair("Blender", test::blender_picture(landscape, folder / "blender")),
          std::pair("POV-Ray", test::povray_picture(landscape, folder / "povray"))}) {
      const Offset by_cover = offset(sky_rows(passes), sky_rows(picture));
      EXPECT_LE(by_cover.absolute_px, 0.1) << name;
      EXPECT_LE(std::abs(by_cover.mean_px), 0.03) << name;
      const Offset by_depth = offset(rows_without_depth(passes), rows_to_half(picture));
      EXPECT_LE(std::abs(by_depth.mean_px), 0.1) << name;
      RecordProperty(fmt::format("{}_mean_px", name), std::to_string(by_cover.mean_px));
      RecordProperty(fmt::format("{}_absolute_px", name), std::to_string(by_cover.absolute_px));
      RecordProperty(fmt::format("{}_depth_px", name), std::to_string(by_depth.mean_px));
    }
  }
};

TEST_F(PassesAlignment, CrestsOfHillsStandWhereThePicturesHaveThem) {
  const test::TemporaryFolder folder("alignment_hills");
  expect_aligned(hills(folder.path()), folder.path());
}

TEST_F(PassesAlignment, GrassEndsWhereThePicturesHaveIt) {
  const test::TemporaryFolder folder("alignment_grass");
  expect_aligned(silhouette(meadow, folder.path()), folder.path());
}

}  // namespace
}  // namespace wold
