#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>

namespace wold::terrain {

/// How the stored values of an elevation model are metres.
struct HeightScale {
  double factor;
  double offset_m;
  double height_m(double stored) const { return factor * stored + offset_m; }
};

/// An elevation model: a raster that lies somewhere on the ground, and the system of its
/// coordinates. Everything that fails throws InputError, by fail().
class Raster {
 public:
  /// A regular file of one of elevation_drivers. `system`: its coordinate system, "EPSG:4326",
  /// which wins over the file's own; empty: as the file says. `key`: of the scene, for messages.
  Raster(const std::filesystem::path& file, const std::string& system,
         const char* key = "terrain.elevation");

  /// Throws InputError, which names the key and the file.
  [[noreturn]] void fail(const std::string& reason) const;

  GDALDataset& dataset() const { return *dataset_; }
  /// Null where nobody names one.
  const OGRSpatialReference* system() const;
  /// What wins over the file's own; empty: nothing.
  const std::string& given_system() const { return given_; }

  /// Where the raster's middle lies, in its own coordinates.
  glm::dvec2 middle() const;
  /// "from 376313 to 412223 east and from ... north"
  std::string extent() const;
  HeightScale height_scale() const;

  /// Whether coordinates that nobody names lie on a globe's, with cells much too fine for metres.
  bool looks_like_degrees() const;
  /// What to do about that, as the end of a message; empty where they do not.
  std::string degrees_hint() const;

 private:
  struct Corners {
    glm::dvec2 low, high;
  };

  bool is_geographic() const { return system() != nullptr && system()->IsGeographic() != 0; }
  /// Where a place of the raster lies, from its upper left corner in cells.
  glm::dvec2 place(double column, double row) const;
  Corners corners() const;
  void take_system();
  void require_place() const;
  void require_extent() const;
  void require_rows_of_text() const;

  std::string file_;
  const char* key_;
  GDALDatasetUniquePtr dataset_;
  std::string given_;
  OGRSpatialReference given_system_;
  std::array<double, 6> transform_ = {};
};

}  // namespace wold::terrain
