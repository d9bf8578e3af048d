#pragma once

namespace wold {

/// Readers of elevation models that are plain files: what lies in the file, or in one beside it of
/// the same name. GDAL's other readers follow what a file says to networks, programs and other
/// files, whatever the file is called.
inline constexpr const char* elevation_drivers[] = {
    "GTiff", "AAIGrid", "GRASSASCIIGrid", "ISG",  "SRTMHGT", "DTED", "USGSDEM",
    "ENVI",  "EHdr",    "GSAG",           "GSBG", "GS7BG",   "SAGA", "XYZ"};

/// GDAL with elevation_drivers, tables of text (CSV) and rasters in memory (MEM), and no other
/// drivers; without the network, and without the .aux.xml files that GDAL reads and writes beside
/// rasters. While this lives, GDAL's messages go into our errors, not to the terminal:
/// CPLGetLastErrorMsg() has the latest.
class QuietGdal {
 public:
  QuietGdal();
  ~QuietGdal();
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

}  // namespace wold
