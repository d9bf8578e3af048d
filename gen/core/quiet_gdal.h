#pragma once

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <mutex>

namespace wold {

/// GDAL with its drivers registered; while this lives, its messages go into our errors, not to the
/// terminal: CPLGetLastErrorMsg() has the latest.
class QuietGdal {
 public:
  QuietGdal() {
    static std::once_flag once;
    std::call_once(once, GDALAllRegister);
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

}  // namespace wold
