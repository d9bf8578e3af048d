#include <benchmark/benchmark.h>

#include <cstring>
#include <map>
#include <memory>

#include "cloud/compose.h"
#include "cloud/lifting.h"
#include "core/parallel.h"
#include "light/daylight.h"

/// What composing a frame of clouds costs. Per pixel and layer it reads a rank and a brightness of
/// 2 bytes each and, from near memory, an entry of 16 bytes for each; per pixel it writes 16 bytes.
/// 4096 x 4096 pixels of four layers are 268 MB read and 268 MB written, the traffic of copying 268
/// MB. Per pixel and layer there are 8 products and 6 sums of 16 bits, and 8 products and 5 sums or
/// differences of colours, four at a time.
namespace wold::cloud {
namespace {

scene::Scene sky_of(int layers) {
  using enum scene::CloudKind;
  const scene::CloudKind kinds[] = {cumulus, stratocumulus, cirrus, stratus};
  scene::Scene scene;
  for (int i = 0; i < layers; ++i) {
    scene::CloudLayer layer;
    layer.kind = kinds[i % 4];
    layer.cell_m = 4096.0;
    scene.clouds.push_back(layer);
  }
  return scene;
}

/// A state whose maps have side_px pixels along a side, at a time when drift is part of a pixel.
CloudState state_of(int layers, int side_px) {
  const scene::Scene scene = sky_of(layers);
  const Clouds clouds(scene, 8 * 4096.0 / side_px);
  return clouds.at(12.34);
}

void compose_frame(benchmark::State& state) {
  const auto layers = static_cast<int>(state.range(0)), side = static_cast<int>(state.range(1));
  static std::map<std::pair<int, int>, CloudState> states;  // made once, however often it is asked
  CloudState& clouds = states[{layers, side}];
  if (clouds.layers.empty()) clouds = state_of(layers, side);
  const ThreadLimit limit(static_cast<int>(state.range(2)));
  Image picture(side, side, 4);
  const SkyWindow window{{}, side, side};
  for (auto _ : state) {
    compose(clouds, window, picture);
    benchmark::DoNotOptimize(picture.values.data());
  }
  state.SetItemsProcessed(state.iterations());
}

/// Copies as many bytes as make the traffic of that frame, by as many threads.
void copy_the_bytes(benchmark::State& state) {
  const auto layers = static_cast<std::size_t>(state.range(0));
  const auto side = static_cast<std::size_t>(state.range(1));
  const ThreadLimit limit(static_cast<int>(state.range(2)));
  const std::size_t bytes = side * side * (4 * layers + 16) / 2;
  const std::vector<char> from(bytes, 1);
  std::vector<char> to(bytes);
  constexpr std::size_t blocks = 256;
  const std::size_t block = bytes / blocks;
  for (auto _ : state) {
    parallel_for(blocks, [&](std::size_t i) {
      std::memcpy(to.data() + i * block, from.data() + i * block, block);
    });
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations());
}

/// Lifting a layer to 256 x 256 x 64 voxels and baking its light.
void lift_and_light(benchmark::State& state) {
  const CloudState clouds = state_of(1, 1024);
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const light::Daylight day(scene::Sun{}, scene::Sky{});
  const LayerState& layer = clouds.layers.front();
  for (auto _ : state) {
    const CloudVolume volume =
        lifted(layer, clouds.pixel_m, {0.0, 0.0}, layer.layer->period_m, {256, 256, 64});
    benchmark::DoNotOptimize(source_radiance(volume, cloud_light(day, 0.0, {0.0, 0.0, 2.0})));
  }
}

BENCHMARK(lift_and_light)->Arg(0)->Arg(1)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(copy_the_bytes)->Args({4, 4096, 0})->Args({4, 4096, 1})->UseRealTime();
BENCHMARK(compose_frame)
    ->Args({4, 4096, 0})
    ->Args({4, 4096, 1})
    ->Args({3, 1024, 1})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wold::cloud

BENCHMARK_MAIN();
