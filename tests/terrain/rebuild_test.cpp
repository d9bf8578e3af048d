#include <fmt/format.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "support/places.h"
#include "support/temporary_folder.h"
#include "terrain/ground.h"
#include "terrain/streams.h"

/// Elevation models are thinned three times and made fine again; what comes back is held against
/// what was there.
namespace wold::terrain {
namespace {

constexpr int thinned = 3;

/// Heights on a regular grid, the northern row first.
struct Grid {
  int columns = 0, rows = 0;
  double cell_m = 1.0;
  std::vector<double> values;

  double& at(int column, int row) {
    return values.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column));
  }
  double at(int column, int row) const { return const_cast<Grid*>(this)->at(column, row); }
};

/// A model, or of a large one a part; cells taken as squares of that side.
Grid read_model(const char* name, double cell_m) {
  constexpr int most = 420;
  GDALAllRegister();
  const auto file = wold::test::tests_folder() / "data" / "terrain" / name;
  const GDALDatasetUniquePtr data(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
  if (!data) throw std::runtime_error(file.string());
  Grid grid{std::min(data->GetRasterXSize(), most) / thinned * thinned,
            std::min(data->GetRasterYSize(), most) / thinned * thinned,
            cell_m,
            {}};
  grid.values.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  EXPECT_EQ(
      data->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, grid.columns, grid.rows, grid.values.data(),
                                       grid.columns, grid.rows, GDT_Float64, 0, 0),
      CE_None);
  return grid;
}

/// Means of three by three cells.
Grid thin(const Grid& fine) {
  Grid coarse{fine.columns / thinned, fine.rows / thinned, thinned * fine.cell_m, {}};
  coarse.values.assign(fine.values.size() / (thinned * thinned), 0.0);
  for (int row = 0; row < fine.rows; ++row)
    for (int column = 0; column < fine.columns; ++column)
      coarse.at(column / thinned, row / thinned) += fine.at(column, row) / (thinned * thinned);
  return coarse;
}

void write(const Grid& grid, const std::filesystem::path& file) {
  GDALDatasetUniquePtr memory(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
      "", grid.columns, grid.rows, 1, GDT_Float64, nullptr));
  std::array<double, 6> place = {0.0, grid.cell_m, 0.0, grid.rows * grid.cell_m, 0.0, -grid.cell_m};
  memory->SetGeoTransform(place.data());
  std::vector<double> values = grid.values;
  EXPECT_EQ(
      memory->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows, values.data(),
                                         grid.columns, grid.rows, GDT_Float64, 0, 0),
      CE_None);
  GDALDatasetUniquePtr(GetGDALDriverManager()->GetDriverByName("GTiff")->CreateCopy(
      file.c_str(), memory.get(), FALSE, nullptr, nullptr, nullptr));
}

/// A square of the model, from a cell on, as the ground has it: row 0 in the south.
struct Part {
  glm::ivec2 first;
  GroundMap<double> heights_m;
};

/// Squares that cover the model along its longer side, a thinned cell from its border.
std::vector<Part> squares(const Grid& grid) {
  const int samples = std::min(grid.columns, grid.rows) - 2 * thinned;
  const glm::ivec2 free = glm::ivec2(grid.columns, grid.rows) - samples - 2 * thinned;
  const int count = 1 + std::max(free.x, free.y) / samples + (std::max(free.x, free.y) > 0 ? 1 : 0);
  std::vector<Part> parts;
  for (int k = 0; k < count; ++k) {
    Part part{thinned + (count > 1 ? free * k / (count - 1) : glm::ivec2(0)),
              GroundMap<double>(samples, (samples - 1) * grid.cell_m)};
    for (int j = 0; j < samples; ++j)
      for (int i = 0; i < samples; ++i)
        part.heights_m.at(i, j) = grid.at(part.first.x + i, part.first.y + samples - 1 - j);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// The same square, from the thinned model.
GroundMap<double> rebuilt(const Grid& grid, const Part& part, std::uint64_t seed) {
  const test::TemporaryFolder folder("rebuild");
  write(thin(grid), folder.path() / "thinned.tif");
  const double half_m = 0.5 * part.heights_m.samples() * grid.cell_m;
  scene::Terrain terrain;
  terrain.elevation = (folder.path() / "thinned.tif").string();
  terrain.size_m = part.heights_m.size_m();
  terrain.samples = part.heights_m.samples();
  terrain.centre = {part.first.x * grid.cell_m + half_m,
                    (grid.rows - part.first.y) * grid.cell_m - half_m};
  const Heightfield heights_m = make_ground(terrain, seed).heights_m;
  GroundMap<double> map = part.heights_m;
  std::ranges::copy(heights_m.values(), map.values().begin());
  return map;
}

/// Along both axes.
using Waves = std::vector<std::complex<double>>;
Waves transformed(const Waves& values, int n) {
  Waves turn(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k)
    turn[static_cast<std::size_t>(k)] = std::polar(1.0, -2.0 * std::numbers::pi * k / n);
  const auto index = [n](int i, int j) { return static_cast<std::size_t>(j * n + i); };
  Waves rows(values.size());
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k)
      for (int i = 0; i < n; ++i)
        rows[index(j, k)] += values[index(i, j)] * turn[static_cast<std::size_t>(i * k % n)];
  return rows;  // transposed
}

/// Mean power of waves between two frequencies, per cell, under a Hann window, without the plane
/// that the heights lie about.
double power_between(const GroundMap<double>& map, double low, double high) {
  const int n = map.samples();
  const double middle = 0.5 * (n - 1);
  double sum = 0.0, east = 0.0, north = 0.0, moment = 0.0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      sum += map.at(i, j) / n / n;
      east += map.at(i, j) * (i - middle);
      north += map.at(i, j) * (j - middle);
      moment += (i - middle) * (i - middle);
    }
  Waves values;
  const auto hann = [n](int i) {
    return 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * i / (n - 1));
  };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      values.emplace_back(
          hann(i) * hann(j) *
          (map.at(i, j) - sum - east / moment * (i - middle) - north / moment * (j - middle)));
  const Waves waves = transformed(transformed(values, n), n);
  double power = 0.0, count = 0.0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double frequency = std::hypot(std::min(i, n - i), std::min(j, n - j)) / n;
      if (frequency < low || frequency >= high) continue;
      power += std::norm(waves[static_cast<std::size_t>(j * n + i)]);
      count += 1.0;
    }
  return power / count;
}

using Values = std::vector<double>;
Values of_inner(const GroundMap<double>& map, const std::function<double(int, int)>& value) {
  Values values;
  for (int j = 1; j + 1 < map.samples(); ++j)
    for (int i = 1; i + 1 < map.samples(); ++i) values.push_back(value(i, j));
  std::ranges::sort(values);
  return values;
}

Values slopes(const GroundMap<double>& map) {
  return of_inner(map, [&](int i, int j) {
    return std::hypot(map.at(i + 1, j) - map.at(i - 1, j), map.at(i, j + 1) - map.at(i, j - 1));
  });
}

Values curvatures(const GroundMap<double>& map) {
  return of_inner(map, [&](int i, int j) {
    return map.at(i + 1, j) + map.at(i - 1, j) + map.at(i, j + 1) + map.at(i, j - 1) -
           4.0 * map.at(i, j);
  });
}

/// Kolmogorov's, between two sorted samples of one size.
double distance(const Values& a, const Values& b) {
  double largest = 0.0;
  std::size_t below = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    while (below < b.size() && b[below] <= a[k]) ++below;
    largest = std::max(largest, std::abs(static_cast<double>(k + 1) - static_cast<double>(below)));
  }
  return largest / static_cast<double>(a.size());
}

/// Fraction of the cells through which that many or more drain.
double channels(const GroundMap<double>& map, double drained) {
  const GroundMap<double> samples = drained_samples(map);
  return static_cast<double>(std::ranges::count_if(
             samples.values(), [drained](double value) { return value >= drained; })) /
         static_cast<double>(samples.values().size());
}

struct Model {
  const char* name;
  double cell_m;
  double finest_power = 1.0 / 1.5;  ///< least that comes back in the finest band
};

/// What is measured of a ground, over all of its squares, and over some seeds: small models have
/// few waves.
struct Measures {
  std::array<double, 3> power{};     ///< of waves between six and two cells, in three bands
  Values slopes, curvatures;         ///< sorted
  std::array<double, 3> channels{};  ///< through which 10, 30 and 100 cells drain
  static constexpr std::array<double, 3> drained = {10.0, 30.0, 100.0};

  void add(const GroundMap<double>& map) {
    const double third = std::cbrt(1.0 * thinned);
    double low = 0.5 / thinned;
    for (std::size_t k = 0; k < power.size(); ++k, low *= third) {
      power[k] += power_between(map, low, low * third);
      channels[k] += terrain::channels(map, drained[k]);
    }
    append(slopes, terrain::slopes(map));
    append(curvatures, terrain::curvatures(map));
  }

 private:
  static void append(Values& values, const Values& more) {
    values.insert(values.end(), more.begin(), more.end());
    std::ranges::sort(values);
  }
};

/// The octave and a half between what the thinned model's cells and the model's own can hold.
void expect_rebuilt(const Model& of, std::uint64_t seeds) {
  const Grid grid = read_model(of.name, of.cell_m);
  Measures model, again;
  for (const Part& part : squares(grid))
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      model.add(part.heights_m);
      again.add(rebuilt(grid, part, seed));
    }
  std::string found = fmt::format("{}: power", of.name);
  for (std::size_t k = 0; k < model.power.size(); ++k) {
    const double power = again.power[k] / model.power[k];
    EXPECT_GT(power, k == 2 ? of.finest_power : 1.0 / 1.5) << of.name << ", band " << k;
    EXPECT_LT(power, 1.5) << of.name << ", band " << k;
    found += fmt::format(" {:.2f}", power);
  }
  const double of_slopes = distance(again.slopes, model.slopes);
  const double of_curvatures = distance(again.curvatures, model.curvatures);
  EXPECT_LT(of_slopes, 0.1) << of.name;
  EXPECT_LT(of_curvatures, 0.1) << of.name;
  found += fmt::format(", slopes {:.3f}, curvatures {:.3f}, channels", of_slopes, of_curvatures);
  for (std::size_t k = 0; k < model.channels.size(); ++k) {
    const double ratio = again.channels[k] / model.channels[k];
    EXPECT_NEAR(ratio, 1.0, 0.2) << of.name << ", " << Measures::drained[k] << " cells drain";
    found += fmt::format(" {:.2f}", ratio);
  }
  fmt::print("{}\n", found);
}

TEST(Rebuild, BigTujungaFrom90To30Metres) { expect_rebuilt({"bigtujunga_srtm30.tif", 30.0}, 1); }

// Its cells, 71 by 92 m, taken as squares.
TEST(Rebuild, FrontRangeFrom243To81Metres) {
  expect_rebuilt({"front_range_srtm_gl3.asc", 81.0}, 3);
}

// A gully's sharp banks: of the shortest waves less comes back than of the mountains' (0.61 to
// 0.63).
TEST(Rebuild, BijouFrom15To5Metres) {
  expect_rebuilt({"bijou_grassland_5m.asc", 4.9887, 1.0 / 1.7}, 5);
}

}  // namespace
}  // namespace wold::terrain
