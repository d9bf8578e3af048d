#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "compare/compare_command.h"
#include "core/files.h"
#include "core/image.h"
#include "scratch_folder.h"
#include "vdb_samples.h"

namespace wold::compare {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;

constexpr std::string_view df3_2x1x3("\0\2\0\1\0\3\0\63\146\231\314\377", 12);

Image checks(int width, int height, float bright) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = i % 2 == 0 ? bright : 0.0F;
  return image;
}

class Compare : public ::testing::Test {
 protected:
  ExitCode compared(const fs::path& got, const fs::path& want, const fs::path& report = {}) {
    const Verdict verdict = compare_paths(got, want, Limits{}, report);
    json_ = verdict.json;
    lines_ = verdict.lines;
    return verdict.code;
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
  std::string lines_;
};

TEST_F(Compare, EveryKindEqualsItselfAndNoOther) {
  const std::vector<fs::path> files = one_of_each();
  for (const fs::path& file : files) {
    EXPECT_EQ(compared(file, file), ExitCode::done) << json_;
    EXPECT_THAT(json_, HasSubstr("\"same\": true"));
  }
  EXPECT_EQ(compared(files[0], files[2]), ExitCode::different);
  EXPECT_THAT(json_, HasSubstr("got a picture, want a vdb"));
}

TEST_F(Compare, EveryKindTruncatedAnywhereIsAFileError) {
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

TEST_F(Compare, AVdbThatPromisesGridsItDoesNotHoldIsAFileError) {
  test::write_sample_vdb(folder_ / "a.vdb", {});
  std::string bytes = read_file(folder_ / "a.vdb");
  // after the header (57 bytes) and the number of metadata entries, which is 0 (4 bytes)
  bytes.replace(61, 4, "\377\377\377\177");
  write_file(folder_ / "many.vdb", bytes);
  EXPECT_THROW(compared(folder_ / "many.vdb", folder_ / "a.vdb"), FileError);
}

TEST_F(Compare, MissingFilesAreFileErrors) {
  EXPECT_THROW(compared(folder_ / "none.png", folder_ / "none.png"), FileError);
  EXPECT_THROW(compared(folder_ / "", folder_ / ""), FileError);
}

TEST_F(Compare, AReportShowsGotWantAndTheirDifferences) {
  write_image(folder_ / "got.png", checks(8, 8, 0.8F), PixelFormat::uint8);
  write_image(folder_ / "want.png", checks(8, 8, 0.76F), PixelFormat::uint8);
  EXPECT_EQ(compared(folder_ / "got.png", folder_ / "want.png", folder_ / "report"),
            ExitCode::different);
  EXPECT_EQ(read_file(folder_ / "report/metrics.json"), json_);
  EXPECT_EQ(read_image(folder_ / "report/got.png").values, read_image(folder_ / "got.png").values);
  EXPECT_EQ(read_image(folder_ / "report/want.png").values,
            read_image(folder_ / "want.png").values);
  // 204 - 194 steps of 8 bit, ten times
  EXPECT_NEAR(read_image(folder_ / "report/difference.png").values.front(), 100.0 / 255.0, 1e-6);
  EXPECT_EQ(read_image(folder_ / "report/flip.png").channels, 3);
}

TEST_F(Compare, ThePageShowsWhatIsBesideItAndWhichLimitsAreExceeded) {
  const fs::path got = folder_ / "<b>got & 'more'.png";
  write_image(got, checks(8, 8, 0.8F), PixelFormat::uint8);
  write_image(folder_ / "want.png", checks(8, 8, 0.76F), PixelFormat::uint8);
  compared(got, folder_ / "want.png", folder_ / "report");
  const std::string page = read_file(folder_ / "report/index.html");
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_THAT(page, HasSubstr("<summary>&lt;b&gt;got &amp; 'more'.png"));
  EXPECT_THAT(page, HasSubstr(R"(<tr class="bad"><td>rmse</td>)"));
  EXPECT_THAT(page, HasSubstr(R"(<tr><td>largest difference</td>)"));
  const std::regex source("src=\"([^\"]*)\"");
  std::set<std::string> shown;
  for (std::sregex_iterator match(page.begin(), page.end(), source), end; match != end; ++match)
    shown.insert((*match)[1]);
  EXPECT_EQ(shown, (std::set<std::string>{"difference.png", "flip.png", "got.png", "want.png"}));
  for (const std::string& name : shown) EXPECT_TRUE(fs::exists(folder_ / "report" / name)) << name;
  EXPECT_EQ(page.find("http"), std::string::npos);  // nothing from elsewhere
}

TEST_F(Compare, FoldersFileByFile) {
  for (const char* folder : {"got", "want"}) {
    fs::create_directories(folder_ / folder / "deep");
    write_image(folder_ / folder / "a.png", checks(8, 8, 0.8F), PixelFormat::uint8);
    write_file(folder_ / folder / "notes.txt", folder);  // not to be compared
  }
  EXPECT_EQ(compared(folder_ / "got", folder_ / "want"), ExitCode::done);
  EXPECT_EQ(lines_, "a.png: same");
  write_image(folder_ / "got/deep/b.png", checks(8, 8, 0.9F), PixelFormat::uint8);
  write_image(folder_ / "want/deep/b.png", checks(8, 8, 0.8F), PixelFormat::uint8);
  write_image(folder_ / "got/new.png", checks(8, 8, 0.8F), PixelFormat::uint8);
  write_file(folder_ / "want/old.df3", df3_2x1x3);
  EXPECT_EQ(compared(folder_ / "got", folder_ / "want", folder_ / "report"), ExitCode::different);
  EXPECT_THAT(lines_, MatchesRegex("deep/b.png: rmse is [^\n]*\n"
                                   "new.png: is new: nothing is wanted\n"
                                   "old.df3: is missing\na.png: same"));
  EXPECT_TRUE(fs::exists(folder_ / "report/0002/flip.png"));
  EXPECT_THAT(read_file(folder_ / "report/index.html"), HasSubstr("3 of 4 differ"));
  EXPECT_THROW(compared(folder_ / "got", folder_ / "want/a.png"), InputError);
}

TEST_F(Compare, OtherSizesAreDifferentAndSaidSo) {
  write_image(folder_ / "a.png", checks(8, 8, 1.0F), PixelFormat::uint8);
  write_image(folder_ / "b.png", checks(8, 9, 1.0F), PixelFormat::uint8);
  EXPECT_EQ(compared(folder_ / "a.png", folder_ / "b.png"), ExitCode::different);
  EXPECT_THAT(json_, HasSubstr("got 8 x 8 pixels with 3 channels, want 8 x 9 with 3"));
}

TEST_F(Compare, Df3ValuesAreComparedAcrossWidths) {
  write_file(folder_ / "8.df3", std::string_view("\0\1\0\1\0\2\0\200", 8));
  write_file(folder_ / "16.df3",
             std::string_view("\0\1\0\1\0\2\0\0\200\200", 10));  // 0x8080 / 0xffff
  EXPECT_EQ(compared(folder_ / "8.df3", folder_ / "16.df3"), ExitCode::done);
  write_file(folder_ / "off.df3", std::string_view("\0\1\0\1\0\2\0\0\210\200", 10));
  EXPECT_EQ(compared(folder_ / "8.df3", folder_ / "off.df3"), ExitCode::different);
}

TEST_F(Compare, Df3TellsWhichFileHasMoreFilledVoxels) {
  write_file(folder_ / "more.df3", std::string_view("\0\3\0\1\0\1\0\7\7", 9));
  write_file(folder_ / "less.df3", std::string_view("\0\3\0\1\0\1\7\0\0", 9));
  compared(folder_ / "more.df3", folder_ / "less.df3");
  EXPECT_EQ(nlohmann::json::parse(json_)["metrics"]["filled_in_one"], nlohmann::json({2, 1}));
}

TEST_F(Compare, AGridThatMovedIsDifferent) {
  test::write_sample_vdb(folder_ / "a.vdb", {});
  test::write_sample_vdb(folder_ / "b.vdb", {.voxel_m = 0.5});
  EXPECT_EQ(compared(folder_ / "a.vdb", folder_ / "b.vdb"), ExitCode::different);
  EXPECT_THAT(json_, HasSubstr("grid density: the transforms differ"));
}

TEST_F(Compare, GridsWhoseVoxelsAreActiveElsewhereAreDifferent) {
  test::write_sample_vdb(folder_ / "a.vdb", {});
  test::write_sample_vdb(folder_ / "b.vdb", {.active_zeros = 8});
  EXPECT_EQ(compared(folder_ / "a.vdb", folder_ / "b.vdb"), ExitCode::different);
  EXPECT_THAT(json_,
              HasSubstr("share of voxels active in only one is 0.01538, at most 0.01 is allowed"));
  EXPECT_EQ(json_.find("rmse is"), std::string::npos);  // the values are the same
}

}  // namespace
}  // namespace wold::compare
