// Both renderers show what the landscape says, alike. Skipped where one of them is missing.
#include "support/one_picture.h"

#include <gtest/gtest.h>

#include "core/image.h"
#include "support/blurred_difference.h"
#include "support/quartered.h"
#include "support/snowy_view.h"
#include "support/synthetic_landscape.h"
#include "support/temporary_folder.h"

namespace wold {
namespace {

using landscape::Landscape;
using test::blender_picture;
using test::OnePicture;
using test::povray_picture;

// Every other cell in quarters, of which each lies in its own way: they show the same grass, and
// stand where a whole one's would.
TEST_F(OnePicture, PartsOfCellsAreAlike) {
  const test::TemporaryFolder folder("one_picture_of_parts");
  Landscape landscape = test::synthetic_landscape({}, folder.path() / "texels");
  test::quarter_cells(landscape);
  for (landscape::Cell& cell : landscape.cells)
    if (!cell.part.is_whole())
      cell.world_from_cell[3].z += 0.02 * (cell.part.low.x - cell.part.low.y);
  const Image blender = blender_picture(landscape, folder.path() / "blender");
  const Image povray = povray_picture(landscape, folder.path() / "povray");
  const double difference = test::blurred_difference(blender, povray);
  EXPECT_LE(difference, 1.5 / 255.0) << 255.0 * difference << " of 255";
}

// Grass under snowfall in fog: near flakes of many pixels, far ones of a part of one.
TEST_F(OnePicture, SnowfallAndFogAreAlike) {
  const test::TemporaryFolder folder("one_picture");
  Landscape landscape = test::synthetic_landscape({}, folder.path() / "texels");
  test::add_flakes(landscape, 3000, 4.0);
  landscape.fog = landscape::Fog{0.02, glm::vec3(0.1F, 0.11F, 0.12F)};
  const Image blender = blender_picture(landscape, folder.path() / "blender");
  const Image povray = povray_picture(landscape, folder.path() / "povray");
  const double difference = test::blurred_difference(blender, povray);
  EXPECT_LE(difference, 1.0 / 255.0) << 255.0 * difference << " of 255";
}

}  // namespace
}  // namespace wold
