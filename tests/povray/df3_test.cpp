#include "core/df3.h"

#include <gtest/gtest.h>

#include <fstream>
#include <numeric>
#include <sstream>

#include "core/files.h"

namespace wold {
namespace {

std::vector<float> counted(int count) {
  std::vector<float> values(static_cast<std::size_t>(count));
  std::iota(values.begin(), values.end(), 0.0F);
  return values;
}

std::string written(glm::ivec3 size, const std::vector<float>& values, float scale, int bits) {
  std::ostringstream out;
  write_df3(out, size, values, scale, bits);
  return out.str();
}

// The layout of POV-Ray's reference, section 3.5.11.12, by hand: 2 x 3 x 4 values 0..23 of scale
// 255, so that the 8-bit integers are the values and the 16-bit ones 257 times as much.
TEST(Df3, BytesAreTheReferences) {
  const std::string header("\0\2\0\3\0\4", 6);
  std::string eight = header;
  std::string sixteen = header;
  for (char value = 0; value < 24; ++value) {
    eight += value;
    sixteen += {value, value};
  }
  EXPECT_EQ(written({2, 3, 4}, counted(24), 255.0F, 8), eight);
  EXPECT_EQ(written({2, 3, 4}, counted(24), 255.0F, 16), sixteen);
}

TEST(Df3, SidesAndValuesAreBigEndian) {
  const std::string bytes = written({258, 1, 1}, std::vector<float>(258, 258.0F), 65535.0F, 16);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\1\2\0\1\0\1\1\2", 8));
}

TEST(Df3, RoundsToNearestAndClamps) {
  const std::vector<float> values = {-1.0F, 0.49F, 0.51F, 254.4F, 254.6F, 300.0F};
  EXPECT_EQ(written({6, 1, 1}, values, 255.0F, 8).substr(6),
            std::string("\x00\x00\x01\xfe\xff\xff", 6));
}

TEST(Df3, ReadsBackWithinHalfAStep) {
  const auto path = std::filesystem::path(testing::TempDir()) / "wold_read_back.df3";
  for (int bits : {8, 16}) {
    const std::vector<float> values = counted(24);
    write_file(path, [&](std::ostream& out) { write_df3(out, {4, 3, 2}, values, 23.0F, bits); });
    const Df3 grid = read_df3(path);
    EXPECT_EQ(grid.size, glm::ivec3(4, 3, 2));
    EXPECT_EQ(grid.bits, bits);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(grid.values[i] * 23.0F, values[i], 23.0F * 0.5001F / ((1 << bits) - 1));
  }
  std::filesystem::remove(path);
}

TEST(Df3, RefusesWhatTheFormatCannotHold) {
  try {
    written({2, 3, 4}, counted(23), 1.0F, 8);
    FAIL() << "a wrong count was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("24"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("23"), std::string::npos) << error.what();
  }
  EXPECT_THROW(written({65536, 1, 1}, counted(65536), 1.0F, 8), std::invalid_argument);
  EXPECT_THROW(written({0, 1, 1}, {}, 1.0F, 8), std::invalid_argument);
  EXPECT_THROW(written({1, 1, 1}, {1.0F}, 1.0F, 12), std::invalid_argument);
  EXPECT_THROW(written({1, 1, 1}, {1.0F}, 0.0F, 8), std::invalid_argument);
}

}  // namespace
}  // namespace wold
