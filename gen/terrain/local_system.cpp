#include "terrain/local_system.h"

#include <fmt/format.h>
#include <gdal_alg.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/elementary.h"

namespace wold::terrain {

std::optional<glm::dvec2> longitude_latitude_deg(const Raster& raster, const glm::dvec2& place) {
  if (raster.system() == nullptr) return std::nullopt;
  OGRSpatialReference from = *raster.system();
  OGRSpatialReference to;
  to.SetWellKnownGeogCS("WGS84");
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_degrees(
      OGRCreateCoordinateTransformation(&from, &to));
  glm::dvec2 degrees = place;
  if (!to_degrees || to_degrees->Transform(1, &degrees.x, &degrees.y) == 0)
    raster.fail(fmt::format("[{}, {}] (terrain.centre) is no place of its coordinate system",
                            place.x, place.y));
  degrees.x = std::remainder(degrees.x, 360.0);
  return degrees;
}

LocalSystem local_system(const Raster& raster, const glm::dvec2& centre) {
  const std::optional<glm::dvec2> degrees = longitude_latitude_deg(raster, centre);
  if (!degrees) return {"", centre};
  return {fmt::format("+proj=aeqd +lat_0={:.12f} +lon_0={:.12f} +datum=WGS84 +units=m", degrees->y,
                      degrees->x),
          glm::dvec2(0.0)};
}

Transformer::Transformer(const Raster& raster, const LocalSystem& local) {
  std::string target = "DST_SRS=" + local.definition;
  std::string source = "SRC_SRS=" + raster.given_system();
  std::array<char*, 3> options = {target.data(), source.data(), nullptr};
  if (raster.given_system().empty()) options[1] = nullptr;
  if (local.definition.empty()) options[0] = nullptr;
  transformer_.reset(GDALCreateGenImgProjTransformer2(&raster.dataset(), nullptr, options.data()));
  if (!transformer_) raster.fail(CPLGetLastErrorMsg());
}

std::optional<glm::dvec2> Transformer::cell_at(glm::dvec2 place) const {
  double z = 0.0;
  int success = 0;
  if (GDALGenImgProjTransform(transformer_.get(), TRUE, 1, &place.x, &place.y, &z, &success) == 0 ||
      success == 0 || !std::isfinite(place.x) || !std::isfinite(place.y))
    return std::nullopt;
  return place;
}

void Transformer::Destroy::operator()(void* transformer) const {
  GDALDestroyGenImgProjTransformer(transformer);
}

double cell_m(const Raster& raster, const LocalSystem& local) {
  std::array<double, 6> transform = {};
  if (local.definition.empty()) {
    raster.dataset().GetGeoTransform(transform.data());
    return math::hypot(transform[1], transform[4]);
  }
  const Transformer transformer(raster, local);
  int columns = 0;
  int rows = 0;
  if (GDALSuggestedWarpOutput(&raster.dataset(), GDALGenImgProjTransform, transformer.get(),
                              transform.data(), &columns, &rows) != CE_None)
    raster.fail(CPLGetLastErrorMsg());
  return std::round(transform[1] * 0x1p20) * 0x1p-20;  // the same on every system
}

double covered_m(const Raster& raster, const LocalSystem& local, double size_m) {
  const Transformer transformer(raster, local);
  const glm::dvec2 all(raster.dataset().GetRasterXSize(), raster.dataset().GetRasterYSize());
  const auto is_covered = [&](double side_m) {
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) {
        const auto cell = transformer.cell_at(local.centre + 0.5 * side_m * glm::dvec2(i, j));
        if (!cell || glm::any(glm::lessThan(*cell, glm::dvec2(0.0))) ||
            glm::any(glm::greaterThan(*cell, all)))
          return false;
      }
    return true;
  };
  double covered = 0.0;
  for (double step_m = 0.5 * size_m; step_m > 1e-3 * std::max(covered, 1e-3 * size_m);
       step_m *= 0.5)
    if (is_covered(covered + step_m)) covered += step_m;
  return covered;
}

}  // namespace wold::terrain
