#include "terrain/photo.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/colour.h"
#include "core/quiet_gdal.h"
#include "terrain/relief.h"
#include "terrain/scene_place.h"
#include "terrain/thinned_cells.h"

namespace wold::terrain {
namespace {

constexpr int most_cells = 2048;  // along a side
constexpr int channels = 3;

bool is_known(const glm::dvec3& colour) { return !std::isnan(colour.r); }

/// Its system is the scene's where it does not say its own.
Raster photo_raster(const scene::Terrain& terrain) {
  constexpr const char* key = "terrain.photo";
  Raster raster(terrain.photo, "", key);
  return raster.system() != nullptr || terrain.system.empty()
             ? std::move(raster)
             : Raster(terrain.photo, terrain.system, key);
}

void require_colours(const Raster& raster) {
  constexpr double max_cells = 1 << 30;
  GDALDataset& dataset = raster.dataset();
  if (dataset.GetRasterCount() < channels)
    raster.fail(fmt::format("found {} bands, expected three or more: red, green and blue in sRGB",
                            dataset.GetRasterCount()));
  for (int band = 1; band <= channels; ++band)
    if (const GDALDataType type = dataset.GetRasterBand(band)->GetRasterDataType();
        type != GDT_Byte)
      raster.fail(fmt::format(
          "band {}: found values of type {}, expected bytes, from 0 to 255 (gdal_translate -ot "
          "Byte -scale)",
          band, GDALGetDataTypeName(type)));
  if (1.0 * dataset.GetRasterXSize() * dataset.GetRasterYSize() > max_cells)
    raster.fail(fmt::format("found {} x {} cells, expected {} at most: take a coarser photo",
                            dataset.GetRasterXSize(), dataset.GetRasterYSize(), max_cells));
}

std::array<double, 256> decoded_bytes() {
  std::array<double, 256> linear{};
  for (std::size_t byte = 0; byte < linear.size(); ++byte)
    linear[byte] = srgb_decoded(static_cast<double>(byte) / 255.0);
  return linear;
}

/// Means of a box of a photo, of so many cells along a side at most.
class MeanCells {
 public:
  MeanCells(const Raster& raster, const CellBox& box) : raster_(raster), box_(box) {
    const glm::ivec2 all = box.size();
    const double apart = std::max(1.0, std::ceil(1.0 * std::max(all.x, all.y) / most_cells));
    apart_ = static_cast<int>(apart);
    cells_ = {{box.first, all / apart_, {}}, apart};
    const glm::ivec2 size = cells_.block.size;
    colours_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
                    glm::dvec3(0.0));
    counts_.assign(colours_.size(), 0.0);
    if (size.x > 0)
      for (int row = 0; row < size.y * apart_; ++row) add_row(row);
  }

  const ThinnedCells& cells() const { return cells_; }
  /// NaN where nothing is shown, and for -1.
  glm::dvec3 colour(int cell) const {
    const auto k = static_cast<std::size_t>(cell);
    if (cell < 0 || counts_[k] <= 0.0) return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
    return colours_[k] / counts_[k];
  }

 private:
  void read(GDALRasterBand& band, int row, std::vector<std::uint8_t>& values) const {
    if (band.RasterIO(GF_Read, box_.first.x, box_.first.y + row, static_cast<int>(values.size()), 1,
                      values.data(), static_cast<int>(values.size()), 1, GDT_Byte, 0, 0,
                      nullptr) != CE_None)
      raster_.fail(CPLGetLastErrorMsg());
  }

  void add_row(int row) {
    const int columns = cells_.block.size.x * apart_;
    std::vector<std::uint8_t> shown(static_cast<std::size_t>(columns));
    std::array<std::vector<std::uint8_t>, channels> values;
    values.fill(shown);
    GDALDataset& dataset = raster_.dataset();
    for (int band = 0; band < channels; ++band)
      read(*dataset.GetRasterBand(band + 1), row, values[static_cast<std::size_t>(band)]);
    read(*dataset.GetRasterBand(1)->GetMaskBand(), row, shown);
    for (int column = 0; column < columns; ++column) {
      const auto k = static_cast<std::size_t>(column);
      if (shown[k] == 0) continue;
      const auto cell =
          static_cast<std::size_t>(row / apart_ * cells_.block.size.x + column / apart_);
      colours_[cell] +=
          glm::dvec3(linear_[values[0][k]], linear_[values[1][k]], linear_[values[2][k]]);
      counts_[cell] += 1.0;
    }
  }

  const std::array<double, 256> linear_ = decoded_bytes();
  const Raster& raster_;
  CellBox box_;
  int apart_ = 1;
  ThinnedCells cells_;
  std::vector<glm::dvec3> colours_;
  std::vector<double> counts_;
};

PhotoMap read_map(const scene::Terrain& terrain) {
  const QuietGdal quiet;
  const Raster elevation(terrain.elevation, terrain.system);
  const LocalSystem local = local_system(elevation, middle_of(terrain, elevation));
  const Raster raster = photo_raster(terrain);
  require_colours(raster);
  if (local.definition.empty() != (raster.system() == nullptr))
    raster.fail(
        "expected a coordinate system where terrain.elevation has one, and none where it has none");
  const MeanCells means(raster, cells_under(raster, local, terrain.size_m));
  const double side_m = means.cells().apart * cell_m(raster, local);
  const int samples =
      static_cast<int>(std::clamp(terrain.size_m / side_m + 1.0, 17.0, most_cells + 1.0));
  const GroundMap<glm::dvec3> colours =
      by_place<glm::dvec3>(means.cells(), raster, local, {{.size_m = terrain.size_m}, samples},
                           [&](int cell) { return means.colour(cell); });
  if (std::ranges::none_of(colours.values(), is_known))
    raster.fail(fmt::format("it shows nothing of the square of {} m (terrain.size); it reaches {}",
                            terrain.size_m, raster.extent()));
  PhotoMap photo(samples, colours.square());
  photo.values() = colours.values();
  return photo;
}

/// Least squares of brightness by [1, x, y] of the normal.
class BrightnessByNormal {
 public:
  void add(const glm::dvec3& up, double brightness) {
    const glm::dvec3 basis(1.0, up.x, up.y);
    squares_ += glm::outerProduct(basis, basis);
    products_ += brightness * basis;
  }
  /// Over that of level ground. 1 where the ground is too even to say.
  glm::dvec2 slopes() const {
    constexpr double least = 1e-6;  // mean square of the normals' tilt
    const double count = std::max(squares_[0][0], 1.0);
    const glm::dmat3 mean = squares_ / count;
    const double tilt =
        std::min(mean[1][1] - mean[0][1] * mean[0][1], mean[2][2] - mean[0][2] * mean[0][2]);
    if (tilt < least || std::abs(glm::determinant(mean)) < least * least) return glm::dvec2(0.0);
    const glm::dvec3 fit = glm::inverse(mean) * (products_ / count);
    return fit.x > 0.0 ? glm::dvec2(fit.y, fit.z) / fit.x : glm::dvec2(0.0);
  }

 private:
  glm::dmat3 squares_{0.0};
  glm::dvec3 products_{0.0};
};

double mean_luminance(const PhotoMap& photo) {
  double sum = 0.0;
  int count = 0;
  for (const glm::dvec3& colour : photo.values())
    if (is_known(colour)) sum += luminance(colour), ++count;
  return count > 0 ? sum / count : 0.0;
}

/// Visits each known colour with the ground's normal under it.
template <class Visit>
void each_known(PhotoMap& photo, const Heightfield& heights_m, const Visit& visit) {
  for (int j = 0; j < photo.samples(); ++j)
    for (int i = 0; i < photo.samples(); ++i) {
      const glm::dvec2 at_m = photo.place_m(i, j);
      glm::dvec3& colour = photo.at(i, j);
      if (is_known(colour)) visit(normal(heights_m, at_m.x, at_m.y), colour);
    }
}

/// How much of ground of a colour grass grows on.
double grass_share(const glm::dvec3& albedo) {
  constexpr double soil = 0.35, meadow = 0.40;   // green chromatic coordinates
  constexpr double woods = 0.03, bright = 0.08;  // luminances
  const glm::dvec3 display = srgb_encoded(glm::clamp(albedo, 0.0, 1.0));
  const double green = display.g / std::max(display.r + display.g + display.b, 1e-6);
  return glm::smoothstep(soil, meadow, green) * glm::smoothstep(woods, bright, luminance(albedo));
}

}  // namespace

PhotoMap without_shading(PhotoMap photo, const Heightfield& heights_m) {
  constexpr double least = 0.35, most = 2.0;  // of the light on level ground; less is cast shadow
  BrightnessByNormal brightness;
  each_known(photo, heights_m, [&](const glm::dvec3& up, const glm::dvec3& colour) {
    brightness.add(up, luminance(colour));
  });
  const double before = mean_luminance(photo);
  const glm::dvec2 slopes = brightness.slopes();
  each_known(photo, heights_m, [&](const glm::dvec3& up, glm::dvec3& colour) {
    colour /= std::clamp(1.0 + glm::dot(slopes, glm::dvec2(up)), least, most);
  });
  const double after = mean_luminance(photo);
  if (after > 0.0)
    for (glm::dvec3& colour : photo.values()) colour *= before / after;
  return photo;
}

LandCover::Shares Photo::at(const glm::dvec2& at_m) const {
  const glm::dvec2 place =
      glm::clamp((at_m - albedo_.corner_m()) / albedo_.step_m(), 0.0, albedo_.samples() - 1.0);
  const glm::ivec2 first = glm::min(glm::ivec2(place), albedo_.samples() - 2);
  const glm::dvec2 part = place - glm::dvec2(first);
  LandCover::Shares shares{.grass = 0.0};
  for (const glm::ivec2 corner : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    const double weight =
        (corner.x == 1 ? part.x : 1.0 - part.x) * (corner.y == 1 ? part.y : 1.0 - part.y);
    const glm::dvec3& albedo = albedo_.at(first.x + corner.x, first.y + corner.y);
    if (!is_known(albedo)) {
      shares.grass += weight;
      continue;
    }
    shares.grass += weight * grass_share(albedo);
    shares.coloured += weight;
    shares.albedo += glm::vec3(weight * glm::min(albedo, 1.0));
  }
  return shares;
}

std::optional<Photo> read_photo(const scene::Terrain& terrain, const Heightfield& heights_m) {
  if (terrain.photo.empty() || terrain.elevation.empty()) return std::nullopt;
  return Photo(without_shading(read_map(terrain), heights_m));
}

}  // namespace wold::terrain
