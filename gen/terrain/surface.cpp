#include "terrain/surface.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "terrain/relief.h"

namespace wold::terrain {
namespace {

/// How much more of the sun's light falls on a face than on the ground it belongs to: 1 where it
/// faces the same way. Grazing light makes no face much brighter than one that the sun meets.
double more_sun(const glm::dvec3& face, const glm::dvec3& ground, const glm::dvec3& to_sun) {
  constexpr double least = 0.15;
  const double on_ground = glm::dot(ground, to_sun);
  const double more = glm::dot(face, to_sun) - on_ground;
  return std::max(0.0, 1.0 + more / std::max(least, on_ground));
}

/// The same of the sky's, which is as bright everywhere.
double more_sky(const glm::dvec3& face, const glm::dvec3& ground) {
  return (1.0 + face.z) / (1.0 + ground.z);
}

}  // namespace

Surface::Surface(const Heightfield& heights_m, const FinerRelief* finer, const GroundGrid& grid,
                 const KnownGround& known, RowParts parts, const SnowSurface& snow)
    : heights_m_(heights_m),
      finer_(grid.step_m() < heights_m.step_m() ? finer : nullptr),
      grid_(grid),
      known_(known),
      parts_(parts.empty() ? whole_rows(grid.samples) : std::move(parts)),
      snow_(snow) {
  if (known.scree != nullptr) scree_.emplace(*known.scree, grid.step_m());
  if (finer_ != nullptr) add_relief();
  if (known.grazing_steps != nullptr) add_grazing_steps();
  if (known.paths != nullptr) add_paths();
  if (known.boulders != nullptr) add_boulders();
}

FinerRelief::Weights Surface::weights_of_finer() const {
  return finer_->shown_below(heights_m_.step_m(), grid_.step_m());
}

void Surface::add_relief() {
  const GroundMap<FinerRelief::Bump> bumps = finer_->on_grid(grid_, weights_of_finer(), parts_);
  bumps_.emplace(grid_.samples, grid_.square);
  for (std::size_t k = 0; k < bumps.values().size(); ++k) {
    const FinerRelief::Bump& bump = bumps.values()[k];
    const double exposure = bump.height_m / std::max(bump.deviation_m, 1e-9);
    bumps_->values()[k] = {glm::vec2(bump.gradient), static_cast<float>(exposure)};
  }
  if (known_.water != nullptr) level_water();
}

double Surface::seen_of_feet(int i, int j) const {
  constexpr double buried_m = 0.3;
  const double snow_m = snow_.depth_at(place_m(i, j));
  return (1.0 - glm::smoothstep(0.0, buried_m, snow_m)) * (1.0 - water(i, j));
}

Surface::Grazed Surface::grazed(int i, int j) const {
  const glm::dvec2 at_m = place_m(i, j);
  const Trodden place = known_.grazing_steps->at(
      {at_m, height_m(i, j)}, gradient(heights_m_, at_m.x, at_m.y), grid_.step_m());
  if (place.bare <= 0.0 && place.gradient == glm::dvec2(0.0)) return {};
  const double grass = cover(i, j).grass;
  return {glm::vec2(grass * seen_of_feet(i, j) * place.gradient),
          static_cast<float>(grass * place.bare)};
}

void Surface::add_grazing_steps() {
  GroundMap<Grazed> all(grid_.samples, grid_.square);
  std::atomic<bool> any = false;
  parallel_for(static_cast<std::size_t>(grid_.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    bool any_here = false;
    visit_row(part(j), [&](int i) {
      all.at(i, j) = grazed(i, j);
      any_here = any_here || all.at(i, j).bare > 0.0F;
    });
    if (any_here) any = true;
  });
  if (any) grazed_ = std::move(all);
}

void Surface::add_paths() {
  trodden_ = known_.paths->on_grid(heights_m_, grid_, parts_);
  if (trodden_.empty()) return;
  if (!bumps_) bumps_.emplace(grid_.samples, grid_.square);
  parallel_for(static_cast<std::size_t>(grid_.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(part(j), [&](int i) {
      const Trodden place = trodden_.at(i, j);
      if (place.bare <= 0.0) return;
      const double seen = seen_of_feet(i, j);
      glm::vec2& gradient = bumps_->at(i, j).gradient;
      gradient = gradient * static_cast<float>(1.0 - seen * place.level) +
                 glm::vec2(seen * place.gradient);
    });
  });
}

double Surface::worn(int i, int j) const {
  const double by_herds = grazed_ ? double{grazed_->at(i, j).bare} : 0.0;
  return std::max(trodden_.at(i, j).bare, by_herds);
}

void Surface::add_boulders() {
  boulders_.emplace(known_.boulders->nearby(grid_.square, grid_.step_m()));
  if (boulders_->all().empty()) return;
  if (!bumps_) bumps_.emplace(grid_.samples, grid_.square);
  parallel_for(static_cast<std::size_t>(grid_.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(part(j), [&](int i) {
      bumps_->at(i, j).gradient += glm::vec2(rise_of_boulder(i, j).gradient);
    });
  });
}

NearbyBoulders::Rise Surface::rise_of_boulder(int i, int j) const {
  const glm::dvec2 at_m = place_m(i, j);
  return boulders_->at(at_m, snow_.depth_at(at_m));
}

NearbyBoulders::Rise Surface::boulder(int i, int j) const {
  if (!boulders_) return {};
  NearbyBoulders::Rise rise = rise_of_boulder(i, j);
  rise.cover += (1.0 - rise.cover) * known_.boulders->hidden_cover(place_m(i, j), grid_.step_m());
  return rise;
}

/// What is finer than the heights is no water's.
void Surface::level_water() {
  parallel_for(static_cast<std::size_t>(grid_.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(part(j), [&](int i) {
      const auto land = static_cast<float>(1.0 - water(i, j));
      bumps_->at(i, j) = {bumps_->at(i, j).gradient * land, bumps_->at(i, j).exposure * land};
    });
  });
}

double Surface::water(int i, int j) const {
  return known_.water == nullptr ? 0.0 : known_.water->share(place_m(i, j), grid_.step_m());
}

LandCover::Shares Surface::cover(int i, int j) const {
  LandCover::Shares shares =
      known_.cover == nullptr ? LandCover::Shares{} : known_.cover->at(place_m(i, j));
  if (known_.photo == nullptr) return shares;
  const LandCover::Shares seen = known_.photo->at(place_m(i, j));
  shares.grass *= seen.grass;
  shares.albedo = static_cast<float>(1.0 - seen.coloured) * shares.albedo + seen.albedo;
  shares.coloured = std::lerp(shares.coloured, 1.0, seen.coloured);
  return shares;
}

double Surface::scree(int i, int j) const {
  if (!scree_) return 0.0;
  const double lies = scree_->share(place_m(i, j), slope_deg(i, j), exposure(i, j));
  return lies * (1.0 - worn(i, j));
}

glm::dvec2 Surface::place_m(int i, int j) const {
  return grid_.square.corner_m + glm::dvec2(i, j) * grid_.step_m();
}

double Surface::height_m(int i, int j) const {
  const glm::dvec2 at_m = place_m(i, j);
  return double{heights_m_.sample(at_m.x, at_m.y)};
}

glm::dvec3 Surface::up(int i, int j) const {
  const glm::dvec2 at_m = place_m(i, j);
  glm::dvec2 ascent = gradient(heights_m_, at_m.x, at_m.y);
  if (bumps_) ascent += glm::dvec2(bumps_->at(i, j).gradient);
  return glm::normalize(glm::dvec3(-ascent, 1.0));
}

double Surface::holds_snow(int i, int j) const {
  constexpr double held_deg = 48.0, steepest_deg = 64.0;  // about as steep as ledges()
  return 1.0 - glm::smoothstep(held_deg, steepest_deg, slope_deg(i, j));
}

/// Snow on water is as level as that; walls and the sides of boulders have none.
std::optional<GroundMap<glm::vec2>> Surface::ascent_of_snow() const {
  if (!snow_ || (finer_ == nullptr && !snow_.carved)) return std::nullopt;
  GroundMap<glm::vec2> ascent(grid_.samples, grid_.square);
  if (finer_ != nullptr) {
    const auto hidden = finer_->hidden_by(snow_.depth_m, grid_, weights_of_finer(), parts_);
    for (std::size_t k = 0; k < ascent.values().size(); ++k)
      ascent.values()[k] = -hidden.values()[k];
  }
  parallel_for(static_cast<std::size_t>(grid_.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(part(j), [&](int i) {
      glm::vec2& here = ascent.at(i, j);
      if (finer_ != nullptr) here *= static_cast<float>(1.0 - water(i, j));
      if (snow_.carved) here += glm::vec2(snow_.carved(place_m(i, j), grid_.step_m()));
      if (here != glm::vec2(0.0F)) here *= static_cast<float>(holds_snow(i, j));
    });
  });
  return ascent;
}

/// With the steps of herds, where no path crosses them.
glm::dvec3 Surface::lit_face(int i, int j, const glm::vec2& ascent_of_snow) const {
  const glm::dvec3 face = up(i, j);
  glm::dvec2 more(ascent_of_snow);
  if (grazed_) more += (1.0 - trodden_.at(i, j).bare) * glm::dvec2(grazed_->at(i, j).gradient);
  return more == glm::dvec2(0.0) ? face : glm::normalize(face / face.z - glm::dvec3(more, 0.0));
}

bool Surface::is_even(int i, int j) const {
  return !bumps_ && (!grazed_ || grazed_->at(i, j).gradient == glm::vec2(0.0F));
}

double Surface::slope_deg(int i, int j) const {
  return math::acos(std::min(up(i, j).z, 1.0)) * degrees_per_radian;
}

double Surface::exposure(int i, int j) const {
  return bumps_ ? double{bumps_->at(i, j).exposure} : 0.0;
}

GroundLight Surface::lit(GroundLight on_heights, const glm::dvec3& to_sun) const {
  const std::optional<GroundMap<glm::vec2>> snow = ascent_of_snow();
  if (!bumps_ && !grazed_ && !snow) return on_heights;
  const ColourMap dark(grid_.samples, grid_.square);
  GroundLight light{dark, dark, FactorMap(grid_.samples, grid_.square)};
  parallel_for(static_cast<std::size_t>(grid_.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    visit_row(part(j), [&](int i) {
      const glm::dvec2 at_m = place_m(i, j);
      const glm::vec2 of_snow = snow ? snow->at(i, j) : glm::vec2(0.0F);
      if (is_even(i, j) && of_snow == glm::vec2(0.0F)) {
        light.sun.at(i, j) = on_heights.sun.sample(at_m.x, at_m.y);
        light.sky.at(i, j) = on_heights.sky.sample(at_m.x, at_m.y);
        light.overcast.at(i, j) = on_heights.overcast.sample(at_m.x, at_m.y);
        return;
      }
      const glm::dvec3 ground = normal(heights_m_, at_m.x, at_m.y), face = lit_face(i, j, of_snow);
      const Boulder::Light left =
          boulders_ ? boulders_->light_beside(at_m, to_sun, -glm::dvec2(ground) / ground.z,
                                              snow_.depth_at(at_m))
                    : Boulder::Light{};
      const auto sky = static_cast<float>(more_sky(face, ground) * left.sky);
      light.sun.at(i, j) = on_heights.sun.sample(at_m.x, at_m.y) *
                           static_cast<float>(more_sun(face, ground, to_sun) * left.sun);
      light.sky.at(i, j) = on_heights.sky.sample(at_m.x, at_m.y) * sky;
      light.overcast.at(i, j) = on_heights.overcast.sample(at_m.x, at_m.y) * sky;
    });
  });
  return light;
}

}  // namespace wold::terrain
