#include "grass/texel/texel_file.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/files.h"
#include "core/vdb_file.h"
#include "small_meadow.h"
#include "support/temporary_folder.h"
#include "voxelised.h"

namespace wold::grass {
namespace {

constexpr float half_step = 1.0F / 1024.0F;  // relative spacing of half-precision numbers

Texel small_texel() {
  return test::voxelised(test::small_blades(), test::small_shape(30), {0.3F, 0.2F, 0.1F}, 0.12F);
}

TEST(TexelFile, ReadsBackWithinHalfPrecision) {
  const wold::test::TemporaryFolder folder("texel_file");
  const auto path = folder.path() / "texel.vdb";
  const Texel texel = small_texel();
  write_texel(path, texel, "made of grass");
  EXPECT_EQ(file_content(path), "made of grass");
  EXPECT_EQ(file_shape(path), texel.shape);
  const Texel back = read_texel(path);
  EXPECT_EQ(back.shape, texel.shape);
  ASSERT_EQ(back.voxel, texel.voxel);
  for (std::size_t i = 0; i < texel.size(); ++i) {
    ASSERT_NEAR(back.density[i], texel.density[i], half_step * texel.density[i] + 1e-7F);
    ASSERT_NEAR(back.specular[i], texel.specular[i], half_step * texel.specular[i]);
    ASSERT_LT(glm::distance(back.tangent[i], texel.tangent[i]), 2.0F * half_step);
    ASSERT_LT(glm::distance(back.normal[i], texel.normal[i]), 2.0F * half_step);
    ASSERT_LT(glm::distance(back.albedo[i], texel.albedo[i]), half_step);
  }
}

// In the file's own space a voxel's value is where its middle is: half a voxel from its corner.
TEST(TexelFile, VoxelsLieWhereTheyAre) {
  const wold::test::TemporaryFolder folder("texel_place");
  const auto path = folder.path() / "texel.vdb";
  Texel texel;
  texel.shape = {8, 8, 0.25};
  texel.voxel = {texel.shape.linear(3, 4, 5)};
  texel.density = {100.0F};
  texel.tangent = {{0.0F, 0.0F, 1.0F}};
  texel.normal = texel.albedo = texel.transmittance = {glm::vec3(0.0F)};
  texel.specular = {0.0F};
  write_texel(path, texel, "x");
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(read_vdb_grid(path, "density"));
  ASSERT_EQ(grid->activeVoxelCount(), 1U);
  const openvdb::Vec3d at_m = grid->indexToWorld(grid->cbeginValueOn().getCoord());
  EXPECT_NEAR(at_m.x(), 3.5 * 0.25, 1e-12);
  EXPECT_NEAR(at_m.y(), 4.5 * 0.25, 1e-12);
  EXPECT_NEAR(at_m.z(), 5.5 * 0.25, 1e-12);
}

TEST(TexelFile, SameTexelSameBytes) {
  const wold::test::TemporaryFolder folder("texel_bytes");
  const Texel texel = small_texel();
  write_texel(folder.path() / "a.vdb", texel, "x");
  write_texel(folder.path() / "b.vdb", texel, "x");
  EXPECT_EQ(content_hash(read_file(folder.path() / "a.vdb")),
            content_hash(read_file(folder.path() / "b.vdb")));
}

TEST(TexelFile, DamageIsAFileErrorAndNoContent) {
  const wold::test::TemporaryFolder folder("texel_damage");
  const auto path = folder.path() / "texel.vdb";
  write_texel(path, small_texel(), "x");
  const std::string whole = read_file(path);
  // The last length cuts only the end of the last grid.
  for (std::size_t length :
       {std::size_t{0}, std::size_t{7}, std::size_t{60}, whole.size() / 2, whole.size() - 40}) {
    write_file(path, std::string_view(whole).substr(0, length));
    EXPECT_THROW(read_texel(path), FileError) << length << " bytes";
    EXPECT_EQ(file_content(path), "") << length << " bytes";
  }
  EXPECT_THROW(read_texel(folder.path() / "none.vdb"), FileError);
  EXPECT_THROW(file_shape(folder.path() / "none.vdb"), FileError);
}

TEST(TexelFile, AVolumeIsNotATexel) {
  const wold::test::TemporaryFolder folder("texel_volume");
  const auto path = folder.path() / "volume.vdb";
  const Texel texel = small_texel();
  VolumeData volume{texel.shape, texel.voxel, texel.density, {0, 2}, {}};
  volume.emission.assign(2, std::vector<glm::vec3>(texel.size(), glm::vec3(0.5F)));
  write_volume(path, volume, {2}, "light");
  EXPECT_EQ(file_content(path), "light");
  EXPECT_EQ(file_shape(path), texel.shape);
  EXPECT_THROW(read_texel(path), FileError);
}

}  // namespace
}  // namespace wold::grass
