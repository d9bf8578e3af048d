#include "terrain/elevation_model.h"

#include <cmath>

#include "core/elementary.h"
#include "core/quiet_gdal.h"
#include "terrain/local_system.h"
#include "terrain/raster.h"

namespace wold::terrain {
namespace {

/// Down to three digits.
double round_down(double value) {
  if (value <= 0.0) return 0.0;
  const double power = std::floor(math::log10(value)) - 2.0;
  const double digit = std::round(math::pow(10.0, std::abs(power)));
  return power >= 0.0 ? std::floor(value / digit) * digit : std::floor(value * digit) / digit;
}

}  // namespace

ElevationModel describe_elevation(const std::filesystem::path& file) {
  constexpr double largest_m = 200e3;
  const QuietGdal quiet;
  ElevationModel model;
  if (Raster(file, "").looks_like_degrees()) model.system = "EPSG:4326";
  const Raster raster(file, model.system);
  const LocalSystem local = local_system(raster, raster.middle());
  model.cell_m = cell_m(raster, local);
  model.square_m = round_down(covered_m(raster, local, largest_m));
  model.longitude_latitude_deg = longitude_latitude_deg(raster, raster.middle());
  return model;
}

}  // namespace wold::terrain
