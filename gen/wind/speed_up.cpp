#include "wind/speed_up.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "wind/fourier.h"

namespace wold::wind {
namespace {

constexpr int places = 128;
constexpr int mirrored = 2 * places;
constexpr double most_gained = 1.0, most_lost = 0.9;
constexpr double fading = 3.0;

/// The middles of so many squares a side.
glm::dvec2 place_m(const Heightfield& terrain, int i, int j) {
  return terrain.corner_m() + (glm::dvec2(i, j) + 0.5) * (terrain.size_m() / places);
}

/// Heights over the terrain's square and its mirror images.
ComplexSquare mirrored_heights(const Heightfield& terrain) {
  ComplexSquare square{mirrored, std::vector<std::complex<double>>(mirrored * mirrored)};
  const auto inside = [](int i) { return i < places ? i : mirrored - 1 - i; };
  for (int j = 0; j < mirrored; ++j)
    for (int i = 0; i < mirrored; ++i) {
      const glm::dvec2 at_m = place_m(terrain, inside(i), inside(j));
      square.values[static_cast<std::size_t>(j * mirrored + i)] =
          double{terrain.sample(at_m.x, at_m.y)};
    }
  return square;
}

/// Radians per metre of the k-th value of a transform along an axis.
double wave_number(int k, double mirrored_m) {
  const int turns = k < places ? k : k - mirrored;
  return 2.0 * std::numbers::pi * turns / mirrored_m;
}

/// (ln(L / z0) / ln(l / z0))^2 of waves that are long beside the roughness; the shorter ones fade.
double inner_gain(double radians_per_m, double roughness_m) {
  constexpr double shortest = 10.0;
  const double cut = shortest * roughness_m * radians_per_m;
  const double hill_m = std::max(quarter_wave_m(radians_per_m), shortest * roughness_m);
  const double ratio =
      math::log(hill_m / roughness_m) / math::log(inner_layer_m(hill_m, roughness_m) / roughness_m);
  return ratio * ratio * math::exp(-cut * cut);
}

/// Every wave of the ground but its mean: visit(which, wave vector in radians per metre).
template <class Visit>
void each_wave(double mirrored_m, const Visit& visit) {
  for (int j = 0; j < mirrored; ++j)
    for (int i = 0; i < mirrored; ++i)
      visit(static_cast<std::size_t>(j * mirrored + i),
            glm::dvec2(wave_number(i, mirrored_m), wave_number(j, mirrored_m)));
}

/// The first quadrant of the waves' sum.
FactorMap map_of(ComplexSquare waves, const Heightfield& terrain) {
  transform_back(waves);
  const double step_m = terrain.size_m() / places;
  FactorMap map(places, {terrain.corner_m() + 0.5 * step_m, terrain.size_m() - step_m});
  for (int j = 0; j < places; ++j)
    for (int i = 0; i < places; ++i)
      map.at(i, j) =
          static_cast<float>(waves.values[static_cast<std::size_t>(j * mirrored + i)].real());
  return map;
}

double limited(double change) {
  const double most = change > 0.0 ? most_gained : most_lost;
  return most * math::tanh(change / most);
}

}  // namespace

double quarter_wave_m(double radians_per_m) { return std::numbers::pi / (2.0 * radians_per_m); }

double inner_layer_m(double hill_m, double roughness_m) {
  // By Newton's method for x = ln(l / z0): x e^x = right; it starts above the root.
  const double right = 2.0 * von_karman * von_karman * hill_m / roughness_m;
  double x = std::max(math::log(right), 1.0);
  for (int step = 0; step < 8; ++step) x -= (x - right * math::exp(-x)) / (1.0 + x);
  return roughness_m * math::exp(x);
}

SpeedUp::SpeedUp(const Heightfield& terrain, const Profile& profile) {
  ComplexSquare ground = mirrored_heights(terrain);
  transform(ground);
  ComplexSquare east{mirrored, std::vector<std::complex<double>>(ground.values.size())};
  ComplexSquare north = east, mixed = east;
  double changes = 0.0, numbers = 0.0;
  each_wave(2.0 * terrain.size_m(), [&](std::size_t which, const glm::dvec2& k) {
    const double number = glm::length(k);
    if (number == 0.0) return;
    const std::complex<double> gained =
        ground.values[which] * (inner_gain(number, profile.roughness_m()) / number);
    east.values[which] = gained * (k.x * k.x);
    north.values[which] = gained * (k.y * k.y);
    mixed.values[which] = gained * (k.x * k.y);
    const double change = std::norm(gained) * number * number * number * number;
    changes += change;
    numbers += change * number;
  });
  if (changes > 0.0) hill_m_ = quarter_wave_m(numbers / changes);
  east_ = map_of(std::move(east), terrain);
  north_ = map_of(std::move(north), terrain);
  mixed_ = map_of(std::move(mixed), terrain);
}

glm::dvec2 SpeedUp::change(const glm::dvec2& at_m, const glm::dvec2& along) const {
  const double east = east_.sample(at_m.x, at_m.y), north = north_.sample(at_m.x, at_m.y),
               mixed = mixed_.sample(at_m.x, at_m.y);
  return {east * along.x + mixed * along.y, mixed * along.x + north * along.y};
}

glm::dvec2 SpeedUp::mean(const glm::dvec2& at_m, const glm::dvec2& along) const {
  return mean(at_m, along, 0.0);
}

glm::dvec2 SpeedUp::mean(const glm::dvec2& at_m, const glm::dvec2& along, double height_m) const {
  const glm::dvec2 changed = change(at_m, along) * math::exp(-fading * height_m / hill_m_);
  const glm::dvec2 right(along.y, -along.x);
  return (1.0 + limited(glm::dot(changed, along))) * along +
         limited(glm::dot(changed, right)) * right;
}

}  // namespace wold::wind
