#include "report/curves_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace wold::report {
namespace {

using grass::WitheredState;

/// Blue and red absorption, the green peak, the bottom of the red and the red edge's shoulder.
constexpr double columns_nm[] = {450.0, 550.0, 650.0, 680.0, 740.0};

/// The model wavelength nearest to the one asked for.
std::size_t nearest(const std::vector<double>& wavelength_nm, double wanted_nm) {
  const auto above = std::lower_bound(wavelength_nm.begin(), wavelength_nm.end(), wanted_nm - 2.5);
  return std::min(static_cast<std::size_t>(above - wavelength_nm.begin()),
                  wavelength_nm.size() - 1);
}

void add_cases(std::vector<Column>& table, const std::string& quantity,
               const std::vector<grass::ShippedCurve>& curves) {
  for (const grass::ShippedCurve& curve : curves)
    table.push_back({fmt::format("{}_{}", quantity, curve.name), curve.values});
}

}  // namespace

std::vector<Column> withering_table(const grass::WitheringCurves& curves) {
  std::vector<Column> table;
  const auto add = [&](std::string name, const auto& value_of) {
    Column column{std::move(name), {}};
    for (const WitheredState& state : curves.states) column.values.push_back(value_of(state));
    table.push_back(std::move(column));
  };
  add("weathering_degree", [](const WitheredState& state) { return state.weathering; });
  add("chlorophyll", [](const WitheredState& state) { return state.chlorophyll; });
  add_cases(table, "chlorophyll", curves.chlorophyll);
  add("carotenoid", [](const WitheredState& state) { return state.carotenoid; });
  add("water", [](const WitheredState& state) { return state.water; });
  add_cases(table, "water", curves.water);
  add("strain_vein", [](const WitheredState& state) { return state.tissue.strain_vein; });
  add("strain_mesophyll", [](const WitheredState& state) { return state.tissue.strain_mesophyll; });
  add("modulus_vein_pa", [](const WitheredState& state) { return state.tissue.modulus_vein_pa; });
  add("modulus_mesophyll_pa",
      [](const WitheredState& state) { return state.tissue.modulus_mesophyll_pa; });
  add("stress_vein_pa", [](const WitheredState& state) { return state.tissue.stress_vein_pa; });
  add("stress_mesophyll_pa",
      [](const WitheredState& state) { return state.tissue.stress_mesophyll_pa; });
  add("tip_angle_deg", [](const WitheredState& state) { return state.tip_angle_deg; });
  add("colour_r_srgb", [](const WitheredState& state) { return state.srgb.r; });
  add("colour_g_srgb", [](const WitheredState& state) { return state.srgb.g; });
  add("colour_b_srgb", [](const WitheredState& state) { return state.srgb.b; });
  for (const double wanted_nm : columns_nm)
    add(fmt::format("reflectance_{:.0f}nm", wanted_nm),
        [at = nearest(curves.wavelength_nm, wanted_nm)](const WitheredState& state) {
          return state.reflectance[at];
        });
  return table;
}

}  // namespace wold::report
