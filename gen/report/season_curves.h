#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/table.h"
#include "phenology/season.h"
#include "report/chart.h"

namespace wold::report {

/// A row a day: date, greenness, weathering_degree, snow_depth_m, swe_mm.
std::vector<Column> season_table(std::span<const phenology::SeasonDay> days);

/// The same as a figure of three panels over time: meadow, depth of snow, its water. `days` is not
/// empty.
chart::Figure season_figure(const std::string& scene_name,
                            std::span<const phenology::SeasonDay> days);

}  // namespace wold::report
