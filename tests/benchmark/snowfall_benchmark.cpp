#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/files.h"
#include "core/parallel.h"
#include "snow/falling_snow.h"
#include "snow/paper_flakes.h"

/// What the state of falling snow costs: the falling half of the paper's table 1 (per second 65, 46
/// and 31 frames of 500, 1000 and 3000 flakes on 2 km, 32, 23 and 12 on 100 km, drawing included),
/// and a million flakes (place, half sides, picture and opacity: 44 bytes each) beside writing
/// them.
namespace wold::snow {
namespace {

const FlakePictures& pictures() {
  static const FlakePictures made(1);
  return made;
}

SnowView view_in(const scene::Scene& scene) {
  const double middle_m = 0.5 * scene.terrain.size_m;
  return {.eye_m = {middle_m, middle_m, 1.6}, .target_m = {middle_m, middle_m + 10.0, 2.0}};
}

/// Args: flakes in view, the terrain's side in km.
template <class Snow>
void frames_of_state(benchmark::State& state) {
  scene::Scene scene;
  scene.snowfall.strength = scene::SnowfallStrength::moderate;
  scene.snowfall.flakes = static_cast<int>(state.range(0));
  scene.terrain.size_m = 1e3 * static_cast<double>(state.range(1));
  const Snow snow(scene, Weather(scene, nullptr), pictures());
  const Heightfield ground(257, scene.terrain.size_m, 0.0F);
  const SnowView view = view_in(scene);
  double time_s = 0.0;
  std::size_t flakes = 0;
  for (auto _ : state) {
    time_s += 0.04;
    const SeenFlakes seen = snow.at(time_s, view, ground);
    flakes = seen.flakes.size();
    benchmark::DoNotOptimize(seen.flakes.data());
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["flakes"] = static_cast<double>(flakes);
}

constexpr std::size_t million = 1000000, at_once = 125;
static_assert(million % (lanes * at_once) == 0);

/// What a step took: of all threads together, and by the clock on the wall.
struct Took {
  double cpu_ms;
  double wall_ms;
};

template <class Step>
Took time_of(const Step& step) {
  const std::clock_t cpu = std::clock();
  const auto wall = std::chrono::steady_clock::now();
  step();
  const std::chrono::duration<double, std::milli> wall_ms = std::chrono::steady_clock::now() - wall;
  return {1e3 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC, wall_ms.count()};
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// A million flakes of a cube of air at some time, each with its look; then writing their arrays as
/// any other file of ours. By turns, so that whatever else the machine does slows both.
void advance_and_write_a_million(benchmark::State& state) {
  scene::Scene scene;
  scene.snowfall.strength = scene::SnowfallStrength::moderate;
  const FlakeMotion motion(scene, Weather(scene, nullptr), 1.2);
  const Frustum frustum(view_in(scene));
  const FlakeLook look(pictures(), frustum, scene.snowfall.shutter_s);
  const PeriodicCube cube = {frustum.eye_m() + 10.0 * frustum.ahead(), 13.0};
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "wold_snowfall_benchmark.bin";
  std::vector<SeenFlake> flakes(million);
  double time_s = 0.0;
  const auto advance = [&] {
    time_s += 1234.5;
    const FlakeMotion::Moment moment = motion.moment(time_s, 1.2);
    const FlakeMotion::Air air = FlakeMotion::air({1, million}, cube, moment, frustum.eye_m());
    const Chosen all = Chosen::by([](std::size_t) { return true; });
    parallel_for(million / lanes / at_once, [&](std::size_t block) {
      FlakeMotion::Drifting drifting;
      FlakeLanes flying;
      for (std::size_t i = block * at_once; i < (block + 1) * at_once; ++i) {
        motion.drift(air, i * lanes, drifting);
        motion.fly(drifting, moment, flying);
        look.see(flying, all, flakes.data() + i * lanes);
      }
    });
  };
  const auto write = [&] {
    write_file(path, std::string_view(reinterpret_cast<const char*>(flakes.data()),
                                      flakes.size() * sizeof(SeenFlake)));
  };
  std::array<std::vector<double>, 6> taken;
  for (auto _ : state) {
    const Took advancing = time_of(advance);
    const Took writing = time_of(write);
    const std::array values = {
        advancing.cpu_ms,  writing.cpu_ms,  advancing.cpu_ms / writing.cpu_ms,
        advancing.wall_ms, writing.wall_ms, advancing.wall_ms / writing.wall_ms};
    for (std::size_t i = 0; i < values.size(); ++i) taken[i].push_back(values[i]);
  }
  std::filesystem::remove(path);
  const std::array names = {"1_advance_cpu_ms",  "2_write_cpu_ms",  "3_ratio_cpu",
                            "4_advance_wall_ms", "5_write_wall_ms", "6_ratio_wall"};
  for (std::size_t i = 0; i < names.size(); ++i) state.counters[names[i]] = median(taken[i]);
}

BENCHMARK(frames_of_state<PaperSnow>)
    ->ArgsProduct({{500, 1000, 3000}, {2, 10, 100}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(frames_of_state<FallingSnow>)
    ->ArgsProduct({{500, 1000, 3000, 30000, 100000, 1000000}, {2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(advance_and_write_a_million)->Iterations(15)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wold::snow

BENCHMARK_MAIN();
