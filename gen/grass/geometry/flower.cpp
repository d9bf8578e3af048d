#include "grass/geometry/flower.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/random.h"
#include "grass/geometry/axis.h"

namespace wold::grass {
namespace {

// Modelling choices.
constexpr int stalks_of_a_stock = 3;
constexpr double stock_m = 0.05;        ///< standard deviation of stalks from their stock
constexpr double size_spread = 0.14;    ///< of flowers, standard deviation over the mean
constexpr double opening_spread = 9.0;  ///< degrees, from petal to petal
constexpr double turn_spread = 0.2;     ///< of petals, in distances from one to the next
constexpr double brightness_spread = 0.06;
constexpr double disc_height = 0.5;  ///< over its width

/// The random numbers of one flower.
class FlowerRandom {
 public:
  FlowerRandom(const Scattering& of, int stalk) : of_(of), stalk_(stalk) {}
  double uniform(std::string_view purpose, int petal = 0) const {
    return random_uniform(key(purpose, stalk_, petal));
  }
  /// Normal, cut at two standard deviations.
  double normal(std::string_view purpose, int petal = 0) const {
    return std::clamp(random_normal(key(purpose, stalk_, petal)), -2.0, 2.0);
  }
  /// Of the root stock that the stalk has in common with others.
  double of_stock(std::string_view purpose) const {
    return random_uniform(key(purpose, stalk_ / stalks_of_a_stock, 0));
  }

 private:
  RandomKey key(std::string_view purpose, int item, int petal) const {
    return {of_.seed, key_of("flower"),
            (static_cast<std::uint64_t>(of_.sample) << 48) |
                (static_cast<std::uint64_t>(of_.variant) << 32) | static_cast<std::uint64_t>(item),
            key_of(purpose) + static_cast<std::uint64_t>(petal)};
  }
  const Scattering& of_;
  int stalk_;
};

/// A place of the patch that repeats.
float wrapped_m(double at_m, double patch_m) {
  return static_cast<float>(at_m - patch_m * std::floor(at_m / patch_m));
}

void make_stalk(const FlowerRandom& random, double patch_m, Blade& blade) {
  blade.organ = Organ::stalk;
  blade.fresh_droop = blade.droop_rate = blade.head_start = 0.0F;
  // On a twig of a shrub it stays where that ends.
  if (blade.root_height_m > 0.0F) return;
  blade.root_m = {
      wrapped_m(random.of_stock("x") * patch_m + stock_m * random.normal("beside x"), patch_m),
      wrapped_m(random.of_stock("y") * patch_m + stock_m * random.normal("beside y"), patch_m)};
}

/// Three perpendicular unit vectors: `up` points along the stalk.
struct Frame {
  explicit Frame(const Blade& stalk)
      : up(from_plane(stalk, {math::sin(stalk.lean), math::cos(stalk.lean)})),
        across(-stalk.heading.y, stalk.heading.x, 0.0F),
        side(glm::cross(across, up)) {}
  glm::vec3 up, across, side;
};

/// Turns a blade along a direction, unit, and puts it there.
void put(const glm::vec3& root_m, const glm::vec3& along, Blade& blade) {
  const float level = glm::length(glm::vec2(along));
  blade.root_m = glm::vec2(root_m);
  blade.root_height_m = root_m.z;
  if (level > 0.0F) blade.heading = glm::vec2(along) / level;
  blade.lean = math::atan2(level, along.z);
}

/// From its outer end to the tip of the stalk.
Blade petal(const Blade& stalk, const scene::Flower& flower, const FlowerRandom& random,
            int number) {
  const Frame frame(stalk);
  const double size = 1.0 + size_spread * random.normal("size");
  const double step = 2.0 * std::numbers::pi / flower.petals;
  const auto turn = static_cast<float>(
      step * (random.uniform("turn") + number + turn_spread * random.normal("aside", number)));
  const auto opening = static_cast<float>(radians(std::clamp(
      flower.opening_deg + opening_spread * random.normal("opening", number), 0.0, 90.0)));
  const glm::vec3 outwards =
      math::cos(opening) * frame.up +
      math::sin(opening) * (math::cos(turn) * frame.across + math::sin(turn) * frame.side);
  Blade blade = stalk;
  blade.organ = Organ::petal;
  blade.length_m = static_cast<float>(size * flower.length_m);
  blade.radius_m = static_cast<float>(size * flower.width_m / 2.0);
  blade.brightness =
      static_cast<float>(1.0 + brightness_spread * random.normal("brightness", number));
  const glm::vec3 tip_m = foot_m(stalk) + stalk.length_m * frame.up;
  put(tip_m + blade.length_m * outwards, -outwards, blade);
  return blade;
}

/// A cone that stands on the tip of the stalk.
Blade disc(const Blade& stalk, const scene::Flower& flower, const FlowerRandom& random) {
  const Frame frame(stalk);
  const double size = 1.0 + size_spread * random.normal("size");
  Blade blade = stalk;
  blade.organ = Organ::disc;
  blade.length_m = static_cast<float>(size * disc_height * flower.disc_m);
  blade.radius_m = static_cast<float>(size * flower.disc_m / 2.0);
  blade.brightness = 1.0F;
  put(foot_m(stalk) + stalk.length_m * frame.up, frame.up, blade);
  return blade;
}

}  // namespace

std::vector<Blade> with_flowers(std::vector<Blade> stalks, const scene::Flower& flower,
                                const Scattering& scattering) {
  std::vector<Blade> blades;
  for (std::size_t number = 0; number < stalks.size(); ++number) {
    const FlowerRandom random(scattering, static_cast<int>(number));
    Blade& stalk = stalks[number];
    make_stalk(random, scattering.patch_m, stalk);
    blades.push_back(stalk);
    for (int k = 0; k < flower.petals; ++k) blades.push_back(petal(stalk, flower, random, k));
    if (flower.disc_m > 0.0) blades.push_back(disc(stalk, flower, random));
  }
  return blades;
}

}  // namespace wold::grass
