#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "core/parallel.h"
#include "snow/cover.h"
#include "snow/drifting.h"
#include "snow/large_cover.h"
#include "support/temporary_folder.h"

/// What snow on the ground costs. The paper's table 1, "falling + accumulating", has 60 frames per
/// second for 2 km and 500 flakes, and 9 for 100 km and 3000; its flakes' part is in
/// snowfall_benchmark.cpp. Advancing a pack is about 20 products and sums and 2 divisions on 24
/// bytes.
namespace wold::snow {
namespace {

WeatherMoment snowing(double) { return {-2.0, 2.0, 5.0, 75.0}; }

/// Ridges of 2 km and hills of 300 m, up to 30 degrees steep.
double relief_m(double x_m, double y_m) {
  return 300.0 * std::sin(x_m / 900.0) * std::cos(y_m / 1100.0) +
         20.0 * std::sin(x_m / 50.0 + y_m / 70.0);
}

Heightfield relief(int samples, double size_m) {
  Heightfield terrain(samples, size_m);
  parallel_for(static_cast<std::size_t>(samples), [&](std::size_t j) {
    for (int i = 0; i < samples; ++i)
      terrain.at(i, static_cast<int>(j)) = static_cast<float>(
          relief_m(i * terrain.step_m(), static_cast<double>(j) * terrain.step_m()));
  });
  return terrain;
}

/// A ground of that many kilometres, made once: 2 km at 2 m, larger ones at 30 m.
const Heightfield& ground(int km) {
  static std::map<int, Heightfield> grounds;
  Heightfield& terrain = grounds[km];
  if (terrain.samples() == 0) {
    const double size_m = 1000.0 * km, step_m = km == 2 ? 2.0 : 30.0;
    terrain = relief(static_cast<int>(std::ceil(size_m / step_m)) + 1, size_m);
  }
  return terrain;
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// A film's state, 337 x 337, and its white map at 3 cm: one frame after another.
void film_frame(benchmark::State& state) {
  scene::Scene scene;
  scene.ageing.frames.assign(48, 0.0);
  const SnowGround snow(scene, relief(337, 42.0), snowing);
  int frame = 0;
  snow.white(snow.at(0.0), 1401);  // lays out the patches
  for (auto _ : state) {
    const SnowGround::State now = snow.at(10.0 * (frame++ % 48));
    benchmark::DoNotOptimize(snow.white(now, 1401).values().data());
  }
}

/// The shelter of 1024 x 1024 places by 7 rays of 100 m; 42 m and 4 km wide.
void shelter(benchmark::State& state) {
  const Heightfield terrain = relief(1024, static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(shelter_deg(terrain, 75.0).values().data());
}

/// A day of a million packs without slides, hour by hour by degree-days, or in a season's steps by
/// the heat that they get.
void advance_a_day(benchmark::State& state) {
  const bool in_season = state.range(0) != 0;
  const Heightfield terrain = relief(1024, 4000.0);
  const HeightClasses classes(terrain.values());
  const GroundRise rise(terrain);
  const FactorMap drift(1024, 4000.0, 1.1F);
  WeatherMoment weather = snowing(0.0);
  if (in_season) weather.sky = snowpack::SkyForcing{.phase_c = -1.0, .sun_w_m2 = 90.0};
  const int step_h = in_season ? snowpack::snow_step_h : 1;
  SnowpackField packs(terrain.values().size(), {50.0, 0.25, 0.0});
  for (auto _ : state)
    for (int hour = 0; hour < 24; hour += step_h)
      advance(packs, classes, classes.step(weather, step_h, 3.0), drift.values(), rise);
}

/// One hour of weather over the whole ground, from disk to disk with all levels.
void advance_an_hour(benchmark::State& state) {
  const Heightfield& terrain = ground(static_cast<int>(state.range(0)));
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  const test::TemporaryFolder folder("cover_benchmark");
  const scene::Scene scene;
  LargeCover cover(scene, large_ground(terrain), snowing, folder.path(), {});
  int hour = 1;
  cover.integrate(hour);
  for (auto _ : state) cover.integrate(++hour);
  state.counters["places"] = static_cast<double>(terrain.values().size());
  state.counters["peak_MB"] = peak_memory_mb();
}

/// Ten hours in one pass, per hour.
void advance_ten_hours(benchmark::State& state) {
  const Heightfield& terrain = ground(static_cast<int>(state.range(0)));
  const test::TemporaryFolder folder("cover_benchmark");
  const scene::Scene scene;
  LargeCover cover(scene, large_ground(terrain), snowing, folder.path(), {});
  int hour = 1;
  cover.integrate(hour);
  for (auto _ : state) cover.integrate(hour += 10);
  state.counters["s_per_hour"] = benchmark::Counter(
      10.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// What a camera sees at 60 frames an hour, walking at 1.5 m a frame; hours are on disk already.
void view_frame(benchmark::State& state) {
  const int km = static_cast<int>(state.range(0));
  const test::TemporaryFolder folder("cover_benchmark");
  const scene::Scene scene;
  LargeCover cover(scene, large_ground(ground(km)), snowing, folder.path(), {});
  cover.view(0.0, {900.0, 900.0});
  int frame = 0;
  for (auto _ : state) {
    const int now = frame++ % 600;
    benchmark::DoNotOptimize(cover.view(5.9 * now, {900.0, 900.0 + 1.5 * now}).data());
  }
  state.counters["frames_per_s"] =
      benchmark::Counter(1.0, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(film_frame)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(shelter)
    ->Arg(42)
    ->Arg(4000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(advance_a_day)
    ->ArgName("season")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(advance_an_hour)
    ->ArgNames({"km", "threads"})
    ->ArgsProduct({{2, 10, 100}, {2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(advance_ten_hours)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(view_frame)
    ->ArgName("km")
    ->Arg(2)
    ->Arg(10)
    ->Arg(100)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace wold::snow

BENCHMARK_MAIN();
