#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "core/parallel.h"
#include "snow/falling_snow.h"
#include "snow/paper_flakes.h"

/// What the state of falling snow costs: the falling half of the paper's table 1 (per second 65, 46
/// and 31 frames of 500, 1000 and 3000 flakes on 2 km, 32, 23 and 12 on 100 km, drawing included),
/// and a million flakes beside writing what they are.
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
  scene.snowfall.strength = "moderate";
  scene.snowfall.flakes = static_cast<int>(state.range(0));
  scene.terrain.size_m = 1e3 * static_cast<double>(state.range(1));
  const Snow snow(scene, Weather(scene), pictures());
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

constexpr std::size_t million = 1000000;

/// As a renderer has them: place, half sides, picture and opacity as floats, 44 bytes each.
std::vector<SeenFlake>& arrays() {
  static std::vector<SeenFlake> flakes(million);
  return flakes;
}

/// A million flakes of a cube of air at some time, each with its look.
void advance_a_million(benchmark::State& state) {
  scene::Scene scene;
  scene.snowfall.strength = "moderate";
  const FlakeMotion motion(scene, Weather(scene), 1.2);
  const Frustum frustum(view_in(scene));
  const FlakeLook look(pictures(), frustum, scene.snowfall.shutter_s);
  const PeriodicCube cube = {frustum.eye_m() + 10.0 * frustum.ahead(), 13.0};
  std::vector<SeenFlake>& flakes = arrays();
  double time_s = 0.0;
  for (auto _ : state) {
    time_s += 1234.5;
    const FlakeMotion::Moment moment = motion.moment(time_s, 1.2);
    parallel_for_blocks(million, [&](std::size_t i) {
      flakes[i] = look.seen(motion.flake(motion.drifting(1, i, moment, cube), moment));
    });
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(million));
}

/// Writing their arrays to a file.
void write_a_million(benchmark::State& state) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "wold_snowfall_benchmark.bin";
  const std::vector<SeenFlake>& flakes = arrays();
  for (auto _ : state) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(flakes.data()),
               static_cast<std::streamsize>(flakes.size() * sizeof(SeenFlake)));
    file.close();
    if (!file) state.SkipWithError("the arrays could not be written");
  }
  std::filesystem::remove(path);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(million));
}

BENCHMARK(frames_of_state<PaperSnow>)
    ->ArgsProduct({{500, 1000, 3000}, {2, 10, 100}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(frames_of_state<FallingSnow>)
    ->ArgsProduct({{500, 1000, 3000, 30000, 100000, 1000000}, {2}})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(advance_a_million)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(write_a_million)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wold::snow

BENCHMARK_MAIN();
