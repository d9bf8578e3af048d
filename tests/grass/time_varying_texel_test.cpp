#include "grass/texel/time_varying_texel.h"

#include <gtest/gtest.h>

#include <map>

#include "core/files.h"
#include "core/parallel.h"
#include "core/vdb_dense.h"
#include "grass/texel/texel_file.h"
#include "small_meadow.h"
#include "support/temporary_folder.h"

namespace wold::grass {
namespace {

namespace fs = std::filesystem;

/// Both variants, every key frame, both levels, some turns.
TexelDemand everything() {
  TexelDemand demand;
  for (int variant : {0, 1})
    for (int key_frame : {0, 1, 2}) demand[variant][key_frame] = {{0, {0, 1}}, {1, {3}}};
  return demand;
}

void generate(const fs::path& folder, const TexelDemand& demand) {
  SilentProgress progress;
  TimeVaryingTexel(test::small_scene(), {test::slanting_light()}, folder)
      .generate(demand, progress);
}

std::map<std::string, std::string> hashes_of(const fs::path& folder) {
  std::map<std::string, std::string> hashes;
  for (const auto& entry : fs::directory_iterator(folder))
    hashes[entry.path().filename().string()] = content_hash(read_file(entry.path()));
  return hashes;
}

std::map<std::string, fs::file_time_type> times_of(const fs::path& folder) {
  std::map<std::string, fs::file_time_type> times;
  for (const auto& entry : fs::directory_iterator(folder))
    times[entry.path().filename().string()] = fs::last_write_time(entry.path());
  return times;
}

TEST(TimeVaryingTexel, SameBytesWithAnyNumberOfThreads) {
  const wold::test::TemporaryFolder one("tvt_one");
  const wold::test::TemporaryFolder two("tvt_two");
  {
    const ThreadLimit limit(1);
    generate(one.path(), everything());
  }
  {
    const ThreadLimit limit(2);
    generate(two.path(), everything());
  }
  const auto hashes = hashes_of(one.path());
  EXPECT_EQ(hashes.size(), 2U * 3U * 3U);
  EXPECT_EQ(hashes, hashes_of(two.path()));
  EXPECT_NE(hashes.at("v0_k01.vdb"), hashes.at("v1_k01.vdb"));
}

// Snow comes and goes: what is made besides under snow changes nothing, and files without it have
// the names and bytes they have always had.
TEST(TimeVaryingTexel, SnowLeavesNoTrace) {
  const wold::test::TemporaryFolder bare("tvt_bare");
  const wold::test::TemporaryFolder snowed("tvt_snowed");
  TexelDemand demand;
  for (int key_frame : {0, 2}) demand[0][key_frame] = {{0, {0}}, {1, {3}}};
  generate(bare.path(), demand);
  for (int key_frame : {0, 1}) demand[0][{key_frame, 3}] = {{0, {0}}};
  generate(snowed.path(), demand);
  const auto with_snow = hashes_of(snowed.path());
  for (const auto& [name, hash] : hashes_of(bare.path())) EXPECT_EQ(with_snow.at(name), hash);
  EXPECT_NE(with_snow.at("v0_k00_s3.vdb"), with_snow.at("v0_k00.vdb"));
  EXPECT_EQ(with_snow.count("v0_k01_s3_062.vdb"), 1U);
  EXPECT_EQ(with_snow.size(), 2U * 3U + 2U * 2U);
}

TEST(TimeVaryingTexel, MakesOnlyWhatIsMissing) {
  const wold::test::TemporaryFolder folder("tvt_resume");
  generate(folder.path(), everything());
  const auto hashes = hashes_of(folder.path());
  const auto times = times_of(folder.path());
  generate(folder.path(), everything());
  EXPECT_EQ(times_of(folder.path()), times);

  // A lost file and two that end too early, one of them just before its end.
  fs::remove(folder.path() / "v0_k01_062.vdb");
  const auto cut = [&](const std::string& name, double fraction) {
    const std::string whole = read_file(folder.path() / name);
    const double length = fraction * static_cast<double>(whole.size());
    write_file(folder.path() / name,
               std::string_view(whole).substr(0, static_cast<std::size_t>(length)));
  };
  cut("v1_k02_030.vdb", 0.5);
  cut("v1_k01_062.vdb", 0.999);
  generate(folder.path(), everything());
  EXPECT_EQ(hashes_of(folder.path()), hashes);
  EXPECT_EQ(times_of(folder.path()).at("v0_k02_062.vdb"), times.at("v0_k02_062.vdb"));
}

TEST(TimeVaryingTexel, AKeyFrameAloneIsThatOfTheFilm) {
  const wold::test::TemporaryFolder film("tvt_film");
  const wold::test::TemporaryFolder alone("tvt_alone");
  generate(film.path(), everything());
  TexelDemand demand;
  demand[1][2] = {{0, {0, 1}}};
  generate(alone.path(), demand);
  const auto hashes = hashes_of(alone.path());
  ASSERT_EQ(hashes.size(), 2U);
  for (const auto& [name, hash] : hashes) EXPECT_EQ(hash, hashes_of(film.path()).at(name));
}

TEST(TimeVaryingTexel, FilesHoldWhatWasDemanded) {
  const wold::test::TemporaryFolder folder("tvt_files");
  const TimeVaryingTexel texel(test::small_scene(), {test::slanting_light()}, folder.path());
  TexelDemand demand;
  demand[0][0] = {{1, {0, 3}}};
  SilentProgress progress;
  texel.generate(demand, progress);
  EXPECT_FALSE(fs::exists(texel.volume_path(0, 0, 0)));
  const fs::path path = texel.volume_path(0, 0, 1);
  EXPECT_EQ(file_shape(path), texel.lod_shape(1));
  EXPECT_EQ(file_shape(texel.texel_path(0, 0)), texel.shape());
  const glm::ivec3 size(30, 30, texel.lod_shape(1).height);
  for (const char* grid : {"emission_q0", "emission_q3"}) {
    float brightest = 0.0F;
    for (const glm::vec3& value : read_dense_vectors(path, grid, glm::ivec3(1), size))
      brightest = std::max(brightest, value.g);
    EXPECT_GT(brightest, 0.0F);
    EXPECT_LT(brightest, 1.0F);  // less than the albedo times all light there is
  }
  EXPECT_ANY_THROW(read_dense_vectors(path, "emission_q1", glm::ivec3(1), size));
}

/// Of what glows in the patch of a shrub, by how much of the ground it covers.
double mean_emission_of_shrub(double cover) {
  scene::Scene scene = test::small_scene();
  scene.grass.blades = 300;
  scene.species = {{.plant = scene.grass, .physiology = scene.ageing}};
  scene.species.push_back(scene.species.front());
  scene.species.front().plant.height_m = 0.05;
  scene::Species& shrub = scene.species.back();
  shrub.plant.crown_m = 0.25;
  shrub.plant.height_m = 0.03;
  shrub.habitat.cover = cover;
  const wold::test::TemporaryFolder folder("tvt_shrub");
  const TimeVaryingTexel texel(scene, {test::slanting_light()}, folder.path());
  TexelDemand demand;
  demand[0][0] = {{1, {0}}};
  SilentProgress progress;
  texel.generate(demand, progress);
  double sum = 0.0;
  int count = 0;
  const glm::ivec3 size(30, 30, texel.lod_shape(1).height);
  for (const glm::vec3& value :
       read_dense_vectors(texel.volume_path(0, 0, 1), "emission_q0", glm::ivec3(1), size)) {
    sum += double{value.g};
    count += value.g > 0.0F ? 1 : 0;
  }
  return sum / count;
}

TEST(TimeVaryingTexel, ALoneShrubHasMoreLightThanOneInAThicket) {
  const double thicket = mean_emission_of_shrub(1.0), lone = mean_emission_of_shrub(0.1);
  EXPECT_GT(lone, 1.05 * thicket);
  EXPECT_LT(lone, 2.0 * thicket);
  const double between = mean_emission_of_shrub(0.6);
  EXPECT_GT(between, 1.01 * thicket);
  EXPECT_LT(between, 0.98 * lone);
}

}  // namespace
}  // namespace wold::grass
