#include "meadow/far_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "place/each_in_view.h"
#include "scene/key_frames.h"
#include "scene/species.h"
#include "terrain/relief.h"

namespace wold::meadow {
namespace {

/// What hardly differs from a whole level is that, so that its looks are all that is needed.
double nearly_whole(double level) {
  constexpr double unseen = 1e-4;
  return level - std::floor(level) < unseen ? std::floor(level) : level;
}

double snow_level(const FrameGrass& now) {
  return nearly_whole(grass::PatchState::level_of(now.snow));
}

double light_level(const FrameGrass& now) { return nearly_whole(now.light); }

/// More grass along a ray, where the same number of blades stands on each square metre of a slope.
double slope_factor(const glm::dvec2& gradient) {
  return std::sqrt(1.0 + glm::dot(gradient, gradient));
}

/// A line of sight as a cell sees it that is sheared to the slope and leans; the flattest still
/// goes down.
glm::dvec3 in_cell(const glm::dvec3& sight, const glm::dvec2& gradient, const glm::dvec2& lean) {
  const double down = std::min(sight.z - glm::dot(gradient, glm::dvec2(sight)), -0.03);
  return {glm::dvec2(sight) - lean * down, down};
}

}  // namespace

Meadow::Meadow(const scene::Scene& scene, const Heightfield& terrain,
               const place::MixtureField& mixtures, const place::Withering& withering,
               const place::View& view, FrameGrass now, PatchAppearances looks)
    : terrain_(terrain),
      mixtures_(mixtures),
      withering_(withering),
      view_(view),
      now_(std::move(now)),
      key_frames_(scene::key_frames(scene)),
      snow_(snow_level(now_)),
      light_(light_level(now_)),
      looks_(std::move(looks)) {}

landscape::AggregateAppearance Meadow::look(const glm::dvec3& at_m) const {
  return look(at_m, view_.line_of_sight(at_m));
}

landscape::AggregateAppearance Meadow::look(const glm::dvec3& at_m, const glm::dvec3& sight) const {
  const glm::dvec2 gradient = terrain::gradient(terrain_, at_m.x, at_m.y);
  const glm::dvec3 direction = in_cell(sight, gradient, now_.wind_lean.lean(glm::dvec2(at_m)));
  const double weathering = withering_.at(glm::dvec2(at_m), now_.frame);
  const auto above = std::upper_bound(key_frames_.begin() + 1, key_frames_.end() - 1, weathering);
  const auto key = static_cast<int>(above - key_frames_.begin());
  const double fraction = (weathering - *(above - 1)) / (*above - *(above - 1));
  const int mixture = mixtures_.at(glm::dvec2(at_m));
  return thickened(mixed(at_key_frame(mixture, key - 1, direction),
                         at_key_frame(mixture, key, direction), fraction),
                   slope_factor(gradient));
}

landscape::AggregateAppearance Meadow::at_key_frame(int mixture, int key_frame,
                                                    const glm::dvec3& direction) const {
  const auto below = static_cast<int>(snow_);
  const landscape::AggregateAppearance look = at_snow(mixture, key_frame, below, direction);
  if (snow_ == below) return look;
  return mixed(look, at_snow(mixture, key_frame, below + 1, direction), snow_ - below);
}

landscape::AggregateAppearance Meadow::at_snow(int mixture, int key_frame, int snow,
                                               const glm::dvec3& direction) const {
  const auto lit = [&](int light) {
    return looks_.at({mixture, {key_frame, snow, light}}).along(direction);
  };
  const auto before = static_cast<int>(light_);
  if (light_ == before) return lit(before);
  return mixed(lit(before), lit(before + 1), light_ - before);
}

double far_fraction(const scene::Grass& grass, const place::View& view, const glm::dvec3& at_m) {
  const double relative =
      view.pixels(grass.height_m, at_m) / std::max(grass.far_field_below_pixels, 1e-9);
  return 1.0 - glm::smoothstep(place::min_standing, 1.25, relative);
}

double far_fraction(const scene::Grass& grass, const place::CellWindow& window,
                    const place::View& view, const glm::dvec3& at_m) {
  return std::max(far_fraction(grass, view, at_m), window.outside_fraction(glm::dvec2(at_m)));
}

bool has_far_field(const scene::Scene& scene, const Heightfield& terrain, const place::View& view) {
  constexpr int places = 64;
  const place::CellWindow window(scene);
  const scene::Grass grass = scene::mean_grass(scene);
  for (int j = 0; j <= places; ++j)
    for (int i = 0; i <= places; ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * (terrain.size_m() / places);
      const glm::dvec3 place_m = place::above_ground(terrain, at_m, 0.0);
      if (view.may_see(place_m, terrain.size_m() / places) &&
          far_fraction(grass, window, view, place_m) > 0.0)
        return true;
    }
  return false;
}

std::vector<grass::PatchState> far_states(const scene::Scene& scene,
                                          const place::Withering& withering,
                                          const FrameGrass& now) {
  const std::vector<double> keys = scene::key_frames(scene);
  const auto [min, max] = withering.range(now.frame);
  const auto first = std::upper_bound(keys.begin() + 1, keys.end() - 1, min) - 1;
  const auto last = std::upper_bound(keys.begin() + 1, keys.end() - 1, max);
  const double snow = snow_level(now);
  const double lit = light_level(now);
  std::vector<grass::PatchState> states;
  for (auto key = first; key <= last; ++key)
    for (auto level = static_cast<int>(snow); level < snow + 1.0; ++level)
      for (auto light = static_cast<int>(lit); light < lit + 1.0; ++light)
        states.emplace_back(static_cast<int>(key - keys.begin()), level, light);
  return states;
}

void paint_far_grass(ColourMap& ground, const scene::Scene& scene, const Heightfield& terrain,
                     const FactorMap& growth, const ColourMap& light, const place::View& view,
                     const Meadow& meadow) {
  const place::CellWindow window(scene);
  const scene::Grass meadow_grass = scene::mean_grass(scene);
  place::each_in_view(ground, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const double fraction = far_fraction(meadow_grass, window, view, at_m);
    const double grown = growth.sample(at_m.x, at_m.y);
    if (fraction <= 0.0 || (fraction >= 1.0 && grown <= 0.0)) return;
    const landscape::AggregateAppearance look = thickened(meadow.look(at_m), grown);
    const glm::vec3 grass = glm::vec3(look.radiance) * light.sample(at_m.x, at_m.y);
    const glm::vec3 seen = grass + static_cast<float>(look.transmittance) * ground.at(i, j);
    ground.at(i, j) = glm::mix(ground.at(i, j), seen, static_cast<float>(fraction));
  });
}

double painted_opacity(const scene::Grass& mean_grass, const place::CellWindow& window,
                       const place::View& view, const Meadow& meadow, const glm::dvec3& at_m,
                       double grown) {
  const double fraction = far_fraction(mean_grass, window, view, at_m);
  if (fraction <= 0.0 || grown <= 0.0) return 0.0;
  return fraction * (1.0 - thickened(meadow.look(at_m), grown).transmittance);
}

FactorMap grass_extinction_factor(const scene::Scene& scene, const Heightfield& terrain,
                                  const FactorMap& growth, const place::View& view) {
  const place::CellWindow window(scene);
  const scene::Grass grass = scene::mean_grass(scene);
  FactorMap factor(growth.samples(), growth.square());
  place::each_in_view(factor, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const glm::dvec2 gradient = terrain::gradient(terrain, at_m.x, at_m.y);
    const double unpainted = 1.0 - far_fraction(grass, window, view, at_m);
    factor.at(i, j) = growth.at(i, j) * static_cast<float>(unpainted * slope_factor(gradient));
  });
  return factor;
}

}  // namespace wold::meadow
