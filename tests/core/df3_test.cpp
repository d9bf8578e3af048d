#include "core/df3.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <vector>

namespace wold {
namespace {

std::string bytes_of(glm::ivec3 size, std::span<const float> values, int bits) {
  std::ostringstream out;
  write_df3(out, size, values, 2.0F, bits);
  return out.str();
}

// POV-Ray's reference, 3.5.11.12: three sides of two bytes, then the values, x fastest, all of them
// with the highest byte first.
TEST(Df3, IsBigEndianAsPovRayReadsIt) {
  using namespace std::string_literals;
  const std::array values = {0.0F, 2.0F, 1.0F, 0.5F};
  EXPECT_EQ(bytes_of({2, 1, 2}, values, 8), "\x00\x02\x00\x01\x00\x02\x00\xff\x80\x40"s);
  EXPECT_EQ(bytes_of({2, 1, 2}, values, 16),
            "\x00\x02\x00\x01\x00\x02\x00\x00\xff\xff\x80\x00\x40\x00"s);
  EXPECT_EQ(bytes_of({258, 1, 1}, std::vector<float>(258, 0.0F), 8).substr(0, 6),
            "\x01\x02\x00\x01\x00\x01"s);
}

}  // namespace
}  // namespace wold
