#include <benchmark/benchmark.h>
#include <openvdb/points/PointAttribute.h>
#include <openvdb/points/PointConversion.h>
#include <openvdb/points/PointRasterizeTrilinear.h>
#include <openvdb/version.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <numeric>

#include "core/parallel.h"
#include "grass/mechanics/dynamics.h"
#include "grass/texel/columns.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/texel_file.h"
#include "scene/key_frames.h"

// From 12 on the header includes another one that Debian's package lacks (13.0.0-3).
#if OPENVDB_LIBRARY_MAJOR_VERSION_NUMBER < 12
#include <openvdb/points/PointRasterizeSDF.h>
#endif

/// Points to texel at 254^3 for the default patch of 400 blades: against a plain copy of the bytes
/// it writes and against OpenVDB's own rasterisers; the step of point dynamics for 5,000 to
/// 1,000,000 points and one or two threads; and the size of a season on disk.
namespace {

using namespace wold;
using namespace wold::grass;

struct Patch {
  explicit Patch(int blade_count = 400) {
    scene.grass.blades = blade_count;
    scene.grass.patch_m *= std::sqrt(blade_count / 400.0);
    blades = scatter_blades(scene.grass, scene.ageing,
                            {scene.grass.patch_m, scene.grass.blades, scene.seed, 0});
    // 254 voxels along the default patch: the same voxel for any number of blades.
    const double voxel_m = scene::Scene().grass.patch_m / 254;
    shape = {static_cast<int>(std::lround(scene.grass.patch_m / voxel_m)), 254, voxel_m};
    points = sample_points(blades, shape, scene.grass.points_per_voxel_face, 1);
  }
  PointDynamics dynamics(const AgeingModel& model) const {
    return {model, blades, points, 0.1 * shape.voxel_m};
  }
  scene::Scene scene;
  std::vector<Blade> blades;
  TexelShape shape;
  Points points;
};

const Patch& patch() {
  static const Patch shared;
  return shared;
}

const AgeingModel& model() {
  static const AgeingModel shared(scene::Scene().ageing, scene::Scene().grass.specular);
  return shared;
}

/// The fresh patch's points.
const Points& points() {
  static const Points shared = [] {
    PointDynamics dynamics = patch().dynamics(model());
    dynamics.advance_to(0.0);
    return dynamics.points();
  }();
  return shared;
}

double points_area_m2() {
  return std::accumulate(points().area_m2.begin(), points().area_m2.end(), 0.0);
}

std::size_t bytes(const Texel& texel) {
  return texel.size() * (sizeof(std::uint32_t) + 2 * sizeof(float) + 3 * sizeof(glm::vec3));
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double smallest(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

/// Runs of something, by the clock and by the time of all processors together.
class Runs {
 public:
  template <class Run>
  void add(const Run& run) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    run();
    cpu_s.push_back(static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC);
    s.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::vector<double> s, cpu_s;
};

/// How many copies of the bytes it writes take as long; every run is followed by a copy. Bound of
/// this project: 5. By the medians, by the shortest of each, which is what the machine does when
/// nobody else works on it, and, for the time of all processors, which others hardly change.
void points_to_texel(benchmark::State& state) {
  Texel texel = rasterise_points(points(), patch().shape);
  const std::vector<char> from(bytes(texel), 1);
  std::vector<char> to(from.size());
  Runs conversions, copies;
  for (auto _ : state) {
    conversions.add([&] { texel = rasterise_points(points(), patch().shape); });
    copies.add([&] {
      std::memcpy(to.data(), from.data(), from.size());
      benchmark::ClobberMemory();
    });
    state.SetIterationTime(conversions.s.back());
  }
  state.counters["voxels"] = static_cast<double>(texel.size());
  state.counters["MB"] = static_cast<double>(from.size()) / 1e6;
  state.counters["copy_ms"] = 1e3 * median(copies.s);
  state.counters["copies"] = median(conversions.s) / median(copies.s);
  state.counters["copies_shortest"] = smallest(conversions.s) / smallest(copies.s);
  state.counters["copies_cpu"] = median(conversions.cpu_s) / median(copies.cpu_s);
  state.counters["area_error"] = std::abs(texel.area_m2() / points_area_m2() - 1.0);
}

openvdb::points::PointDataGrid::Ptr point_grid() {
  namespace vdb = openvdb::points;
  openvdb::initialize();
  const auto transform = openvdb::math::Transform::createLinearTransform(patch().shape.voxel_m);
  std::vector<openvdb::Vec3s> positions, tangents, normals, albedos;
  const auto as_vec3s = [](const glm::vec3& v) { return openvdb::Vec3s(v.x, v.y, v.z); };
  for (std::size_t i = 0; i < points().size(); ++i) {
    positions.push_back(as_vec3s(points().position_m[i]));
    tangents.push_back(as_vec3s(points().tangent[i]));
    normals.push_back(as_vec3s(points().normal[i]));
    albedos.push_back(as_vec3s(points().albedo[i]));
  }
  const vdb::PointAttributeVector<openvdb::Vec3s> wrapper(positions);
  const auto index =
      openvdb::tools::createPointIndexGrid<openvdb::tools::PointIndexGrid>(wrapper, *transform);
  auto grid =
      vdb::createPointDataGrid<vdb::NullCodec, vdb::PointDataGrid>(*index, wrapper, *transform);
  const auto add = [&](const char* name, const auto& values) {
    using Value = typename std::decay_t<decltype(values)>::value_type;
    vdb::appendAttribute<Value>(grid->tree(), name);
    vdb::populateAttribute<openvdb::points::PointDataTree, openvdb::tools::PointIndexTree,
                           vdb::PointAttributeVector<Value>>(
        grid->tree(), index->tree(), name, vdb::PointAttributeVector<Value>(values));
  };
  add("tangent", tangents);
  add("normal", normals);
  add("albedo", albedos);
  add("specular", points().specular);
  add("area", points().area_m2);
  return grid;
}

template <class Tree>
double sum_of(const Tree& tree) {
  double sum = 0.0;
  for (auto value = tree.cbeginValueOn(); value; ++value) sum += double{*value};
  return sum;
}

/// Trilinear weights, each attribute by itself. It gives means, so the area it shows is not the
/// points'.
void openvdb_trilinear(benchmark::State& state) {
  namespace vdb = openvdb::points;
  const auto grid = point_grid();
  double area_m2 = 0.0;
  for (auto _ : state) {
    const auto area = vdb::rasterizeTrilinear<false, float>(grid->tree(), "area");
    const auto specular = vdb::rasterizeTrilinear<false, float>(grid->tree(), "specular");
    const auto albedo = vdb::rasterizeTrilinear<false, openvdb::Vec3s>(grid->tree(), "albedo");
    const auto normal = vdb::rasterizeTrilinear<false, openvdb::Vec3s>(grid->tree(), "normal");
    const auto tangent = vdb::rasterizeTrilinear<false, openvdb::Vec3s>(grid->tree(), "tangent");
    area_m2 = sum_of(static_cast<const openvdb::FloatTree&>(*area));
  }
  state.counters["area_error"] = std::abs(area_m2 / points_area_m2() - 1.0);
}

#if OPENVDB_LIBRARY_MAJOR_VERSION_NUMBER < 12
/// Spheres as wide as our footprint's sigma, every attribute from the closest point.
void openvdb_spheres(benchmark::State& state) {
  namespace vdb = openvdb::points;
  const auto grid = point_grid();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        vdb::rasterizeSpheres<vdb::PointDataGrid, openvdb::TypeList<openvdb::Vec3s, float>>(
            *grid, 1.0 * patch().shape.voxel_m, {"tangent", "normal", "albedo", "specular", "area"},
            1.0));
}
BENCHMARK(openvdb_spheres)->UseRealTime()->Unit(benchmark::kMillisecond);
#endif

/// One step for `range(0)` blades with `range(1)` threads.
void dynamics_step(benchmark::State& state) {
  const Patch sized(static_cast<int>(state.range(0)));
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  PointDynamics dynamics = sized.dynamics(model());
  dynamics.advance_to(0.0);
  for (auto _ : state) dynamics.advance_to(0.5);
  const auto count = static_cast<double>(dynamics.points().size());
  state.counters["points"] = count;
  state.counters["points_per_s"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
}

/// What the sun's side of a texel looks like from 30 degrees of elevation: mean radiance per ray of
/// its albedo as a source.
std::vector<glm::vec3> picture(const Texel& texel) {
  const VoxelRows voxels(texel.shape, texel.voxel);
  std::vector<glm::vec3> weighted(texel.size());
  for (std::size_t i = 0; i < texel.size(); ++i) weighted[i] = texel.density[i] * texel.albedo[i];
  return optical_depths(voxels, weighted, direction_at(0.5236, 0.4));
}

/// Thirteen key frames of a 254^3 texel as they lie on disk, against dense floats of the same four
/// attributes: 1 + 3 + 3 + 3 numbers per voxel. PSNR of a picture of the stored texel against the
/// one in memory.
void season_on_disk(benchmark::State& state) {
  namespace fs = std::filesystem;
  const fs::path file = fs::temp_directory_path() / "wold_season.vdb";
  double on_disk = 0.0;
  double squares = 0.0;
  double values = 0.0;
  double peak = 0.0;
  for (auto _ : state) {
    PointDynamics dynamics = patch().dynamics(model());
    for (const double weathering : scene::key_frames(patch().scene)) {
      dynamics.advance_to(weathering);
      const Texel texel = rasterise_points(dynamics.points(), patch().shape);
      write_texel(file, texel, "season");
      on_disk += static_cast<double>(fs::file_size(file));
      const auto before = picture(texel);
      const auto after = picture(read_texel(file));
      for (std::size_t ray = 0; ray < before.size(); ++ray) {
        const glm::dvec3 apart(before[ray] - after[ray]);
        squares += glm::dot(apart, apart);
        values += 3.0;
        peak = std::max({peak, double{before[ray].x}, double{before[ray].y}});
      }
    }
  }
  fs::remove(file);
  const double key_frames = static_cast<double>(scene::key_frames(patch().scene).size());
  const double dense = key_frames * 254.0 * 254.0 * 254.0 * 10.0 * sizeof(float);
  state.counters["MB"] = on_disk / 1e6;
  state.counters["times_smaller"] = dense / on_disk;
  state.counters["PSNR_dB"] = 10.0 * std::log10(peak * peak / (squares / values));
}

BENCHMARK(points_to_texel)->UseManualTime()->MinTime(2.0)->Unit(benchmark::kMillisecond);
BENCHMARK(openvdb_trilinear)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(dynamics_step)
    ->ArgNames({"blades", "threads"})
    ->Args({16, 1})
    ->Args({400, 1})
    ->Args({3400, 1})
    ->Args({3400, 2})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(season_on_disk)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
