#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/chart.h"
#include "core/table.h"
#include "season/season.h"

namespace wold::cli {

/// A row a day: date, greenness, weathering_degree, snow_depth_m, swe_mm.
std::vector<Column> season_table(std::span<const season::SeasonDay> days);

/// The same as a figure of three panels over time: meadow, depth of snow, its water. `days` is not
/// empty.
chart::Figure season_figure(const std::string& scene_name, std::span<const season::SeasonDay> days);

}  // namespace wold::cli
