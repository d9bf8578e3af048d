#include <gtest/gtest.h>

#include "cloud/clouds.h"

namespace wold::cloud {
namespace {

scene::CloudLayer layer(scene::CloudKind kind, double thickness_m) {
  scene::CloudLayer layer;
  layer.kind = kind;
  layer.thickness_m = thickness_m;
  return layer;
}

TEST(Cell, OfThickerCumulusIsAsMuchWider) {
  EXPECT_DOUBLE_EQ(cell_m_of(scene::CloudLayer{}), 4000.0);
  EXPECT_DOUBLE_EQ(cell_m_of(layer(scene::CloudKind::cumulus, 500.0)), 4000.0);
  EXPECT_DOUBLE_EQ(cell_m_of(layer(scene::CloudKind::cumulus, 2500.0)), 20000.0);
  EXPECT_DOUBLE_EQ(cell_m_of(layer(scene::CloudKind::cumulus, 10000.0)), 40000.0);
}

TEST(Cell, IsItsKindsElse) {
  EXPECT_DOUBLE_EQ(cell_m_of(layer(scene::CloudKind::cumulus, 100.0)), 4000.0);
  EXPECT_DOUBLE_EQ(cell_m_of(layer(scene::CloudKind::cirrus, 3000.0)), 16000.0);
  scene::CloudLayer pictures = layer(scene::CloudKind::cumulus, 2500.0);
  pictures.textures = {"clouds.png"};
  EXPECT_DOUBLE_EQ(cell_m_of(pictures), 4000.0);
  scene::CloudLayer own = layer(scene::CloudKind::cumulus, 2500.0);
  own.cell_m = 3000.0;
  EXPECT_DOUBLE_EQ(cell_m_of(own), 3000.0);
}

}  // namespace
}  // namespace wold::cloud
