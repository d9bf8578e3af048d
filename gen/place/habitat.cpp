#include "place/habitat.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "core/elementary.h"
#include "core/image.h"
#include "core/interpolation.h"
#include "core/random.h"
#include "place/cell_window.h"
#include "scene/species.h"
#include "terrain/relief.h"

namespace wold::place {

/// The user's picture over the terrain's square, row 0 in the north.
class GrowthLimits::Mask {
 public:
  Mask(const std::string& path, double size_m) : picture_(read_image(path)), size_m_(size_m) {}

  /// Mean of the colour channels at a place, in [0, 1]; what is no number counts as black.
  double at(const glm::dvec2& at_m) const {
    const double x = at_m.x / size_m_ * picture_.width - 0.5;
    const double y = (1.0 - at_m.y / size_m_) * picture_.height - 0.5;
    const double left = std::floor(x);
    const double top = std::floor(y);
    const auto value = [&](int right, int below) {
      return level(static_cast<int>(left) + right, static_cast<int>(top) + below);
    };
    const double mean =
        bilinear(value(0, 0), value(1, 0), value(0, 1), value(1, 1), x - left, y - top);
    return std::clamp(mean, 0.0, 1.0);
  }

 private:
  double level(int x, int y) const {
    const float* pixel =
        picture_.pixel(std::clamp(x, 0, picture_.width - 1), std::clamp(y, 0, picture_.height - 1));
    const int colours = picture_.channels < 3 ? 1 : 3;
    double sum = 0.0;
    for (int c = 0; c < colours; ++c) sum += double{pixel[c]} / colours;
    return std::isfinite(sum) ? sum : 0.0;
  }

  Image picture_;
  double size_m_;
};

namespace {

/// From 1 to 0 while `value` rises by `width` about `limit`.
double below(double value, double limit, double width) {
  return 1.0 - glm::smoothstep(limit - width / 2.0, limit + width / 2.0, value);
}

/// From 0 to 1 while `value` rises by `width` about `limit`.
double above(double value, double limit, double width) { return below(-value, -limit, width); }

constexpr double slope_strip_deg = 8.0;

/// The value's rank in a standard normal distribution: makes noise uniform in (0, 1).
double equalised(double value) { return 0.5 * math::erfc(-value / std::numbers::sqrt2); }

bool asks_for_topography(const scene::Habitat& habitat) {
  return habitat.driest > 0.0 || habitat.wettest < 1.0 || habitat.shadiest > 0.0 ||
         habitat.sunniest < 2.0;
}

}  // namespace

GrowthLimits::GrowthLimits(const scene::Scene& scene, const scene::Growth& growth)
    : growth_(growth), slope_strip_deg_(slope_strip_deg), height_strip_m_(growth.feature_m) {
  const double terrain_m = scene.terrain.size_m;
  if (is_large(scene)) {
    constexpr double large_strip_deg = 24.0, large_strip = 0.015;
    slope_strip_deg_ = large_strip_deg;
    height_strip_m_ = std::max(height_strip_m_, large_strip * terrain_m);
  }
  if (!growth.mask.empty()) mask_ = std::make_shared<const Mask>(growth.mask, terrain_m);
}

double GrowthLimits::on_level(const glm::dvec2& at_m, double height_m) const {
  double p = growth_.cover;
  p *= below(height_m, growth_.highest_m, height_strip_m_);
  p *= above(height_m, growth_.lowest_m, height_strip_m_);
  return mask_ ? p * mask_->at(at_m) : p;
}

double GrowthLimits::on_slope(double slope_deg) const {
  return below(slope_deg, growth_.steepest_deg, slope_strip_deg_);
}

namespace {

constexpr int max_octaves_of_groups = 6;
constexpr double smallest_group = 4.0;  // over the size of tufts
constexpr double by_group = 0.6;        // variance, a modelling choice

/// So many that the smallest tufts are a few cells wide: patches with smooth borders look painted,
/// like camouflage.
int octaves_of_tufts(double feature_m, double cell_m) {
  constexpr double smallest_cells = 1.5;
  constexpr int min = 2, max = 8;
  int octaves = min;
  while (octaves < max && std::ldexp(feature_m, -octaves) >= smallest_cells * cell_m) ++octaves;
  return octaves;
}

}  // namespace

double Tufts::at(const glm::dvec2& at_m) const {
  const double tuft = field_.at(at_m / feature_m_);
  if (!groups_) return equalised(tuft);
  const double group = groups_->at(at_m / largest_group_m_);
  return equalised(std::sqrt(1.0 - by_group) * tuft + std::sqrt(by_group) * group);
}

Tufts Tufts::in_groups(std::uint64_t key, double largest_m) && {
  int octaves = 0;
  for (double group_m = smallest_group * feature_m_;
       group_m <= largest_m && octaves < max_octaves_of_groups; group_m *= 2.0) {
    largest_group_m_ = group_m;
    ++octaves;
  }
  if (octaves > 0) groups_.emplace(key, octaves, /*hurst=*/0.1);
  return std::move(*this);
}

Habitats::Habitats(const scene::Scene& scene, const Heightfield& terrain)
    : terrain_(terrain), some_everywhere_(false) {
  const std::vector<scene::Species> meadow = scene::species_of(scene);
  for (std::size_t i = 0; i < meadow.size(); ++i) {
    const scene::Habitat& habitat = meadow[i].habitat;
    if (!scene::has_habitat(meadow[i])) {
      some_everywhere_ = true;
      continue;
    }
    const auto key = [&](std::string_view what) {
      return random_bits({scene.seed, key_of("species"), i, key_of(what)});
    };
    Tufts tufts(Fbm(key("tufts"), octaves_of_tufts(habitat.feature_m, scene.grass.patch_m),
                    /*hurst=*/0.6),
                habitat.feature_m);
    // So large that a terrain has many: all over it species stand on the share that their cover
    // says.
    constexpr double largest_group = 0.03;
    if (is_large(scene))
      tufts = std::move(tufts).in_groups(key("groups"), largest_group * scene.terrain.size_m);
    species_.push_back({habitat, GrowthLimits(scene, habitat), std::move(tufts)});
    if (asks_for_topography(habitat) && !topography_)
      topography_ = std::make_shared<const Topography>(terrain, scene.sun.latitude_deg);
  }
}

double Habitats::probability(int species, const glm::dvec2& at_m) const {
  constexpr double wetness_strip = 0.1, sun_strip = 0.1;
  const Placed& placed = species_.at(static_cast<std::size_t>(species));
  const scene::Habitat& habitat = placed.habitat;
  double p = placed.limits.on_level(at_m, double{terrain_.sample(at_m.x, at_m.y)});
  if (placed.limits.ask_for_slope() || habitat.gentlest_deg > 0.0) {
    const double slope_deg = terrain::slope_deg(terrain_, at_m.x, at_m.y);
    if (placed.limits.ask_for_slope()) p *= placed.limits.on_slope(slope_deg);
    if (habitat.gentlest_deg > 0.0) p *= above(slope_deg, habitat.gentlest_deg, slope_strip_deg);
  }
  if (!asks_for_topography(habitat)) return p;
  const double wetness = topography_->wetness(at_m);
  const double sun = topography_->sun(at_m);
  if (habitat.driest > 0.0) p *= above(wetness, habitat.driest, wetness_strip);
  if (habitat.wettest < 1.0) p *= below(wetness, habitat.wettest, wetness_strip);
  if (habitat.shadiest > 0.0) p *= above(sun, habitat.shadiest, sun_strip);
  if (habitat.sunniest < 2.0) p *= below(sun, habitat.sunniest, sun_strip);
  return p;
}

double Habitats::excess(int species, const glm::dvec2& at_m) const {
  return probability(species, at_m) - species_.at(static_cast<std::size_t>(species)).tufts.at(at_m);
}

double Habitats::any(const glm::dvec2& at_m) const {
  double sum = some_everywhere_ ? 1.0 : 0.0;
  for (int species = 0; species < count() && sum < 1.0; ++species)
    sum += probability(species, at_m);
  return std::min(sum, 1.0);
}

}  // namespace wold::place
