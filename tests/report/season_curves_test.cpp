#include "report/season_curves.h"

#include <gmock/gmock.h>

#include <array>

namespace wold::report {
namespace {

using testing::ElementsAre;

TEST(SeasonTable, HasInEachColumnWhatItsNameSays) {
  using std::chrono::sys_days, std::chrono::year, std::chrono::November;
  const std::array days = {
      phenology::SeasonDay{sys_days(year(2003) / November / 4), 0.31, 0.72, 0.5, 110.0},
      phenology::SeasonDay{sys_days(year(2003) / November / 5), 0.3, 0.75, 0.6, 120.0}};
  const std::vector<Column> table = season_table(days);
  ASSERT_EQ(table.size(), 5U);
  EXPECT_EQ(table[0].name, "date");
  EXPECT_THAT(table[0].words, ElementsAre("2003-11-04", "2003-11-05"));
  const std::array<std::pair<const char*, std::array<double, 2>>, 4> expected = {
      {{"greenness", {0.31, 0.3}},
       {"weathering_degree", {0.72, 0.75}},
       {"snow_depth_m", {0.5, 0.6}},
       {"swe_mm", {110.0, 120.0}}}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(table[i + 1].name, expected[i].first);
    EXPECT_THAT(table[i + 1].values, ElementsAre(expected[i].second[0], expected[i].second[1]));
  }
}

}  // namespace
}  // namespace wold::report
