#include "phenology/season.h"

#include <cstddef>

#include "phenology/greenness.h"
#include "phenology/withering.h"
#include "snowpack/snow_on_ground.h"

namespace wold::phenology {

std::vector<SeasonDay> season_of(std::span<const weather::Day> days, double first_snow_mm) {
  const std::vector<double> green = greenness(days);
  const std::vector<double> degrees = weathering_degrees(green);
  const std::vector<snowpack::SnowOnGround> snow =
      snowpack::snow_on_ground(days, {}, first_snow_mm);
  std::vector<SeasonDay> season;
  for (std::size_t i = 0; i < days.size(); ++i)
    season.push_back({days[i].date, green[i], degrees[i], snow[i].depth_m, snow[i].water_mm});
  return season;
}

}  // namespace wold::phenology
