#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "cloud/compose.h"
#include "core/parallel.h"
#include "core/random.h"
#include "grass/mechanics/dynamics.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/time_varying_texel.h"
#include "light/daylight.h"
#include "snow/falling_snow.h"
#include "support/places.h"
#include "support/sanitized.h"
#include "support/temporary_folder.h"

/// Whether what counts has become slower: costs as multiples of something plain that is done in the
/// same run, by turns, so that a slow or busy machine slows both. One thread and its processor
/// time; the shortest of several. Exit status 1 when one is worse than `max_times` the figure on
/// record (cost_ratios.toml), 77 where the build is not the one that is shipped.
///
///     cost_ratios            judges
///     cost_ratios --record   prints the table anew
namespace wold {
namespace {

constexpr double max_times = 1.5;
constexpr int rounds = 9;

double cpu_s(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// How many times as long `work` takes as `plain`, of the shortest of each: whatever else a machine
/// does makes both longer, and seldom alike. Each once before it counts.
double ratio(const std::function<void()>& work, const std::function<void()>& plain,
             int times = rounds) {
  work();
  plain();
  double work_s = cpu_s(work), plain_s = cpu_s(plain);
  for (int round = 1; round < times; ++round) {
    work_s = std::min(work_s, cpu_s(work));
    plain_s = std::min(plain_s, cpu_s(plain));
  }
  return work_s / plain_s;
}

/// Copies so many bytes from one place to another.
class Copy {
 public:
  explicit Copy(std::size_t bytes) : from_(bytes, 1), to_(bytes) {}
  void operator()() {
    std::memcpy(to_.data(), from_.data(), from_.size());
    sum_ = sum_ + static_cast<unsigned>(to_[to_.size() / 2]);
  }

 private:
  std::vector<char> from_, to_;
  volatile unsigned sum_ = 0;
};

/// Sorts so many random numbers.
class Sorting {
 public:
  explicit Sorting(std::size_t count) : numbers_(count) {}
  void operator()() {
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = mixed(i);
    std::sort(numbers_.begin(), numbers_.end());
  }

 private:
  std::vector<std::uint64_t> numbers_;
};

/// Finds frames of so many places on a curve: what a step of points is made of, reading and writing
/// as many vectors. (Sorting waits for wrong guesses of branches instead, which processors do
/// differently: the same step took 0.77 to 1.34 times as long as sorting.)
class Framing {
 public:
  explicit Framing(std::size_t count)
      : from_(count), to_(count), place_(count), tangent_(count), normal_(count) {
    for (std::size_t i = 0; i < count; ++i) from_[i] = {1.0F, unit(3 * i), unit(3 * i + 1)};
    for (std::size_t i = 0; i < count; ++i) to_[i] = {unit(3 * i + 2), 1.0F, unit(i)};
  }
  void operator()() {
    for (std::size_t i = 0; i < from_.size(); ++i) {
      place_[i] = glm::mix(from_[i], to_[i], 0.25F);
      tangent_[i] = glm::normalize(place_[i]);
    }
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const glm::vec3 across = glm::cross(tangent_[i], from_[i]);
      normal_[i] = across / glm::length(across);
    }
    sum_ = sum_ + normal_[normal_.size() / 2].x;
  }

 private:
  static float unit(std::size_t index) {
    return static_cast<float>(random_uniform({.index = index}));
  }

  std::vector<glm::vec3> from_, to_, place_, tangent_, normal_;
  volatile float sum_ = 0.0F;
};

/// The default patch of 400 blades.
struct Patch {
  Patch()
      : model(scene.ageing, scene.grass.specular),
        shape{254, 254, scene.grass.patch_m / 254},
        blades(grass::scatter_blades(scene.grass, scene.ageing,
                                     {scene.grass.patch_m, scene.grass.blades, scene.seed, 0})),
        dynamics(model, blades,
                 grass::sample_points(blades, shape, scene.grass.points_per_voxel_face, 1),
                 0.1 * shape.voxel_m) {
    dynamics.advance_to(0.0);
  }
  scene::Scene scene;
  grass::AgeingModel model;
  grass::TexelShape shape;
  std::vector<grass::Blade> blades;
  grass::PointDynamics dynamics;
};

std::size_t bytes_of(const grass::Texel& texel) {
  return texel.size() * (sizeof(std::uint32_t) + 2 * sizeof(float) + 3 * sizeof(glm::vec3));
}

double rasterise_per_copy() {
  const Patch patch;
  grass::Texel texel = grass::rasterise_points(patch.dynamics.points(), patch.shape);
  Copy copy(bytes_of(texel));
  return ratio([&] { texel = grass::rasterise_points(patch.dynamics.points(), patch.shape); },
               [&] { copy(); });
}

/// A step of all points, and finding as many frames.
double step_per_framing() {
  Patch patch;
  Framing framing(patch.dynamics.points().size());
  return ratio([&] { patch.dynamics.advance_to(0.5); }, [&] { framing(); }, 3 * rounds);
}

/// Where a hundred thousand flakes are and how they look, and finding as many frames. (Not writing
/// them: on one system the same flakes took 1.4 times as long as their file, on another 2.2 times.)
double snow_per_framing() {
  using namespace snow;
  constexpr std::size_t count = 1600 * lanes;
  scene::Scene scene;
  scene.snowfall.strength = scene::SnowfallStrength::moderate;
  const FlakePictures pictures(1);
  const FlakeMotion motion(scene, Weather(scene, nullptr), 1.2);
  const Frustum frustum(SnowView{.eye_m = {20.0, 20.0, 1.6}, .target_m = {20.0, 30.0, 2.0}});
  const FlakeLook look(pictures, frustum, scene.snowfall.shutter_s);
  const PeriodicCube cube = {frustum.eye_m() + 10.0 * frustum.ahead(), 13.0};
  std::vector<SeenFlake> flakes(count);
  double time_s = 0.0;
  const auto advance = [&] {
    time_s += 1234.5;
    const FlakeMotion::Moment moment = motion.moment(time_s, 1.2);
    const FlakeMotion::Air air = FlakeMotion::air({1, count}, cube, moment, frustum.eye_m());
    const Chosen all = Chosen::by([](std::size_t) { return true; });
    FlakeMotion::Drifting drifting;
    FlakeLanes flying;
    for (std::size_t first = 0; first < count; first += lanes) {
      motion.drift(air, first, drifting);
      motion.fly(drifting, moment, flying);
      look.see(flying, all, flakes.data() + first);
    }
  };
  Framing framing(count);
  return ratio(
      advance, [&] { framing(); }, 3 * rounds);
}

/// Four layers of clouds, and copying what is read and written for them (cloud_benchmark.cpp).
double clouds_per_copy() {
  constexpr int side = 2048, layers = 4;
  scene::Scene scene;
  for (const auto kind : {scene::CloudKind::cumulus, scene::CloudKind::stratocumulus,
                          scene::CloudKind::cirrus, scene::CloudKind::stratus}) {
    scene.clouds.emplace_back();
    scene.clouds.back().kind = kind;
    scene.clouds.back().cell_m = 4096.0;
  }
  const cloud::CloudState clouds = cloud::Clouds(scene, 8 * 4096.0 / side).at(12.34);
  Image picture(side, side, 4);
  Copy copy(std::size_t{side} * side * (4 * layers + 16) / 2);
  return ratio([&] { cloud::compose(clouds, {{}, side, side}, picture); }, [&] { copy(); });
}

/// Three key frames of one variant with all levels, from points to files, and sorting.
double texels_per_sorting() {
  const scene::Scene scene;
  const light::Daylight daylight(scene.sun, scene.sky);
  grass::LodTurns lods;
  for (int lod = 0; lod < static_cast<int>(scene.grass.lods.size()); ++lod) lods[lod] = {0};
  SilentProgress progress;
  const auto make = [&] {
    const test::TemporaryFolder folder("cost_ratios");
    const grass::TimeVaryingTexel texel(
        scene, {grass::make_lighting(daylight, {0.0, -1.0, 0.0}, glm::vec3(0.1F))}, folder.path());
    texel.generate({{0, {{0, lods}, {6, lods}, {12, lods}}}}, progress);
  };
  Sorting sorting(4'000'000);
  return ratio(
      make, [&] { sorting(); }, 3);
}

struct Cost {
  const char* name;
  double (*measure)();
};

constexpr Cost costs[] = {{"rasterise_per_copy", rasterise_per_copy},
                          {"step_per_framing", step_per_framing},
                          {"snow_per_framing", snow_per_framing},
                          {"clouds_per_copy", clouds_per_copy},
                          {"texels_per_sorting", texels_per_sorting}};

/// A second look at what is too slow: a busy moment is none twice in a row.
double measured(const Cost& cost, double max) {
  const double first = cost.measure();
  return first <= max ? first : std::min(first, cost.measure());
}

bool judge(const toml::table& on_record) {
  bool good = true;
  fmt::print("{:20} {:>8} {:>10} {:>6}\n", "cost", "now", "on record", "times");
  for (const Cost& cost : costs) {
    const double record = on_record[cost.name].value<double>().value();
    const double now = measured(cost, max_times * record);
    const bool within = now <= max_times * record;
    fmt::print("{:20} {:8.2f} {:10.2f} {:6.2f} {}\n", cost.name, now, record, now / record,
               within ? "" : " TOO SLOW");
    good = good && within;
  }
  return good;
}

void print_table() {
  for (const Cost& cost : costs) fmt::print("{} = {:.2f}\n", cost.name, cost.measure());
}

bool is_the_shipped_build() {
#ifdef __OPTIMIZE__
  return !test::sanitized;
#else
  return false;
#endif
}

}  // namespace
}  // namespace wold

int main(int count, char** arguments) {
  constexpr int skipped = 77;
  if (!wold::is_the_shipped_build()) return skipped;
  const wold::ThreadLimit one_thread(1);
  if (count > 1 && std::string_view(arguments[1]) == "--record") {
    wold::print_table();
    return 0;
  }
  const auto on_record = wold::test::tests_folder() / "benchmark/cost_ratios.toml";
  return wold::judge(toml::parse_file(on_record.string())) ? 0 : 1;
}
