#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "terrain/raster.h"

namespace wold::terrain {

/// Metres on the ground about a place of a raster, and where that lies in them.
struct LocalSystem {
  std::string definition;  ///< PROJ's; empty: the raster's own coordinates
  glm::dvec2 centre{0.0};
};

/// Longitude, from -180 to 180, and latitude (WGS 84) of a place in the raster's own coordinates,
/// degrees; nothing where the raster has no system. Throws InputError where that has no such place.
std::optional<glm::dvec2> longitude_latitude_deg(const Raster& raster, const glm::dvec2& place);

/// About `centre`, in the raster's own coordinates: azimuthal equidistant where the raster has a
/// system. Throws InputError where that has no such place.
LocalSystem local_system(const Raster& raster, const glm::dvec2& centre);

/// From places of the local system to places of the raster, in cells from its upper left corner.
class Transformer {
 public:
  /// Throws InputError. The raster has to outlive it.
  Transformer(const Raster& raster, const LocalSystem& local);

  /// GDAL's own, for GDALGenImgProjTransform().
  void* get() const { return transformer_.get(); }

  /// The raster's cell at a place of the local system, if there is one.
  std::optional<glm::dvec2> cell_at(glm::dvec2 place) const;

 private:
  struct Destroy {
    void operator()(void* transformer) const;
  };
  std::unique_ptr<void, Destroy> transformer_;
};

/// Side of the raster's cells in the local system. Throws InputError.
double cell_m(const Raster& raster, const LocalSystem& local);

/// Side of the largest square about the local system's centre that a raster covers, at most
/// `size_m`; 0 where it does not even cover the centre. Throws InputError.
double covered_m(const Raster& raster, const LocalSystem& local, double size_m);

}  // namespace wold::terrain
