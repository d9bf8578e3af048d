#include "core/libraries.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <gdal.h>
#include <ogr_srs_api.h>
#include <openvdb/version.h>
#include <tbb/version.h>
#include <xxhash.h>
#include <zip.h>

namespace wold {
namespace {

/// "2.4.7" of 20407.
std::string version_of_number(unsigned number) {
  return fmt::format("{}.{}.{}", number / 10000, number / 100 % 100, number % 100);
}

std::string version_of_proj() {
  int major = 0, minor = 0, patch = 0;
  OSRGetPROJVersion(&major, &minor, &patch);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

}  // namespace

std::vector<LibraryVersion> library_versions() {
  return {{"OpenVDB", OPENVDB_LIBRARY_VERSION_STRING},
          {"OpenImageIO", version_of_number(static_cast<unsigned>(OIIO::openimageio_version()))},
          {"GDAL", GDALVersionInfo("RELEASE_NAME")},
          {"PROJ", version_of_proj()},
          {"oneTBB", TBB_runtime_version()},
          {"fmt", version_of_number(FMT_VERSION)},
          {"libzip", zip_libzip_version()},
          {"xxHash", version_of_number(XXH_versionNumber())}};
}

}  // namespace wold
