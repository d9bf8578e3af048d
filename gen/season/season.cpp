#include "season/season.h"

#include <cstddef>

#include "season/greenness.h"
#include "season/snow_on_ground.h"
#include "season/withering.h"

namespace wold::season {

std::vector<SeasonDay> season_of(std::span<const Day> days, double first_snow_mm) {
  const std::vector<double> green = greenness(days);
  const std::vector<double> degrees = weathering_degrees(green);
  const std::vector<SnowOnGround> snow = snow_on_ground(days, {}, first_snow_mm);
  std::vector<SeasonDay> season;
  for (std::size_t i = 0; i < days.size(); ++i)
    season.push_back({days[i].date, green[i], degrees[i], snow[i].depth_m, snow[i].water_mm});
  return season;
}

}  // namespace wold::season
