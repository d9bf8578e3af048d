#include "grass/optics/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/texel/columns.h"
#include "grass/texel/voxel_set.h"

namespace wold::grass {
namespace {

using std::numbers::pi;
constexpr float recollision = 0.45F;

/// A world direction as the texel sees it that stands turned by `turn` quarter-turns.
glm::dvec3 turned_back(const glm::dvec3& direction, int turn) {
  glm::dvec3 result = direction;
  for (int i = 0; i < turn; ++i) result = {result.y, -result.x, result.z};
  return result;
}

float sine(const glm::vec3& a, const glm::vec3& b) {
  const float cosine = glm::dot(a, b);
  return std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
}

/// Rings of equal solid angle, that is of equal steps in the sine; their middles are taken in the
/// sine as well, which gives a horizontal plane its irradiance exactly.
std::vector<SkyRing> make_rings() {
  constexpr int count = 3;
  std::vector<SkyRing> rings;
  rings.reserve(count);
  for (int i = 0; i < count; ++i)
    rings.push_back({math::asin((i + 0.5) / count), 2.0 * pi / count / 4.0});
  return rings;
}

/// For every voxel of the texel the voxel of the volume that its centre lies in.
std::vector<std::uint32_t> places_in(const Texel& texel, const VolumeData& volume) {
  VoxelSet set(volume.shape);
  for (std::uint32_t voxel : volume.voxel) set.insert(voxel);
  set.number_members();
  const float scale = static_cast<float>(volume.shape.side) / static_cast<float>(texel.shape.side);
  std::vector<std::uint32_t> places(texel.size());
  for (std::size_t i = 0; i < texel.size(); ++i) {
    const glm::vec3 centre = glm::vec3(texel.shape.coordinates(texel.voxel[i])) + 0.5F;
    const glm::ivec3 at(centre * scale);
    places[i] = set.place(volume.shape.linear(at.x, at.y, at.z));
  }
  return places;
}

/// Slices of the texel on the way to the light that hold the blade itself: half its width.
int own_slices(const FibreLook& look, const glm::dvec3& light, const TexelShape& shape) {
  return static_cast<int>(std::lround(0.5 * look.width_m * light.z / shape.voxel_m)) + 1;
}

/// A grazing ray would be followed through grass for ever: a sun lower than this casts shadows as
/// from here, and once it has set it has no light.
glm::dvec3 risen(const glm::dvec3& sun_direction) {
  constexpr double lowest_sine = 0.0175;
  if (sun_direction.z >= lowest_sine) return sun_direction;
  const glm::dvec2 level = glm::normalize(glm::dvec2(sun_direction));
  return {level * std::sqrt(1.0 - lowest_sine * lowest_sine), lowest_sine};
}

}  // namespace

const std::vector<SkyRing>& sky_rings() {
  static const std::vector<SkyRing> rings = make_rings();
  return rings;
}

std::vector<SkyDirection> sky_directions(const Lighting& lighting) {
  std::vector<SkyDirection> directions;
  for (std::size_t ring = 0; ring < sky_rings().size(); ++ring)
    for (int i = 0; i < 4; ++i)
      directions.push_back(
          {direction_at(sky_rings()[ring].elevation, pi / 4.0 + pi / 2.0 * i),
           lighting.sky_radiance[ring] * static_cast<float>(sky_rings()[ring].solid_angle)});
  return directions;
}

Lighting make_lighting(const light::Daylight& daylight, const glm::dvec3& eye_direction) {
  Lighting lighting{risen(daylight.sun_direction()), daylight.sun_irradiance(), {}, eye_direction};
  for (const SkyRing& ring : sky_rings())
    lighting.sky_radiance.push_back(daylight.mean_sky_radiance(ring.elevation));
  return lighting;
}

float kajiya_kay_diffuse(const glm::vec3& tangent, const glm::vec3& light) {
  return sine(tangent, light) * (4.0F / std::numbers::pi_v<float>);
}

float kajiya_kay_specular(const glm::vec3& tangent, const glm::vec3& light, const glm::vec3& view,
                          float specular_exponent) {
  const float base = sine(tangent, light) * sine(tangent, view) -
                     glm::dot(tangent, light) * glm::dot(tangent, view);
  return math::pow(std::max(base, 0.0F), specular_exponent);
}

std::vector<glm::vec3> skylight(const Texel& texel, const VolumeData& occluder,
                                const Lighting& lighting, const FibreLook& look) {
  const VoxelRows voxels(occluder.shape, occluder.voxel);
  const std::vector<std::uint32_t> place = places_in(texel, occluder);
  const std::vector<SkyDirection> sky = sky_directions(lighting);
  std::vector<std::vector<float>> through(sky.size());
  parallel_for(sky.size(), [&](std::size_t i) {
    through[i] = voxel_transmittance(voxels, occluder.density, sky[i].direction,
                                     own_slices(look, sky[i].direction, occluder.shape));
  });
  std::vector<glm::vec3> sum(texel.size(), glm::vec3(0.0F));
  // Some voxels at a time, so that their sums stay in the processor's cache for all directions.
  constexpr std::size_t block = 4096;
  parallel_for((texel.size() + block - 1) / block, [&](std::size_t b) {
    const std::size_t end = std::min(texel.size(), (b + 1) * block);
    for (std::size_t i = 0; i < sky.size(); ++i) {
      const glm::vec3 towards(sky[i].direction);
      for (std::size_t v = b * block; v < end; ++v)
        sum[v] += sky[i].irradiance *
                  (through[i][place[v]] * kajiya_kay_diffuse(texel.tangent[v], towards));
    }
  });
  return sum;
}

TurnedLight::TurnedLight(const Lighting& lighting, int turn)
    : sun(turned_back(lighting.sun_direction, turn)),
      sun_irradiance(lighting.sun_irradiance),
      eye(turned_back(lighting.eye_direction, turn)) {}

glm::vec3 source_radiance(const Fibre& fibre, const TurnedLight& light, float sunlit,
                          const glm::vec3& skylight, float specular_exponent) {
  constexpr float per_sphere = 1.0F / (4.0F * std::numbers::pi_v<float>);
  const glm::vec3 towards(light.sun);
  const glm::vec3 direct = light.sun_irradiance * sunlit;
  const glm::vec3 received = direct * kajiya_kay_diffuse(fibre.tangent, towards) + skylight;
  const glm::vec3 scattered = fibre.albedo / (1.0F - recollision * fibre.albedo);
  const float highlight =
      fibre.specular * kajiya_kay_specular(fibre.tangent, towards, light.eye, specular_exponent);
  return per_sphere * (scattered * received + highlight * direct + fibre.specular * skylight);
}

std::vector<glm::vec3> bake_emission(const Texel& texel, const std::vector<float>& density,
                                     const std::vector<glm::vec3>& skylight,
                                     const Lighting& lighting, const FibreLook& look, int turn) {
  const TurnedLight light(lighting, turn);
  const std::vector<float> through =
      voxel_transmittance(VoxelRows(texel.shape, texel.voxel), density, light.sun,
                          own_slices(look, light.sun, texel.shape));
  std::vector<glm::vec3> emission(texel.size());
  for (std::size_t v = 0; v < texel.size(); ++v)
    emission[v] = source_radiance({texel.tangent[v], texel.albedo[v], texel.specular[v]}, light,
                                  through[v], skylight[v], look.specular_exponent);
  return emission;
}

}  // namespace wold::grass
