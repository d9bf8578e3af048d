#include "grass/geometry/blade.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/random.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/clumps.h"
#include "grass/geometry/crown.h"
#include "scene/species.h"

namespace wold::grass {
namespace {

/// The random numbers of one blade.
class BladeRandom {
 public:
  BladeRandom(std::uint64_t seed, int variant, int sample, int blade)
      : key_{seed, key_of("blade"),
             (static_cast<std::uint64_t>(sample) << 48) |
                 (static_cast<std::uint64_t>(variant) << 32) | static_cast<std::uint64_t>(blade),
             0} {}
  double uniform(std::string_view purpose) const { return random_uniform(with(purpose)); }
  /// Normal, cut at 2.2 standard deviations so that no blade is absurd.
  double normal(std::string_view purpose) const {
    return std::clamp(random_normal(with(purpose)), -2.2, 2.2);
  }

 private:
  RandomKey with(std::string_view purpose) const {
    RandomKey key = key_;
    key.purpose = key_of(purpose);
    return key;
  }
  RandomKey key_;
};

/// Root of blade `number` in its cell of a columns x columns grid; the grid has room for all
/// blades, the cells left empty are chosen by stepping through it evenly.
glm::vec2 stratified_root(const BladeRandom& random, int number, int blades, double patch_m) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(blades))));
  const long cells = static_cast<long>(columns) * columns;
  const long cell = number * cells / blades;
  const long row = cell / columns, column = cell % columns;
  const double side_m = patch_m / columns;
  return {(static_cast<double>(column) + random.uniform("root x")) * side_m,
          (static_cast<double>(row) + random.uniform("root y")) * side_m};
}

float positive_spread(double mean, double relative, double normal) {
  return static_cast<float>(mean * std::max(0.3, 1.0 + relative * normal));
}

/// Age of a single blade in a fresh meadow: most are young (exponential), a few are last year's.
double head_start(const scene::Physiology& physiology, const BladeRandom& random) {
  if (random.uniform("litter") < physiology.litter) return 0.8 + 0.2 * random.uniform("litter age");
  return std::min(-physiology.fresh_spread * math::log(1.0 - random.uniform("age")), 0.5);
}

/// Blades are alike in shape, a longer one has the deeper keel; `load` is how much more it bends
/// than they do, as the inverse square of the depth (fresh_load).
float keel_depth_m(const scene::Plant& plant, const Blade& blade, float load) {
  return static_cast<float>(plant.keel_depth_m / plant.height_m) * blade.length_m / std::sqrt(load);
}

Blade make_blade(const scene::Plant& plant, const scene::Physiology& physiology,
                 const BladeRandom& random, const glm::vec2& root_m, std::uint64_t tufts) {
  const double heading = 2.0 * std::numbers::pi * random.uniform("heading");
  const double lean_deg = plant.lean_deg + plant.lean_spread_deg * random.normal("lean");
  Blade blade;
  blade.root_m = root_m;
  blade.heading = {math::cos(heading), math::sin(heading)};
  blade.lean = static_cast<float>(radians(std::clamp(lean_deg, 0.0, 80.0)));
  blade.length_m = positive_spread(plant.height_m, plant.height_spread, random.normal("length"));
  blade.radius_m = positive_spread(plant.width_m / 2, plant.width_spread, random.normal("width"));
  blade.keel_depth_m = keel_depth_m(
      plant, blade, positive_spread(1.0, physiology.droop_spread, random.normal("bend")));
  blade.fresh_droop = positive_spread(plant.bend, physiology.droop_spread, random.normal("bend"));
  blade.droop_rate =
      positive_spread(physiology.droop, physiology.droop_spread, random.normal("droop"));
  blade.head_start = static_cast<float>(head_start(physiology, random));
  blade.onset = static_cast<float>(physiology.onset_spread * random.normal("onset"));
  blade.brightness = positive_spread(1.0, 0.12, random.normal("brightness"));
  blade.lump_m = static_cast<float>(0.03 + 0.04 * random.uniform("lump"));
  blade.lump_phase = static_cast<float>(random.uniform("lump phase"));
  blade.tufts = tufts;
  return blade;
}

/// How many leaves a shoot of a shrub has, and how far down from its end, in lengths of a mean leaf
/// (modelling choices): leaves that stand evenly make a ball of fuzz.
constexpr int leaves_of_shoot = 12;
constexpr double leafy_lengths = 2.5;

/// Moves a blade that grows from the ground to a shoot that ends where `of_shoot` says: there it
/// grows half-way between the shoot's direction and the one that it had.
void put_on_shoot(const Crown& crown, const BladeRandom& of_shoot, double leafy_m, double along,
                  Blade& blade) {
  const Crown::Twig twig =
      crown.twig({of_shoot.uniform("cushion"), of_shoot.uniform("twig height"),
                  of_shoot.uniform("twig heading"), of_shoot.uniform("twig depth")});
  const auto back_m = static_cast<float>(along * std::min(leafy_m, double{twig.inwards_m}));
  blade.root_m = twig.place_m - back_m * glm::vec2(twig.outwards);
  blade.root_height_m = twig.height_m - back_m * twig.outwards.z;
  const glm::vec3 grown = from_plane(blade, {math::sin(blade.lean), math::cos(blade.lean)});
  const glm::vec3 along_blade = glm::normalize(twig.outwards + grown);
  const float level = glm::length(glm::vec2(along_blade));
  if (level > 0.0F) blade.heading = glm::vec2(along_blade) / level;
  blade.lean = math::atan2(level, along_blade.z);
}

}  // namespace

std::vector<Blade> scatter_blades(const scene::Plant& plant, const scene::Physiology& physiology,
                                  const Scattering& scattering) {
  const auto& [patch_m, count, seed, variant, sample] = scattering;
  const auto tufts =
      random_bits({seed, key_of("tufts"), static_cast<std::uint64_t>(variant), key_of("snow")});
  std::optional<Crown> crown;
  if (plant.crown_m > 0.0) crown = crown_of(plant, patch_m, seed, variant);
  std::vector<Blade> blades;
  blades.reserve(static_cast<std::size_t>(count));
  for (int number = 0; number < count; ++number) {
    const BladeRandom random(seed, variant, sample, number);
    blades.push_back(make_blade(plant, physiology, random,
                                stratified_root(random, number, count, patch_m), tufts));
    if (crown)
      put_on_shoot(*crown, BladeRandom(seed, variant, sample, number / leaves_of_shoot),
                   leafy_lengths * plant.height_m, random.uniform("along shoot"), blades.back());
  }
  if (scene::is_hair(physiology)) clump(blades, physiology, patch_m, seed, variant);
  return blades;
}

Blade mean_blade(const scene::Plant& plant, const scene::Physiology& physiology) {
  Blade blade;
  blade.root_m = {0.0F, 0.0F};
  blade.heading = {1.0F, 0.0F};
  blade.lean = static_cast<float>(radians(plant.lean_deg));
  blade.length_m = static_cast<float>(plant.height_m);
  blade.radius_m = static_cast<float>(plant.width_m / 2.0);
  blade.keel_depth_m = keel_depth_m(plant, blade, 1.0F);
  blade.fresh_droop = static_cast<float>(plant.bend);
  blade.droop_rate = static_cast<float>(physiology.droop);
  return blade;
}

}  // namespace wold::grass
