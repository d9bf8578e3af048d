#include "core/quiet_gdal.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <string_view>

#include "core/files.h"

namespace wold {
namespace {

bool is_needed(std::string_view driver) {
  constexpr std::array<std::string_view, 2> others = {"CSV", "MEM"};
  return std::find(others.begin(), others.end(), driver) != others.end() ||
         std::find(std::begin(elevation_drivers), std::end(elevation_drivers), driver) !=
             std::end(elevation_drivers);
}

/// Where GDAL and PROJ came along with the program, the system's files are of other versions.
void find_bundled_files() {
  if (const auto folder = bundled_folder("gdal"); !folder.empty())
    CPLSetConfigOption("GDAL_DATA", folder.c_str());
  if (const auto folder = bundled_folder("proj"); !folder.empty()) {
    const std::array<const char*, 2> folders = {folder.c_str(), nullptr};
    OSRSetPROJSearchPaths(folders.data());
  }
}

/// Removed rather than passed over when a file is opened: GDAL itself opens masks and overviews
/// that lie beside a raster, by any driver there is.
void register_drivers() {
  CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
  // By itself it takes a grid of text for whole numbers as long as no number has a point.
  CPLSetConfigOption("AAIGRID_DATATYPE", "Float64");
  // Drivers outside the library: none is needed, and they may be of another version.
  CPLSetConfigOption("GDAL_DRIVER_PATH", "disable");
  OSRSetPROJEnableNetwork(0);
  find_bundled_files();
  GDALAllRegister();
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (int number = drivers.GetDriverCount() - 1; number >= 0; --number) {
    GDALDriver* const driver = drivers.GetDriver(number);
    if (is_needed(driver->GetDescription())) continue;
    drivers.DeregisterDriver(driver);
    GDALDestroyDriver(driver);
  }
}

}  // namespace

QuietGdal::QuietGdal() {
  static std::once_flag once;
  std::call_once(once, register_drivers);
  CPLPushErrorHandler(CPLQuietErrorHandler);
}

QuietGdal::~QuietGdal() { CPLPopErrorHandler(); }

}  // namespace wold
