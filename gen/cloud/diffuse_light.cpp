#include "cloud/diffuse_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "cloud/plane_sweep.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::cloud {

using std::numbers::pi;

namespace {

using Moments = std::vector<LightMoments>;

/// An ordinate on its way through the box, and its radiance half-way between two planes.
struct Beam {
  glm::vec3 direction;
  PlaneStep back;  ///< to the plane that its light comes from
  BorderedPlane<glm::vec4> before, after;

  Beam(const VoxelBox& box, const glm::dvec3& ordinate, const glm::vec3& arriving)
      : direction(ordinate),
        back(box, -ordinate),
        before(back.plane_size(box), back.border, glm::vec4(arriving, 0.0F)),
        after(before) {}
};

/// Ordinates whose light goes from plane to plane across one axis by ways of one length.
struct Bundle {
  double half_m;     ///< of the way from a plane to the next
  bool is_backward;  ///< against the axis
  std::vector<Beam> beams;

  bool has_place_for(const Beam& beam) const {
    const PlaneStep &own = beams.front().back, &other = beam.back;
    return own.axis == other.axis && is_backward == (beam.direction[other.axis] < 0.0F) &&
           std::abs(own.length_m - other.length_m) < 1e-9 * own.length_m;
  }
};

std::vector<Bundle> bundles_of(const VoxelBox& box, const ArrivingRadiance& arriving) {
  std::vector<Bundle> bundles;
  for (std::size_t i = 0; i < ordinate_count; ++i) {
    Beam beam(box, ordinates()[i], arriving[i]);
    const auto same = std::ranges::find_if(
        bundles, [&](const Bundle& bundle) { return bundle.has_place_for(beam); });
    if (same != bundles.end())
      same->beams.push_back(std::move(beam));
    else
      bundles.push_back({0.5 * beam.back.length_m, beam.direction[beam.back.axis] < 0.0F, {beam}});
  }
  return bundles;
}

/// Takes a beam through a voxel, of whose way half lets `half_left` through, and adds it there.
void pass_voxel(Beam& beam, int x, int y, const LightMoments& source, float half_left,
                LightMoments& sums) {
  constexpr float weight = 1.0F / ordinate_count;
  const glm::vec3& way = beam.direction;
  const glm::vec4 gained = (1.0F - half_left) * source.along(way);
  const glm::vec4 here = half_left * beam.before.after(beam.back, x, y) + gained;
  beam.after.at(x, y) = half_left * here + gained;
  const glm::vec4 part = weight * here;
  sums.add(1.0F, {part, {way.x * part, way.y * part, way.z * part}});
}

/// Follows a bundle through the box and adds its part to the moments.
void sweep(const VoxelBox& box, Bundle bundle, const Moments& source,
           const std::vector<float>& half_left, Moments& sums) {
  constexpr int rows_at_a_time = 8;
  const PlaneStep step = bundle.beams.front().back;
  const int planes = step.planes(box);
  const glm::ivec2 size = step.plane_size(box);
  for (int i = 0; i < planes; ++i) {
    const int plane = bundle.is_backward ? planes - 1 - i : i;
    const auto blocks = static_cast<std::size_t>((size.y + rows_at_a_time - 1) / rows_at_a_time);
    parallel_for(blocks, [&](std::size_t block) {
      const int first = static_cast<int>(block) * rows_at_a_time;
      for (int y = first; y < std::min(first + rows_at_a_time, size.y); ++y)
        for (int x = 0; x < size.x; ++x) {
          const std::size_t voxel = step.index(box, plane, x, y);
          for (Beam& beam : bundle.beams)
            pass_voxel(beam, x, y, source[voxel], half_left[voxel], sums[voxel]);
        }
    });
    for (Beam& beam : bundle.beams) {
      std::swap(beam.before, beam.after);
      if (box.repeats) beam.before.repeat();
    }
  }
}

std::vector<float> transmittances(const std::vector<float>& extinction_per_m, double length_m) {
  std::vector<float> left(extinction_per_m.size());
  parallel_for_blocks(left.size(), [&](std::size_t i) {
    const double optical_depth = length_m * extinction_per_m[i];
    left[i] = static_cast<float>(math::exp(-optical_depth));
  });
  return left;
}

/// Adds an order of scattering, `orders` times.
void scatter(const ScatteringBox& scattering, int orders, Moments& light) {
  const std::vector<Bundle> bundles = bundles_of(scattering.box, scattering.arriving);
  std::vector<float> half_left;
  double half_m = 0.0;
  for (int order = 0; order < orders; ++order) {
    const Moments source = scattered(scattering, light);
    std::ranges::fill(light, LightMoments{});
    for (const Bundle& bundle : bundles) {
      if (bundle.half_m != half_m)
        half_left = transmittances(scattering.extinction_per_m, half_m = bundle.half_m);
      sweep(scattering.box, bundle, source, half_left, light);
    }
  }
}

/// Sums over the eight voxels, as far as they are there, that make one twice as large.
template <class Add>
void each_of_eight(const VoxelBox& box, const glm::ivec3& coarse, const Add& add) {
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 at = 2 * coarse + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    if (glm::all(glm::lessThan(at, box.voxels))) add(box.index(at));
  }
}

bool can_be_halved(const VoxelBox& box) {
  const glm::ivec3& n = box.voxels;
  return std::min({n.x, n.y, n.z}) >= 6 && !(box.repeats && (n.x % 2 != 0 || n.y % 2 != 0));
}

/// The moments of a box with voxels twice as large, interpolated.
Moments refined(const VoxelBox& box, const VoxelBox& coarse, const Moments& coarse_light) {
  Moments light(box.count());
  parallel_for(light.size() / static_cast<std::size_t>(box.voxels.x), [&](std::size_t row) {
    const int y = static_cast<int>(row) % box.voxels.y, z = static_cast<int>(row) / box.voxels.y;
    for (int x = 0; x < box.voxels.x; ++x) {
      const CoarseNeighbours around(coarse, {x, y, z});
      for (std::size_t i = 0; i < 8; ++i)
        light[box.index({x, y, z})].add(around.weights[i], coarse_light[around.voxels[i]]);
    }
  });
  return light;
}

}  // namespace

Moments scattered(const ScatteringBox& scattering, const Moments& light) {
  const glm::vec4 sun(scattering.sun_irradiance / static_cast<float>(4.0 * pi), 0.0F);
  const glm::vec3 sun_way(-scattering.sun_direction);
  const auto times = static_cast<float>(3.0 * scattering.asymmetry);
  Moments source(light.size());
  parallel_for_blocks(light.size(), [&](std::size_t i) {
    const glm::vec4 direct = scattering.sunlight[i] * sun;
    source[i].mean = light[i].mean + direct;
    for (int axis = 0; axis < 3; ++axis)
      source[i].flux[static_cast<std::size_t>(axis)] =
          times * (light[i].flux[static_cast<std::size_t>(axis)] + sun_way[axis] * direct);
  });
  return source;
}

ScatteringBox halved(const ScatteringBox& scattering) {
  const VoxelBox& fine = scattering.box;
  ScatteringBox half = scattering;
  half.box.voxel_m = 2.0 * fine.voxel_m;
  half.box.voxels = (fine.voxels + 1) / 2;
  half.extinction_per_m.assign(half.box.count(), 0.0F);
  half.sunlight.assign(half.box.count(), 0.0F);
  const auto planes = static_cast<std::size_t>(half.box.voxels.z);
  parallel_for(planes, [&](std::size_t z) {
    for (int y = 0; y < half.box.voxels.y; ++y)
      for (int x = 0; x < half.box.voxels.x; ++x) {
        const glm::ivec3 at(x, y, static_cast<int>(z));
        float extinction = 0.0F, lit = 0.0F, sunlight = 0.0F, parts = 0.0F;
        each_of_eight(fine, at, [&](std::size_t i) {
          extinction += scattering.extinction_per_m[i];
          lit += scattering.extinction_per_m[i] * scattering.sunlight[i];
          sunlight += scattering.sunlight[i];
          parts += 1.0F;
        });
        half.extinction_per_m[half.box.index(at)] = extinction / 8.0F;
        half.sunlight[half.box.index(at)] = extinction > 0.0F ? lit / extinction : sunlight / parts;
      }
  });
  return half;
}

CoarseNeighbours::CoarseNeighbours(const VoxelBox& coarse, const glm::ivec3& fine)
    : voxels(), weights() {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const glm::ivec3 far(corner & 1, corner >> 1 & 1, corner >> 2);
    glm::ivec3 at = fine / 2 + far * (2 * (fine % 2) - 1);
    if (coarse.repeats)
      for (const int axis : {0, 1}) at[axis] = wrapped_index(at[axis], coarse.voxels[axis]);
    voxels[corner] = coarse.index(glm::clamp(at, glm::ivec3(0), coarse.voxels - 1));
    const glm::vec3 parts = glm::mix(glm::vec3(0.75F), glm::vec3(0.25F), glm::vec3(far));
    weights[corner] = parts.x * parts.y * parts.z;
  }
}

std::vector<LightMoments> diffuse_light(const ScatteringBox& scattering) {
  constexpr int first_orders = 200, further_orders = 6;
  if (!can_be_halved(scattering.box)) {
    Moments light(scattering.box.count());
    scatter(scattering, first_orders, light);
    return light;
  }
  const ScatteringBox coarse = halved(scattering);
  Moments light = refined(scattering.box, coarse.box, diffuse_light(coarse));
  scatter(scattering, further_orders, light);
  return light;
}

}  // namespace wold::cloud
