#include "terrain/rock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/normal_distribution.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// The largest bend of beds.
constexpr double bend_feature_m = 500.0;

/// Of what a block sends back, over the mean.
constexpr float darkest = 0.08F, brightest = 2.69F;

constexpr std::array<BlockSize, 8> block_sizes{{{300.0, 0.32, 0.1},
                                                {75.0, 0.4, 0.16},
                                                {19.0, 0.48, 0.24},
                                                {4.8, 0.5, 0.36},
                                                {1.2, 0.42, 0.6},
                                                {0.4, 0.26, 0.4},
                                                {0.12, 0.16, 0.2},
                                                {0.03, 0.14, 0.07}}};
constexpr std::array<BlockSize, 4> stone_sizes{{{1.2, 0.35, 0.3, 0.2},
                                                {0.4, 0.45, 0.5, 0.25},
                                                {0.12, 0.4, 0.4, 0.25},
                                                {0.03, 0.2, 0.2, 0.15}}};

/// Of worn boulders.
constexpr std::array<BlockSize, 4> boulder_sizes{
    {{0.9, 0.14, 0.2}, {0.3, 0.14, 0.2}, {0.09, 0.16, 0.16}, {0.03, 0.16, 0.12}}};

/// Beds that dip by 20 degrees, in a keyed direction.
glm::dmat3 beds(std::uint64_t key) {
  constexpr double dip = radians(20.0);
  const double heading = 2.0 * std::numbers::pi * random_uniform({key, key_of("dip"), 0, 0});
  const glm::dvec3 across(math::cos(heading), math::sin(heading), 0.0);
  const glm::dvec3 up = math::cos(dip) * glm::dvec3(0.0, 0.0, 1.0) +
                        math::sin(dip) * glm::dvec3(-across.y, across.x, 0.0);
  return glm::transpose(glm::dmat3(across, glm::cross(up, across), up));
}

}  // namespace

Rock::Rock(const glm::vec3& albedo, std::uint64_t seed, double step_m)
    : albedo_(albedo),
      key_(random_bits({seed, key_of("ground"), 0, key_of("rock")})),
      step_m_(step_m),
      bend_(random_bits({key_, key_of("bend"), 0, 0}), {bend_feature_m, 0.2}, /*hurst=*/1.0,
            step_m),
      beds_(random_bits({key_, key_of("beds"), 0, 0}), {200.0, 0.1}, /*hurst=*/0.3, /*step_m=*/0.0),
      stain_{random_bits({key_, key_of("stain"), 0, 0}), 5, 0.5},
      to_beds_(beds(key_)),
      lichens_{random_bits({key_, key_of("lichens"), 0, 0}), 4, 0.4},
      blocks_(block_sizes, key_, step_m),
      stones_(stone_sizes, random_bits({key_, key_of("stones"), 0, 0}), step_m),
      boulders_(boulder_sizes, random_bits({key_, key_of("boulders"), 0, 0}), step_m) {}

/// Bent, so that no joint is a straight line; a bed is half as thick as a block is wide.
glm::dvec3 Rock::bedded(const glm::dvec3& place_m) const {
  constexpr double bend = 0.08 * bend_feature_m, flatness = 2.0;
  const glm::dvec3 bent(bend_.at({place_m.y, place_m.z}), bend_.at({place_m.z, place_m.x}),
                        bend_.at({place_m.x, place_m.y}));
  return to_beds_ * (place_m + bend * bent) * glm::dvec3(1.0, 1.0, flatness);
}

/// The bed of a place, of variance 1 where a map shows all of it: thick and thin ones, each long.
double Rock::bed_at(const glm::dvec3& bedded_m, double step_m) const {
  constexpr double length = 30.0;  // over thickness
  return std::clamp(beds_.at({bedded_m.z, (bedded_m.x + 0.7 * bedded_m.y) / length}, step_m), -2.5,
                    2.5);
}

glm::vec3 Rock::at(const glm::dvec3& place_m, const glm::dvec3& up,
                   const glm::dvec3& to_sun) const {
  constexpr glm::vec3 colour(0.34F, 0.31F, 0.27F);
  if (!blocks_.is_shown()) return albedo_;
  const double step_m = slope_step_m(up, step_m_);
  const glm::dvec3 place = bedded(place_m);
  const glm::vec3 bed = 1.0F + static_cast<float>(bed_at(place, step_m)) * colour;
  return albedo_ * glm::clamp(static_cast<float>(blocks_.shade(place, up, to_sun)) * bed *
                                  stain_at(place_m, step_m),
                              darkest, brightest);
}

double Rock::ledges(const glm::dvec3& place_m, const glm::dvec3& up, double steepest_deg) const {
  constexpr double turn = 0.31, bed_deg = 7.0, edge_deg = 2.0;
  const double step_m = slope_step_m(up, step_m_);
  const glm::dvec3 place = bedded(place_m);
  const glm::dvec3 face = glm::normalize(glm::mix(up, blocks_.face(place, up), turn));
  const double slope_deg =
      math::acos(std::min(face.z, 1.0)) / radians_per_degree + bed_deg * bed_at(place, step_m);
  const double tilt_deg = turn * blocks_.hidden_tilt(up) / radians_per_degree;
  const double hidden_beds = std::max(1.0 - beds_.shown(step_m), 0.0);
  const double deviation_deg =
      std::sqrt(edge_deg * edge_deg + tilt_deg * tilt_deg + bed_deg * bed_deg * hidden_beds);
  return normal_cdf((steepest_deg - slope_deg) / deviation_deg);
}

glm::vec3 Rock::debris_at(const glm::dvec3& place_m, const glm::dvec3& up,
                          const glm::dvec3& to_sun) const {
  if (!stones_.is_shown()) return albedo_;
  return albedo_ *
         std::clamp(static_cast<float>(stones_.shade(place_m, up, to_sun)), darkest, brightest);
}

glm::vec3 Rock::boulder_at(const glm::dvec3& place_m, const glm::dvec3& up,
                           const glm::dvec3& to_sun) const {
  constexpr double lichen_m = 0.22, stone_m = 4.0, tone = 0.16, mean_cover = 0.242;
  constexpr glm::vec3 lichen(0.27F, 0.268F, 0.215F);
  const double step_m = slope_step_m(up, step_m_);
  // Without a direction in which it is drawn out on sides.
  const auto on_faces = [&](double size_m) {
    const glm::dvec3 at = place_m / size_m;
    return glm::dvec2(at.x + 0.7 * at.z, at.y - 0.7 * at.z);
  };
  const double shade = std::min(boulders_.shade(place_m, up, to_sun), double{brightest});
  const double weathered =
      1.0 + tone * shown_fraction(stone_m, step_m) * math::tanh(stain_.at(on_faces(stone_m)));
  const double cover =
      std::lerp(mean_cover, glm::smoothstep(0.5, 0.9, lichens_.at(on_faces(lichen_m))),
                shown_fraction(lichen_m, step_m));
  const glm::vec3 surface =
      glm::mix(albedo_ * static_cast<float>(weathered) * stain_at(place_m, step_m), lichen,
               static_cast<float>(cover));
  return surface * static_cast<float>(shade);
}

/// Damp and lichens.
glm::vec3 Rock::stain_at(const glm::dvec3& place_m, double step_m) const {
  constexpr double feature_m = 1.2;
  const glm::dvec3 at = place_m / feature_m;
  const double stain = shown_fraction(feature_m, step_m) *
                       math::tanh(stain_.at({at.x + 0.7 * at.z, at.y - 0.7 * at.z}));
  return 1.0F + static_cast<float>(stain) * glm::vec3(0.16F, 0.13F, 0.06F);
}

double beyond_rock_deg(double slope_deg, double exposure, double rock_slope_deg) {
  constexpr double deg_per_exposure = 4.0;
  return slope_deg - rock_slope_deg + deg_per_exposure * std::clamp(exposure, -2.0, 2.0);
}

}  // namespace wold::terrain
