#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace wold::test {
namespace {

using testing::HasSubstr;

constexpr const char* scene = R"(
[terrain]
hill_height = 0
relief = 0
samples = 33
[wind]
speed = 6
heading = 90
turbulence = 0
)";

void expect_refused(const Result& result, const std::string& part) {
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr(part));
}

// Over level ground in steady air: the speed of [wind] 10 m above it, less in the grass.
TEST_F(Program, WindSaysHowItBlows) {
  write("a.toml", scene);
  const Result result = wold("wind a.toml --at 20,20,10,0 --at 20,20,0.1,5 --json");
  ASSERT_EQ(result.code, 0) << result.err;
  const auto points = nlohmann::json::parse(result.out);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0]["velocity_m_s"][0].get<double>(), 6.0, 1e-6);
  EXPECT_NEAR(points[0]["velocity_m_s"][1].get<double>(), 0.0, 1e-6);
  EXPECT_LT(points[1]["velocity_m_s"][0].get<double>(), 1.0);
  EXPECT_EQ(points[1]["time_s"].get<double>(), 5.0);
  EXPECT_THAT(wold("wind a.toml --at 20,20,10,0").out, HasSubstr("6.000"));
}

TEST_F(Program, WindRefusesWhatIsNoPlaceOrTime) {
  write("a.toml", scene);
  for (const char* at : {"1,2,3", "1,2,3,4,5", "a,2,3,4", "1,2,-1,4", "1,2,3,-4", "1,2,3,nan"})
    expect_refused(wold(std::string("wind a.toml --at ") + at), "--at");
  expect_refused(wold("wind a.toml --at 500,20,1,0"), "on the terrain");
  EXPECT_EQ(wold("wind a.toml").code, 2);
}

}  // namespace
}  // namespace wold::test
