#include "grass/optics/scattered_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/texel/columns.h"

namespace wold::grass {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// What matter sends to all sides alike, and what the ground gets.
struct Sources {
  std::vector<glm::vec3> matter;  ///< radiance
  glm::vec3 on_ground{0.0F};      ///< irradiance
};

/// Rays of one direction of the sky through the patch, down and up again.
class Sweep {
 public:
  Sweep(const Scatterer& matter, const VoxelRows& voxels, const SkyDirection& sky)
      : voxels_(voxels),
        columns_(matter.shape, sky.direction),
        cuts_(static_cast<float>(columns_.slabs().size()) /
              static_cast<float>(matter.shape.height)) {
    const double length_m = columns_.slabs().front().length_m;
    hidden_.reserve(matter.extinction_per_m.size());
    for (const float extinction_per_m : matter.extinction_per_m)
      hidden_.push_back(static_cast<float>(-math::expm1(-length_m * double{extinction_per_m})));
  }

  /// Radiance that comes to each voxel from above where `above` comes from the sky, added to
  /// `arriving`. Returns the mean that reaches the ground.
  glm::vec3 down(const glm::vec3& above, const Sources& sources,
                 std::vector<glm::vec3>& arriving) const {
    std::vector<glm::vec3> rays(columns_.rays(), above);
    for (const Columns::Slab& slab : columns_.slabs()) cross(slab, sources, rays, arriving);
    glm::vec3 sum(0.0F);
    for (const glm::vec3& ray : rays) sum += ray;
    return sum / static_cast<float>(rays.size());
  }

  /// The same from the ground, which sends `below`.
  void up(const glm::vec3& below, const Sources& sources, std::vector<glm::vec3>& arriving) const {
    std::vector<glm::vec3> rays(columns_.rays(), below);
    const auto& slabs = columns_.slabs();
    for (auto slab = slabs.rbegin(); slab != slabs.rend(); ++slab)
      cross(*slab, sources, rays, arriving);
  }

 private:
  void cross(const Columns::Slab& slab, const Sources& sources, std::vector<glm::vec3>& rays,
             std::vector<glm::vec3>& arriving) const {
    columns_.each(slab, voxels_, [&](std::size_t ray, std::size_t place) {
      arriving[place] += rays[ray] / cuts_;
      rays[ray] += hidden_[place] * (sources.matter[place] - rays[ray]);
    });
  }

  const VoxelRows& voxels_;
  Columns columns_;
  float cuts_;                 ///< slabs of a slice
  std::vector<float> hidden_;  ///< of what is behind a voxel
};

/// A patch lit from all directions of the sky.
class Patch {
 public:
  Patch(const Scatterer& matter, const GroundBelow& ground, const Lighting& lighting)
      : matter_(matter),
        ground_(ground),
        voxels_(matter.shape, matter.voxel),
        sky_(sky_directions(lighting)) {
    sweeps_.reserve(sky_.size());
    for (const SkyDirection& sky : sky_) sweeps_.emplace_back(matter_, voxels_, sky);
  }

  /// What is scattered when nothing but the sun shines and what it meets scatters once.
  Sources first() const { return {matter_.sun_source, ground_.sun_irradiance}; }

  /// What is scattered of sun, sky and `before`.
  Sources next(const Sources& before) const {
    const std::vector<Arriving> arriving = all_arriving(before, /*with_sky=*/true);
    Sources sources = first();
    for (std::size_t i = 0; i < sky_.size(); ++i) {
      const float solid_angle = sky_[i].solid_angle;
      sources.on_ground +=
          arriving[i].on_ground * (solid_angle * static_cast<float>(sky_[i].direction.z));
      for (std::size_t v = 0; v < matter_.voxel.size(); ++v)
        sources.matter[v] += matter_.albedo[v] *
                             (arriving[i].from_above[v] + arriving[i].from_below[v]) *
                             (solid_angle / (4.0F * pi));
    }
    return sources;
  }

  /// The light on each voxel but the sun's and the sky's own.
  std::vector<DiffuseLight> light(const Sources& sources) const {
    const std::vector<Arriving> arriving = all_arriving(sources, /*with_sky=*/false);
    std::vector<DiffuseLight> light(matter_.voxel.size());
    parallel_for(light.size(), [&](std::size_t v) {
      for (std::size_t i = 0; i < sky_.size(); ++i) {
        const glm::vec3 direction(sky_[i].direction);
        const float solid_angle = sky_[i].solid_angle;
        light[v].add(direction, solid_angle * arriving[i].from_above[v]);
        light[v].add(-direction, solid_angle * arriving[i].from_below[v]);
      }
    });
    return light;
  }

 private:
  /// Radiance along one direction and against it.
  struct Arriving {
    std::vector<glm::vec3> from_above, from_below;
    glm::vec3 on_ground;
  };

  std::vector<Arriving> all_arriving(const Sources& sources, bool with_sky) const {
    std::vector<Arriving> all(sky_.size());
    parallel_for(sky_.size(), [&](std::size_t i) {
      Arriving& arriving = all[i];
      arriving.from_above.assign(matter_.voxel.size(), glm::vec3(0.0F));
      arriving.from_below.assign(matter_.voxel.size(), glm::vec3(0.0F));
      const glm::vec3 above = with_sky ? sky_[i].radiance : glm::vec3(0.0F);
      arriving.on_ground = sweeps_[i].down(above, sources, arriving.from_above);
      sweeps_[i].up(ground_.albedo / pi * sources.on_ground, sources, arriving.from_below);
    });
    return all;
  }

  const Scatterer& matter_;
  const GroundBelow& ground_;
  VoxelRows voxels_;
  std::vector<SkyDirection> sky_;
  std::vector<Sweep> sweeps_;
};

glm::vec3 sum(const std::vector<glm::vec3>& values) {
  glm::dvec3 result(0.0);
  for (const glm::vec3& value : values) result += glm::dvec3(value);
  return glm::vec3(result);
}

/// Adds to a series what its terms go on to: `step` is the last one, and each is `ratio` of the one
/// before.
void add_rest(glm::vec3& value, const glm::vec3& before, const glm::vec3& ratio) {
  value += (value - before) * ratio / (1.0F - ratio);
}

}  // namespace

ScatteredLight scattered_light(const Scatterer& matter, const GroundBelow& ground,
                               const Lighting& lighting) {
  constexpr int orders = 6;
  const Patch patch(matter, ground, lighting);
  Sources before, now = patch.first();
  glm::vec3 step(0.0F), step_before(0.0F);
  for (int order = 0; order < orders; ++order) {
    before = std::move(now);
    now = patch.next(before);
    step_before = step;
    step = sum(now.matter) - sum(before.matter);
  }
  constexpr float slowest = 0.9F;
  const glm::vec3 ratio = glm::clamp(step / glm::max(step_before, 1e-12F), 0.0F, slowest);
  for (std::size_t v = 0; v < now.matter.size(); ++v)
    add_rest(now.matter[v], before.matter[v], ratio);
  add_rest(now.on_ground, before.on_ground, ratio);
  return {patch.light(now), now.on_ground};
}

}  // namespace wold::grass
