#include "grass/texel/texel_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/elementary.h"
#include "core/error.h"
#include "core/random.h"
#include "grass/geometry/axis.h"

namespace wold::grass {
namespace {

constexpr double max_points = 20e6;
/// Least rise of a tangent on its way to the ground: sine of 12 degrees.
constexpr float min_rise = 0.208F;
constexpr int ground_cells = 64;
constexpr int headings = 8;

/// A point as it is drawn from its voxel.
struct Drawn {
  std::uint64_t blade = 0;  ///< key of what it lies on
  glm::vec3 position_m;
  glm::vec3 foot_m;
  glm::vec3 tangent;  ///< unit, upwards
  float area_m2 = 0.0F;
  std::uint32_t voxel = 0;
};

/// Upwards, and steep enough to meet the ground nearby.
glm::vec3 rising(const glm::vec3& tangent) {
  glm::vec3 up = tangent.z < 0.0F ? -tangent : tangent;
  const float level = glm::length(glm::vec2(up));
  if (up.z >= min_rise || level == 0.0F) return up;
  return {glm::vec2(up) * (std::sqrt(1.0F - min_rise * min_rise) / level), min_rise};
}

std::uint64_t blade_key(const glm::vec3& foot_m, const glm::vec3& tangent, float cell_m,
                        float patch_m) {
  const auto cells = static_cast<std::int64_t>(std::ceil(patch_m / cell_m));
  const auto cell = [&](float at_m) {
    const auto i = static_cast<std::int64_t>(std::floor(at_m / cell_m)) % cells;
    return static_cast<std::uint64_t>(i < 0 ? i + cells : i);
  };
  const float turn = math::atan2(tangent.y, tangent.x) / (2.0F * std::numbers::pi_v<float>)+0.5F;
  const auto sector =
      std::min(static_cast<std::uint64_t>(turn * headings), std::uint64_t{headings - 1});
  return (cell(foot_m.y) * static_cast<std::uint64_t>(cells) + cell(foot_m.x)) * headings + sector;
}

double optical_depth(const Texel& texel, std::size_t i) {
  return double{texel.density[i]} * texel.shape.voxel_m;
}

void refuse_too_many(const Texel& texel, double points_per_voxel_face) {
  double expected = 0.0;
  for (std::size_t i = 0; i < texel.size(); ++i)
    expected += points_per_voxel_face * optical_depth(texel, i);
  if (expected > max_points)
    throw InputError(fmt::format(
        "grass.from_texel: found a texel of {:.2g} points, expected at most {:.2g}: a smaller "
        "grass.points_per_voxel_face, or a thinner volume",
        expected, max_points));
}

std::vector<Drawn> draw_points(const Texel& texel, double points_per_voxel_face,
                               std::uint64_t seed) {
  const auto voxel_m = static_cast<float>(texel.shape.voxel_m);
  const auto patch_m = static_cast<float>(texel.shape.patch_m());
  const float cell_m = std::max(2.0F * voxel_m, patch_m / ground_cells);
  const double face_m2 = texel.shape.voxel_m * texel.shape.voxel_m;
  std::vector<Drawn> drawn;
  for (std::uint32_t i = 0; i < texel.size(); ++i) {
    const auto uniform = [&](std::uint64_t purpose) {
      return random_uniform({seed, key_of("texel point"), texel.voxel[i], purpose});
    };
    const double expected = points_per_voxel_face * optical_depth(texel, i);
    const auto count = static_cast<std::uint64_t>(expected + uniform(0));
    for (std::uint64_t k = 0; k < count; ++k) {
      const auto place = [&](std::uint64_t axis) {
        return static_cast<float>(uniform(1 + 3 * k + axis));
      };
      Drawn point;
      point.position_m = (glm::vec3(texel.shape.coordinates(texel.voxel[i])) +
                          glm::vec3(place(0), place(1), place(2))) *
                         voxel_m;
      point.tangent = rising(texel.tangent[i]);
      point.foot_m = point.position_m - point.position_m.z / point.tangent.z * point.tangent;
      point.area_m2 = static_cast<float>(face_m2 / points_per_voxel_face);
      point.voxel = i;
      point.blade = blade_key(point.foot_m, point.tangent, cell_m, patch_m);
      drawn.push_back(point);
    }
  }
  return drawn;
}

/// Scales the points' areas so that their sum is the texel's.
void keep_area(std::vector<Drawn>& drawn, double area_m2) {
  double sum = 0.0;
  for (const Drawn& point : drawn) sum += double{point.area_m2};
  for (Drawn& point : drawn)
    point.area_m2 = static_cast<float>(double{point.area_m2} * (area_m2 / sum));
}

/// One tile of the patch for all of a blade: that of its first point's foot.
void bring_together(std::vector<Drawn>::iterator begin, std::vector<Drawn>::iterator end,
                    float patch_m) {
  for (auto point = begin; point != end; ++point) {
    const glm::vec2 tiles = glm::round(glm::vec2(begin->foot_m - point->foot_m) / patch_m);
    const glm::vec3 shift_m(tiles * patch_m, 0.0F);
    point->foot_m += shift_m;
    point->position_m += shift_m;
  }
}

/// Means by area of a blade's points.
struct Means {
  glm::vec3 foot_m{0.0F}, tangent{0.0F}, albedo{0.0F};
  float area_m2 = 0.0F;
};

Means means_of(std::vector<Drawn>::const_iterator begin, std::vector<Drawn>::const_iterator end,
               const Texel& texel) {
  Means means;
  for (auto point = begin; point != end; ++point) {
    means.foot_m += point->area_m2 * point->foot_m;
    means.tangent += point->area_m2 * point->tangent;
    if (!texel.albedo.empty()) means.albedo += point->area_m2 * texel.albedo[point->voxel];
    means.area_m2 += point->area_m2;
  }
  means.foot_m /= means.area_m2;
  means.albedo /= means.area_m2;
  means.tangent = rising(glm::normalize(means.tangent));
  return means;
}

Blade blade_of(const Means& means, const scene::Grass& grass, const scene::Physiology& ageing,
               const RandomKey& key) {
  const auto normal = [&](const char* purpose) {
    return std::clamp(random_normal({key.seed, key.kind, key.index, key_of(purpose)}), -2.2, 2.2);
  };
  const glm::vec2 level(means.tangent);
  const float out = glm::length(level);
  Blade blade;
  blade.root_m = glm::vec2(means.foot_m);
  blade.heading = out > 1e-6F ? level / out : glm::vec2(1.0F, 0.0F);
  blade.lean = math::atan2(out, means.tangent.z);
  blade.fresh_droop = 0.0F;
  blade.droop_rate =
      static_cast<float>(ageing.droop * std::max(0.3, 1.0 + ageing.droop_spread * normal("droop")));
  blade.onset = static_cast<float>(ageing.onset_spread * normal("onset"));
  blade.keel_depth_m = static_cast<float>(grass.keel_depth_m);
  return blade;
}

/// Places of points on their blade; sets how long and wide it is.
void append_blade(std::vector<Drawn>::const_iterator begin, std::vector<Drawn>::const_iterator end,
                  const Texel& texel, const Means& means, Blade blade, SampledTexel& to) {
  const glm::vec3 axis = from_plane(blade, {math::sin(blade.lean), math::cos(blade.lean)});
  const glm::vec3 side = from_plane(blade, {math::cos(blade.lean), -math::sin(blade.lean)});
  const glm::vec3 across(-blade.heading.y, blade.heading.x, 0.0F);
  struct Place {
    float arc_m, side_m, across_m;
    const Drawn* point;
  };
  std::vector<Place> places;
  blade.length_m = static_cast<float>(texel.shape.voxel_m);
  for (auto point = begin; point != end; ++point) {
    const glm::vec3 way_m = point->position_m - foot_m(blade);
    const float arc_m = std::max(glm::dot(way_m, axis), 0.0F);
    const glm::vec3 off_m = way_m - arc_m * axis;
    places.push_back({arc_m, glm::dot(off_m, side), glm::dot(off_m, across), &*point});
    blade.length_m = std::max(blade.length_m, arc_m);
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.arc_m < b.arc_m; });
  // A cone shows pi / 4 of its length times its radius on average.
  blade.radius_m = means.area_m2 / (0.25F * std::numbers::pi_v<float> * blade.length_m);
  for (const Place& place : places) {
    to.points.arc_m.push_back(place.arc_m);
    to.points.side_m.push_back(place.side_m);
    to.points.across_m.push_back(place.across_m);
    to.points.rest_area_m2.push_back(place.point->area_m2);
    to.points.vein.push_back(texel.normal[place.point->voxel] == glm::vec3(0.0F) ? 1 : 0);
  }
  const auto patch_m = static_cast<float>(texel.shape.patch_m());
  blade.root_m -= patch_m * glm::floor(blade.root_m / patch_m);
  to.points.blade_begin.push_back(static_cast<std::uint32_t>(to.points.size()));
  to.blades.push_back(blade);
}

}  // namespace

SampledTexel sample_texel(const Texel& texel, const scene::Grass& grass,
                          const scene::Physiology& ageing, std::uint64_t seed) {
  refuse_too_many(texel, grass.points_per_voxel_face);
  std::vector<Drawn> drawn = draw_points(texel, grass.points_per_voxel_face, seed);
  if (drawn.empty())
    throw InputError(
        "grass.from_texel: found a texel too thin to give a single point, expected a denser one, "
        "or a larger grass.points_per_voxel_face");
  keep_area(drawn, texel.area_m2());
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const Drawn& a, const Drawn& b) { return a.blade < b.blade; });
  SampledTexel sampled;
  sampled.points.blade_begin.push_back(0);
  for (auto begin = drawn.begin(); begin != drawn.end();) {
    const auto end = std::find_if(begin, drawn.end(),
                                  [&](const Drawn& point) { return point.blade != begin->blade; });
    bring_together(begin, end, static_cast<float>(texel.shape.patch_m()));
    const Means means = means_of(begin, end, texel);
    Blade blade = blade_of(means, grass, ageing, {seed, key_of("texel blade"), begin->blade, 0});
    if (!texel.albedo.empty()) blade.own_albedo = means.albedo;
    append_blade(begin, end, texel, means, blade, sampled);
    begin = end;
  }
  Points& points = sampled.points;
  points.position_m.resize(points.size());
  points.tangent.resize(points.size());
  points.normal.resize(points.size());
  points.albedo.resize(points.size());
  points.transmittance.resize(points.size());
  points.specular.resize(points.size());
  points.area_m2 = points.rest_area_m2;
  return sampled;
}

}  // namespace wold::grass
