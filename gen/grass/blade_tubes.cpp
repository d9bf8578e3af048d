#include "grass/blade_tubes.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "core/parallel.h"
#include "grass/blade_picture.h"

namespace wold::grass {
namespace {

constexpr int segments = 16;
constexpr int corners = 3;
/// Pixels of the shadow pictures along a patch of 0.6 m: half a millimetre each.
constexpr double shadow_pixel_m = 5e-4;

/// A place of a blade's axis: where, which way, and how thick.
struct Station {
  glm::vec3 position_m;
  glm::vec3 tangent;
  float radius_m;
  float along;
};

std::vector<Station> stations(const Blade& blade, const BladePose& pose) {
  const float length_m = blade.length_m * pose.length_scale;
  const BladeAxis axis(blade, pose);
  std::vector<Station> result;
  for (int i = 0; i <= segments; ++i) {
    const float along = static_cast<float>(i) / segments;
    const AxisPoint at = axis.at(length_m * along);
    result.push_back({{blade.root_m + blade.heading * at.position_m.x, at.position_m.y},
                      {blade.heading * at.tangent.x, at.tangent.y},
                      blade.radius_m * pose.mesophyll_width * (1.0F - along),
                      along});
  }
  return result;
}

void append_ring(const Blade& blade, const Station& at, std::vector<glm::vec3>& vertices_m) {
  constexpr float pi = std::numbers::pi_v<float>;
  const float reach = at.radius_m * pi / (corners * std::sin(pi / corners));
  const glm::vec3 across(-blade.heading.y, blade.heading.x, 0.0F);
  const glm::vec3 side = glm::cross(across, at.tangent);
  for (int corner = 0; corner < corners; ++corner) {
    const float angle = 2.0F * pi * static_cast<float>(corner) / corners;
    vertices_m.push_back(at.position_m +
                         reach * (std::cos(angle) * across + std::sin(angle) * side));
  }
}

/// Which of the light from one direction reaches the blades.
class Shadows {
 public:
  Shadows(const BladePatch& patch, const glm::dvec3& direction)
      : direction_(direction),
        picture_(patch, direction,
                 std::clamp(static_cast<int>(patch.patch_m / shadow_pixel_m), 64, 4096)) {}

  /// Share of a blade's width at a station that is not in shadow.
  float reaching(const Station& at, std::uint32_t blade) const {
    const glm::vec3 across = glm::cross(at.tangent, direction_);
    const float sine = glm::length(across);
    const glm::vec3 step = sine > 1e-3F ? across * (at.radius_m / sine) : glm::vec3(0.0F);
    int lit = 0;
    for (const float offset : {-0.75F, -0.25F, 0.25F, 0.75F})
      if (!picture_.hides(at.position_m + offset * step, blade)) ++lit;
    return static_cast<float>(lit) / 4.0F;
  }

 private:
  glm::vec3 direction_;
  BladePicture picture_;
};

}  // namespace

Tubes blade_tubes(const BladePatch& patch, const AgeingModel& model, const Lighting& lighting,
                  const FibreLook& look, int turn) {
  const TurnedLight light(lighting, turn);
  std::vector<std::vector<Station>> axes;
  for (std::size_t i = 0; i < patch.blades.size(); ++i)
    axes.push_back(stations(patch.blades[i], patch.poses[i]));
  // One picture at a time: the sun, then every direction of the sky.
  const std::size_t rings = segments + 1;
  std::vector<float> sunlit(patch.blades.size() * rings);
  std::vector<glm::vec3> skylight(sunlit.size(), glm::vec3(0.0F));
  const auto each_station = [&](const glm::dvec3& direction, const auto& visit) {
    const Shadows shadows(patch, direction);
    parallel_for(axes.size(), [&](std::size_t i) {
      for (std::size_t ring = 0; ring < rings; ++ring) {
        const Station& at = axes[i][ring];
        visit(i * rings + ring, at, shadows.reaching(at, static_cast<std::uint32_t>(i)));
      }
    });
  };
  each_station(light.sun,
               [&](std::size_t ring, const Station&, float share) { sunlit[ring] = share; });
  for (const SkyDirection& sky : sky_directions(lighting))
    each_station(sky.direction, [&](std::size_t ring, const Station& at, float share) {
      skylight[ring] +=
          sky.irradiance * (share * kajiya_kay_diffuse(at.tangent, glm::vec3(sky.direction)));
    });
  Tubes tubes{static_cast<int>(rings), corners, {}, {}};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Blade& blade = patch.blades[i];
    const float specular = model.specular(patch.ages[i]);
    for (const Station& at : axes[i]) {
      append_ring(blade, at, tubes.vertices_m);
      const std::size_t ring = tubes.radiance.size();
      const Fibre fibre{at.tangent, model.albedo(blade, patch.ages[i], double{at.along}), specular};
      tubes.radiance.push_back(
          source_radiance(fibre, light, sunlit[ring], skylight[ring], look.gloss));
    }
  }
  return tubes;
}

}  // namespace wold::grass
