#include "grass/texel/points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/random.h"
#include "grass/texel/voxelise.h"

namespace wold::grass {
namespace {

/// A sampled point of a fresh blade.
struct RestPoint {
  float arc_m;
  float side_m;
  float across_m;
  float area_m2;
  bool vein;
};

/// Coordinates of the blade: along its axis, off it in its vertical plane, off it horizontally.
RestPoint at_rest(const Blade& blade, const glm::vec3& place_m, float area_m2, bool vein) {
  const glm::vec3 from_root = place_m - foot_m(blade);
  const float out = glm::dot(glm::vec2(from_root), blade.heading);
  const float sine = math::sin(blade.lean);
  const float cosine = math::cos(blade.lean);
  RestPoint point;
  point.arc_m = std::clamp(sine * out + cosine * from_root.z, 0.0F, blade.length_m);
  point.side_m = cosine * out - sine * from_root.z;
  point.across_m = blade.heading.x * from_root.y - blade.heading.y * from_root.x;
  point.area_m2 = area_m2;
  point.vein = vein;
  const float radius = blade.radius_m * (1.0F - point.arc_m / blade.length_m);
  const float distance = math::hypot(point.side_m, point.across_m);
  if (distance > radius) {
    point.side_m *= radius / distance;
    point.across_m *= radius / distance;
  }
  return point;
}

/// Whole number of points for an expected one; fractions below one by a keyed draw.
int whole_points(double expected, const RandomKey& key) {
  if (expected >= 1.0) return static_cast<int>(std::lround(expected));
  return random_uniform(key) < expected ? 1 : 0;
}

/// Scales the points' areas so that their sum is the blade's.
void keep_area(std::vector<RestPoint>& points, double area_m2) {
  double sum = 0.0;
  for (const RestPoint& point : points) sum += double{point.area_m2};
  const auto factor = static_cast<float>(sum > 0.0 ? area_m2 / sum : 0.0);
  for (RestPoint& point : points) point.area_m2 *= factor;
}

/// One point for a blade so small that chance drew none: its fullest voxel.
RestPoint middle_of(const Blade& blade, const std::vector<BladeVoxel>& voxels) {
  const auto fullest =
      std::max_element(voxels.begin(), voxels.end(),
                       [](const auto& a, const auto& b) { return a.area_m2 < b.area_m2; });
  const float arc_m = blade.length_m / 3.0F;
  return {arc_m, 0.0F, 0.0F, fullest->area_m2, true};
}

std::vector<RestPoint> sample_blade(const Blade& blade, std::uint64_t number,
                                    const TexelShape& shape, double points_per_voxel_face,
                                    std::uint64_t seed) {
  const auto voxel_m = static_cast<float>(shape.voxel_m);
  const double face_m2 = shape.voxel_m * shape.voxel_m;
  std::vector<RestPoint> points;
  double area = 0.0;
  std::uint64_t draw = 0;
  const std::vector<BladeVoxel> voxels = voxelise_blade(blade, shape);
  for (const BladeVoxel& voxel : voxels) {
    const double expected = points_per_voxel_face * double{voxel.area_m2} / face_m2;
    const RandomKey key{seed, key_of("point"), (number << 32) | draw++, 0};
    const auto with = [&](std::uint64_t purpose) {
      return RandomKey{key.seed, key.kind, key.index, purpose};
    };
    const int count = whole_points(expected, with(key_of("number")));
    area += double{voxel.area_m2};
    for (int k = 0; k < count; ++k) {
      const auto axis = [&](std::uint64_t i) {
        return static_cast<float>(random_uniform(with(static_cast<std::uint64_t>(3 * k) + i)));
      };
      const glm::vec3 place =
          (glm::vec3(voxel.voxel) + glm::vec3(axis(0), axis(1), axis(2))) * voxel_m;
      // Points drawn by chance stand for what a point stands for on average.
      const double fraction =
          expected < 1.0 ? face_m2 / points_per_voxel_face : double{voxel.area_m2} / count;
      points.push_back(
          at_rest(blade, place, static_cast<float>(fraction), voxel.normal == glm::vec3(0.0F)));
    }
  }
  if (points.empty()) points.push_back(middle_of(blade, voxels));
  keep_area(points, area);
  std::stable_sort(points.begin(), points.end(),
                   [](const RestPoint& a, const RestPoint& b) { return a.arc_m < b.arc_m; });
  return points;
}

void append(const std::vector<RestPoint>& from, Points& to) {
  for (const RestPoint& point : from) {
    to.arc_m.push_back(point.arc_m);
    to.side_m.push_back(point.side_m);
    to.across_m.push_back(point.across_m);
    to.rest_area_m2.push_back(point.area_m2);
    to.vein.push_back(point.vein ? 1 : 0);
  }
  to.blade_begin.push_back(static_cast<std::uint32_t>(to.size()));
}

}  // namespace

Points sample_points(const std::vector<Blade>& blades, const TexelShape& shape,
                     double points_per_voxel_face, std::uint64_t seed) {
  std::vector<std::vector<RestPoint>> sampled(blades.size());
  parallel_for(blades.size(), [&](std::size_t i) {
    sampled[i] = sample_blade(blades[i], i, shape, points_per_voxel_face, seed);
  });
  Points points;
  points.blade_begin.push_back(0);
  for (const auto& blade : sampled) append(blade, points);
  const std::size_t count = points.size();
  points.position_m.resize(count);
  points.tangent.resize(count);
  points.normal.resize(count);
  points.albedo.resize(count);
  points.transmittance.resize(count);
  points.specular.resize(count);
  points.area_m2 = points.rest_area_m2;
  return points;
}

}  // namespace wold::grass
