#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <string>

#include "grass/mechanics/dynamics.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/texel_file.h"
#include "grass/texel/time_varying_texel.h"
#include "light/daylight.h"
#include "scene/key_frames.h"

/// What the time-varying texel costs, beside the figures of paper 1, section 5 (dual-core 2.4 GHz,
/// 256^3 voxels, 100 blades, about 5,000 points). Every benchmark is one run. `cpu_s` is processor
/// time, of all threads together, which other work on the machine hardly changes.
namespace {

using namespace wold;
using namespace wold::grass;
namespace fs = std::filesystem;

/// Processor time of the process since it was made.
class CpuClock {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

/// A folder that goes with all it holds.
class Scratch {
 public:
  Scratch() : path_(fs::temp_directory_path() / ("texel_benchmark_" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

double peak_memory_gb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e9;
}

/// The paper's sample: 100 blades at 254^3, its stages one by one.
struct Sample {
  Sample() {
    scene.grass.blades = 100;
    blades = scatter_blades(scene.grass, scene.ageing,
                            {scene.grass.patch_m, scene.grass.blades, scene.seed, 0});
    shape = {254, 254, scene.grass.patch_m / 254};
    points = sample_points(blades, shape, scene.grass.points_per_voxel_face, 1);
  }
  scene::Scene scene;
  std::vector<Blade> blades;
  TexelShape shape;
  Points points;
};

/// One run, beside the seconds that the paper gives for it.
template <class Run>
void measure(benchmark::State& state, double paper_s, const Run& run) {
  double cpu_s = 0.0;
  for (auto _ : state) {
    const CpuClock clock;
    run();
    cpu_s = clock.seconds();
  }
  state.counters["cpu_s"] = cpu_s;
  state.counters["paper_s"] = paper_s;
  state.counters["times_faster"] = paper_s / cpu_s;
}

void texel_to_points(benchmark::State& state) {
  const Sample sample;
  Points points;
  measure(state, 0.22, [&] {
    points =
        sample_points(sample.blades, sample.shape, sample.scene.grass.points_per_voxel_face, 1);
  });
  state.counters["points"] = static_cast<double>(points.size());
}

void dynamics_step(benchmark::State& state) {
  const Sample sample;
  const AgeingModel model(sample.scene.ageing, sample.scene.grass.specular);
  PointDynamics dynamics(model, sample.blades, sample.points, 0.1 * sample.shape.voxel_m);
  dynamics.advance_to(0.0);
  measure(state, 6.3, [&] { dynamics.advance_to(0.5); });
  state.counters["points"] = static_cast<double>(dynamics.points().size());
}

/// One step of Algorithm 1 under the forces on the points, of as many of them as in the paper.
/// Bound of this project: 1 ms.
void point_step(benchmark::State& state) {
  constexpr double bound_ms = 1.0;
  Sample sample;
  sample.scene.ageing.motion = scene::AgeingMotion::points;
  sample.scene.ageing.droop_rule = scene::DroopRule::elastica;
  const double points_per_voxel_face =
      sample.scene.grass.points_per_voxel_face * 5000.0 / static_cast<double>(sample.points.size());
  sample.points = sample_points(sample.blades, sample.shape, points_per_voxel_face, 1);
  const AgeingModel model(sample.scene.ageing, sample.scene.grass.specular);
  PointDynamics dynamics(model, sample.blades, sample.points, 0.1 * sample.shape.voxel_m);
  const double step = 1.0 / BladeMotion::usual_steps;
  double weathering = 0.1;
  dynamics.advance_to(weathering);
  double cpu_s = 0.0;
  for (auto _ : state) {
    const CpuClock clock;
    dynamics.advance_to(weathering += step);
    cpu_s += clock.seconds();
  }
  state.counters["cpu_ms"] = cpu_s * 1e3 / static_cast<double>(state.iterations());
  state.counters["bound_ms"] = bound_ms;
  state.counters["points"] = static_cast<double>(dynamics.points().size());
}

void conversion_and_storage(benchmark::State& state) {
  const Sample sample;
  const Scratch scratch;
  const AgeingModel model(sample.scene.ageing, sample.scene.grass.specular);
  PointDynamics dynamics(model, sample.blades, sample.points, 0.0);
  dynamics.advance_to(0.5);
  const fs::path path = scratch.path() / "texel.vdb";
  measure(state, 2.61, [&] {
    write_texel(path, rasterise_points(dynamics.points(), sample.shape), "benchmark");
  });
  state.counters["MB"] = static_cast<double>(fs::file_size(path)) / 1e6;
}

/// Every variant, key frame and level of a scene, baked for one quarter-turn.
TexelDemand everything(const scene::Scene& scene) {
  const scene::Grass& grass = scene.grass;
  LodTurns lods;
  for (int lod = 0; lod < static_cast<int>(grass.lods.size()); ++lod) lods[lod] = {0};
  TexelDemand demand;
  for (int variant = 0; variant < grass.variants; ++variant)
    for (int key_frame = 0; key_frame < static_cast<int>(scene::key_frames(scene).size());
         ++key_frame)
      demand[variant][key_frame] = lods;
  return demand;
}

/// The default scene's texel: 13 key frames x 4 variants of 400 blades at 254^3, all levels, baked
/// and stored. Bounds of this project: 20 s and 2 GB.
void whole_time_varying_texel(benchmark::State& state) {
  constexpr double bound_s = 20.0;
  constexpr double bound_gb = 2.0;
  const scene::Scene scene;
  const light::Daylight daylight(scene.sun, scene.sky);
  const Scratch scratch;
  const TimeVaryingTexel texel(scene, {make_lighting(daylight, {0.0, -1.0, 0.0}, glm::vec3(0.1F))},
                               scratch.path());
  SilentProgress progress;
  StageTimes times;
  double cpu_s = 0.0;
  for (auto _ : state) {
    const CpuClock clock;
    times = texel.generate(everything(scene), progress);
    cpu_s = clock.seconds();
  }
  state.counters["cpu_s"] = cpu_s;
  state.counters["bound_s"] = bound_s;
  state.counters["peak_GB"] = peak_memory_gb();
  state.counters["bound_GB"] = bound_gb;
  state.counters["sampling_s"] = times.sampling;
  state.counters["dynamics_s"] = times.dynamics;
  state.counters["conversion_s"] = times.conversion;
  state.counters["baking_s"] = times.baking;
  state.counters["storing_s"] = times.storing;
  state.SetLabel(peak_memory_gb() <= bound_gb ? "memory within its bound"
                                              : "MORE MEMORY THAN ITS BOUND");
}

BENCHMARK(texel_to_points)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(dynamics_step)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(point_step)->Iterations(48)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(conversion_and_storage)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
BENCHMARK(whole_time_varying_texel)->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
