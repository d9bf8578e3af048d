#include "ground/land_around.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"

namespace wold::ground {
namespace {

/// What grows alike has all sizes, however small the square is.
constexpr double largest_patch_m = 1000.0, finest_patch_m = 0.5, patch_hurst = 0.1;

ScaleFreeNoise::Sizes patch_sizes(double square_m) {
  return {std::max(0.1 * square_m, largest_patch_m), finest_patch_m};
}

/// How much more all land differs than places of a square: it may have patches that are larger, by
/// the same law.
double wider_spread(double square_m) {
  const auto variance = [](const ScaleFreeNoise::Sizes& sizes) {
    double sum = 0.0;
    for (double patch_m = sizes.largest_m; patch_m >= sizes.smallest_m; patch_m /= 2.0)
      sum += math::pow(patch_m, 2.0 * patch_hurst);
    return sum;
  };
  const ScaleFreeNoise::Sizes in_square = {square_m, square_m / LandAppearance::places};
  return std::max(1.0, std::sqrt(variance(patch_sizes(square_m)) / variance(in_square)));
}

/// A square about another one's middle.
Square around(const Square& square, double size_m) {
  return {square.corner_m - 0.5 * (size_m - square.size_m), size_m};
}

}  // namespace

LandAround::LandAround(const terrain::Surroundings& land, const light::Daylight& day,
                       const Haze& haze, LandAppearance appearance, const Illuminate& illuminate,
                       std::uint64_t seed)
    : land_(land),
      day_(day),
      haze_(haze),
      appearance_(std::move(appearance)),
      variation_(random_bits({seed, key_of("ground"), 0, key_of("land around")}),
                 patch_sizes(land.square().size_m), patch_hurst, /*step_m=*/0.0),
      wider_spread_(static_cast<float>(wider_spread(land.square().size_m))) {
  constexpr double wider = 3.0;  // each square than the one before
  const double all_m = land.square().size_m + 2.0 * land.reach_m();
  double width_m = land.square().size_m;
  do {
    width_m = std::min(wider * width_m, all_m);
    left_.push_back(left_of_light(around(land.square(), width_m), illuminate));
  } while (width_m < all_m);
}

LandAround::Left LandAround::left_of_light(const Square& square, const Illuminate& illuminate) {
  constexpr int samples = 257;  // shadows of heaped clouds show tens of kilometres away
  const ColourMap none(samples, square, glm::vec3(0.0F)), all(samples, square, glm::vec3(1.0F));
  const FactorMap no_overcast(samples, square, 0.0F), overcast(samples, square, 1.0F);
  return {illuminate({all, none, no_overcast}), illuminate({none, all, overcast})};
}

const LandAround::Left& LandAround::left_at(const glm::dvec2& at_m) const {
  const auto contains = [&](const Left& left) { return left.of_sun.square().contains(at_m); };
  const auto finest = std::ranges::find_if(left_, contains);
  return finest == left_.end() ? left_.back() : *finest;
}

/// Fraction of the sun's disc, taken as 2 degrees wide, above the land's own horizon.
double LandAround::sun_seen(const glm::dvec3& at_m) const {
  constexpr double farthest_m = 40000.0, spacing = 0.05, half_width = 0.0175;
  const glm::dvec3& sun = day_.sun_direction();
  const double level = glm::length(glm::dvec2(sun));
  if (level < 1e-6) return 1.0;
  const glm::dvec2 towards = glm::dvec2(sun) / level;
  const double step_m = land_.step_m(glm::dvec2(at_m)), elevation = math::asin(sun.z);
  // Land below all of the disc hides nothing of it, however high it is.
  double highest = std::max(-1.0, math::tan(elevation - 1.01 * half_width));
  for (double distance_m = 1.5 * step_m; distance_m < farthest_m;
       distance_m += std::max(step_m, spacing * distance_m)) {
    const glm::dvec2 there_m = glm::dvec2(at_m) + towards * distance_m;
    const auto rise_to = [&](double height_m) { return (height_m - at_m.z) / distance_m; };
    if (rise_to(land_.highest_m()) <= highest) break;
    if (rise_to(land_.highest_m(there_m)) > highest)
      highest = std::max(highest, rise_to(land_.coarse_height_m(there_m)));
  }
  return glm::smoothstep(-half_width, half_width, elevation - math::atan(highest));
}

/// Sun by Lambert's law where no land hides it; of the sky what an even slope faces.
glm::vec3 LandAround::irradiance(const glm::dvec3& at_m, const glm::dvec3& up) const {
  const glm::dvec2 place_m(at_m);
  const Left& left = left_at(place_m);
  const double lambert = std::max(glm::dot(up, day_.sun_direction()), 0.0);
  const double sun = lambert > 0.0 ? lambert * sun_seen(at_m) : 0.0;
  return left.of_sun.sample(place_m.x, place_m.y) * day_.sun_irradiance() *
             static_cast<float>(sun) +
         left.of_sky.sample(place_m.x, place_m.y) * day_.sky_irradiance() *
             static_cast<float>(0.5 + 0.5 * up.z);
}

glm::vec3 LandAround::radiance(const glm::dvec2& place_m, double step_m) const {
  return haze_.before(near_radiance(place_m, step_m), {place_m, land_.height_m(place_m)});
}

glm::vec3 LandAround::near_radiance(const glm::dvec2& place_m, double step_m) const {
  const glm::dvec3 at_m(place_m, land_.height_m(place_m, step_m));
  const glm::vec3 differs =
      appearance_.variety().at(variation_.at(place_m, step_m), variation_.shown(step_m));
  // What grows knows the slope as that of places in the square is known.
  const glm::dvec3 up_of_slope = land_.up(place_m, land_.step_m(place_m));
  const glm::vec3 look = appearance_.at(up_of_slope, at_m.z) *
                         glm::max(1.0F + wider_spread_ * differs, glm::vec3(0.2F));
  return look * irradiance(at_m, land_.up(place_m, step_m));
}

void paint_land_around(const LandRadiance& land, const LandAround& around, const LandView& view,
                       const glm::dvec3& eye_m, landscape::Backdrop& backdrop) {
  constexpr std::array<glm::dvec2, 4> places = {
      {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};
  Image& picture = backdrop.picture;
  const auto direction = [&](const glm::dvec2& at) {
    return backdrop.corner_m + backdrop.right_m * (at.x / picture.width) +
           backdrop.up_m * (1.0 - at.y / picture.height) - eye_m;
  };
  const auto seen = [&](const glm::dvec3& to, const glm::vec3& sky) {
    const auto at_m = view.place(to);
    if (at_m) return land(*at_m, view.covered_m(*at_m));
    return to.z < 0.0 ? around.beyond(to) : sky;
  };
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x) {
      float* pixel = picture.pixel(x, y);
      const glm::vec3 sky(pixel[0], pixel[1], pixel[2]);
      glm::vec3 mean(0.0F);
      for (const glm::dvec2& place : places)
        mean += 0.25F * seen(direction(glm::dvec2(x, y) + place), sky);
      std::copy_n(&mean.x, 3, pixel);
    }
  });
}

}  // namespace wold::ground
