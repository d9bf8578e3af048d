#include "compare/compare_command.h"

#include <gmock/gmock.h>

#include "core/files.h"
#include "core/image.h"
#include "scratch_folder.h"
#include "vdb_samples.h"

namespace wold::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr std::string_view df3_2x1x3("\0\2\0\1\0\3\0\63\146\231\314\377", 12);

Image checks(int width, int height, float bright) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = i % 2 == 0 ? bright : 0.0F;
  return image;
}

class CompareFiles : public ::testing::Test {
 protected:
  ExitCode compared(const fs::path& got, const fs::path& want, const fs::path& report = {}) {
    return compare_files(got, want, Limits{}, report, json_);
  }
  /// A picture, a VDB and a df3 file that are sound.
  std::vector<fs::path> one_of_each() const {
    write_image(folder_ / "a.png", checks(64, 64, 1.0F), PixelFormat::uint8);
    write_image(folder_ / "a.exr", checks(64, 64, 1.0F), PixelFormat::half);
    test::write_sample_vdb(folder_ / "a.vdb", {});
    write_file(folder_ / "a.df3", df3_2x1x3);
    return {folder_ / "a.png", folder_ / "a.exr", folder_ / "a.vdb", folder_ / "a.df3"};
  }

  test::ScratchFolder folder_;
  std::string json_;
};

TEST_F(CompareFiles, EveryKindEqualsItselfAndNoOther) {
  const std::vector<fs::path> files = one_of_each();
  for (const fs::path& file : files) {
    EXPECT_EQ(compared(file, file), ExitCode::done) << json_;
    EXPECT_THAT(json_, HasSubstr("\"same\": true"));
  }
  EXPECT_EQ(compared(files[0], files[2]), ExitCode::different);
  EXPECT_THAT(json_, HasSubstr("got a picture, want a vdb"));
}

TEST_F(CompareFiles, EveryKindTruncatedAnywhereIsAFileError) {
  for (const fs::path& file : one_of_each()) {
    const std::string whole = read_file(file);
    const fs::path cut = folder_ / ("cut" + file.extension().string());
    for (const std::size_t length : {std::size_t{0}, std::size_t{3}, whole.size() / 4,
                                     whole.size() / 2, whole.size() - 40 * whole.size() / 100}) {
      write_file(cut, std::string_view(whole).substr(0, length));
      EXPECT_THROW(compared(cut, file), FileError) << cut << " of " << length << " bytes";
    }
  }
}

TEST_F(CompareFiles, AVdbThatPromisesGridsItDoesNotHoldIsAFileError) {
  test::write_sample_vdb(folder_ / "a.vdb", {});
  std::string bytes = read_file(folder_ / "a.vdb");
  // after the header (57 bytes) and the number of metadata entries, which is 0 (4 bytes)
  bytes.replace(61, 4, "\377\377\377\177");
  write_file(folder_ / "many.vdb", bytes);
  EXPECT_THROW(compared(folder_ / "many.vdb", folder_ / "a.vdb"), FileError);
}

TEST_F(CompareFiles, MissingFilesAreFileErrors) {
  EXPECT_THROW(compared(folder_ / "none.png", folder_ / "none.png"), FileError);
  EXPECT_THROW(compared(folder_ / "", folder_ / ""), FileError);
}

TEST_F(CompareFiles, AReportShowsGotWantAndTenTimesTheDifference) {
  write_image(folder_ / "got.png", checks(8, 8, 0.8F), PixelFormat::uint8);
  write_image(folder_ / "want.png", checks(8, 8, 0.76F), PixelFormat::uint8);
  EXPECT_EQ(compared(folder_ / "got.png", folder_ / "want.png", folder_ / "report"),
            ExitCode::different);
  EXPECT_EQ(read_file(folder_ / "report/metrics.json"), json_);
  EXPECT_EQ(read_image(folder_ / "report/got.png").values, read_image(folder_ / "got.png").values);
  EXPECT_EQ(read_image(folder_ / "report/want.png").values,
            read_image(folder_ / "want.png").values);
  // 204 - 194 steps of 8 bit
  EXPECT_NEAR(read_image(folder_ / "report/difference.png").values.front(), 100.0 / 255.0, 1e-6);
}

TEST_F(CompareFiles, OtherSizesAreDifferentAndSaidSo) {
  write_image(folder_ / "a.png", checks(8, 8, 1.0F), PixelFormat::uint8);
  write_image(folder_ / "b.png", checks(8, 9, 1.0F), PixelFormat::uint8);
  EXPECT_EQ(compared(folder_ / "a.png", folder_ / "b.png"), ExitCode::different);
  EXPECT_THAT(json_, HasSubstr("got 8 x 8 pixels with 3 channels, want 8 x 9 with 3"));
}

TEST_F(CompareFiles, Df3ValuesAreComparedAcrossWidths) {
  write_file(folder_ / "8.df3", std::string_view("\0\1\0\1\0\2\0\200", 8));
  write_file(folder_ / "16.df3",
             std::string_view("\0\1\0\1\0\2\0\0\200\200", 10));  // 0x8080 / 0xffff
  EXPECT_EQ(compared(folder_ / "8.df3", folder_ / "16.df3"), ExitCode::done);
  write_file(folder_ / "off.df3", std::string_view("\0\1\0\1\0\2\0\0\210\200", 10));
  EXPECT_EQ(compared(folder_ / "8.df3", folder_ / "off.df3"), ExitCode::different);
}

TEST_F(CompareFiles, AGridThatMovedIsDifferent) {
  test::write_sample_vdb(folder_ / "a.vdb", {});
  test::write_sample_vdb(folder_ / "b.vdb", {.voxel_m = 0.5});
  EXPECT_EQ(compared(folder_ / "a.vdb", folder_ / "b.vdb"), ExitCode::different);
  EXPECT_THAT(json_, HasSubstr("grid density: the transforms differ"));
}

}  // namespace
}  // namespace wold::compare
