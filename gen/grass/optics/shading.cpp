#include "grass/optics/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/optics/leaf_phase.h"
#include "grass/texel/columns.h"

namespace wold::grass {
namespace {

using std::numbers::pi;

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

constexpr std::size_t sides = 4;

/// The direction that lies `fraction` of the way through a quarter of a ring.
glm::dvec3 on_ring(const SkyRing& ring, std::size_t side, double fraction) {
  return direction_at(ring.elevation, pi / 2.0 * (static_cast<double>(side) + fraction));
}

/// Slices of the texel on the way to the light that hold the blade itself: half its width.
int own_slices(const FibreLook& look, const glm::dvec3& light, const TexelShape& shape) {
  return static_cast<int>(std::lround(0.5 * look.width_m * light.z / shape.voxel_m)) + 1;
}

Beside beside(const FibreLook& look, const TexelShape& shape) {
  return {static_cast<int>(std::lround(look.neighbours_m / shape.voxel_m)), look.like_neighbours};
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

std::size_t sky_size() { return sky_rings().size() * sides; }

std::vector<SkyDirection> sky_directions(const Lighting& lighting) {
  std::vector<SkyDirection> directions;
  for (const SkyRing& ring : sky_rings())
    for (std::size_t side = 0; side < sides; ++side)
      directions.push_back({on_ring(ring, side, 0.5), static_cast<float>(ring.solid_angle),
                            lighting.sky_radiance.at(directions.size())});
  return directions;
}

std::vector<glm::vec3> mean_sky(const light::Daylight& daylight) {
  constexpr int samples = 8;
  std::vector<glm::vec3> radiance;
  for (const SkyRing& ring : sky_rings())
    for (std::size_t side = 0; side < sides; ++side) {
      glm::vec3 sum(0.0F);
      for (int i = 0; i < samples; ++i)
        sum += daylight.sky_radiance(on_ring(ring, side, (i + 0.5) / samples));
      radiance.push_back(sum / static_cast<float>(samples));
    }
  return radiance;
}

Lighting make_lighting(const light::Daylight& daylight, const glm::dvec3& eye_direction,
                       const glm::vec3& ground_albedo) {
  return {risen(daylight.sun_direction()), daylight.sun_irradiance(), mean_sky(daylight),
          eye_direction, ground_albedo};
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

Lighting turned(const Lighting& lighting, int turn) {
  Lighting result = lighting;
  result.sun_direction = turned_back(lighting.sun_direction, turn);
  result.eye_direction = turned_back(lighting.eye_direction, turn);
  for (std::size_t i = 0; i < result.sky_radiance.size(); ++i) {
    const std::size_t side = (i % sides + static_cast<std::size_t>(turn)) % sides;
    result.sky_radiance[i] = lighting.sky_radiance[i / sides * sides + side];
  }
  return result;
}

std::vector<std::vector<float>> sky_transmittances(const VolumeData& volume,
                                                   const FibreLook& look) {
  const VoxelRows voxels(volume.shape, volume.voxel);
  std::vector<std::vector<float>> through(sky_size());
  parallel_for(through.size(), [&](std::size_t i) {
    const glm::dvec3 direction = on_ring(sky_rings()[i / sides], i % sides, 0.5);
    through[i] =
        voxel_transmittance(voxels, volume.density, direction,
                            own_slices(look, direction, volume.shape), beside(look, volume.shape));
  });
  return through;
}

std::vector<DiffuseLight> skylight(const std::vector<std::vector<float>>& through,
                                   const Lighting& lighting) {
  const std::vector<SkyDirection> sky = sky_directions(lighting);
  std::vector<DiffuseLight> light(through.front().size());
  parallel_for(light.size(), [&](std::size_t v) {
    for (std::size_t i = 0; i < sky.size(); ++i)
      light[v].add(glm::vec3(sky[i].direction), through[i][v] * sky[i].irradiance());
  });
  return light;
}

std::vector<float> sunlit_fractions(const VolumeData& volume, const Lighting& lighting,
                                    const FibreLook& look, int turn) {
  const glm::dvec3 sun = TurnedLight(lighting, turn).sun;
  return voxel_transmittance(VoxelRows(volume.shape, volume.voxel), volume.density, sun,
                             own_slices(look, sun, volume.shape), beside(look, volume.shape));
}

TurnedLight::TurnedLight(const Lighting& lighting, int turn)
    : sun(turned_back(lighting.sun_direction, turn)),
      sun_irradiance(lighting.sun_irradiance),
      eye(turned_back(lighting.eye_direction, turn)) {}

float highlight_albedo(float specular_exponent) {
  // The integral of cos^p from -pi / 2 to pi / 2, within 1 % for p of 4 or more.
  const float lobe = std::sqrt(2.0F * std::numbers::pi_v<float> / (specular_exponent + 0.5F));
  return std::numbers::pi_v<float> / 8.0F * lobe;
}

glm::vec3 mirrored_fraction(const Fibre& fibre, float specular_exponent) {
  const glm::vec3 reflectance = fibre.albedo - fibre.transmittance;
  return glm::min(glm::vec3(fibre.specular * highlight_albedo(specular_exponent)), reflectance);
}

glm::vec3 source_radiance(const Fibre& fibre, const TurnedLight& light, float sunlit,
                          const DiffuseLight& diffuse, float specular_exponent) {
  constexpr float per_sphere = 1.0F / (4.0F * std::numbers::pi_v<float>);
  const glm::vec3 towards(light.sun);
  const glm::vec3 direct = light.sun_irradiance * sunlit;
  const glm::vec3 sunlight = direct * kajiya_kay_diffuse(fibre.tangent, towards);
  const LeafPhase phase = leaf_phase(fibre.tangent, towards, light.eye);
  const LeafShare share = leaf_share(diffuse, fibre.tangent, light.eye);
  const glm::vec3 reflectance = fibre.albedo - fibre.transmittance;
  const glm::vec3 mirrored = mirrored_fraction(fibre, specular_exponent);
  const float mirror = kajiya_kay_specular(fibre.tangent, towards, light.eye, specular_exponent) /
                       highlight_albedo(specular_exponent);
  return per_sphere * ((reflectance - mirrored) * (phase.reflected * sunlight + share.reflected) +
                       fibre.transmittance * (phase.transmitted * sunlight + share.transmitted) +
                       mirrored * (mirror * direct + share.taken));
}

glm::vec3 scattered_sunlight(const Fibre& fibre, const TurnedLight& light, float sunlit) {
  const float taken = sunlit * kajiya_kay_diffuse(fibre.tangent, glm::vec3(light.sun));
  return fibre.albedo * light.sun_irradiance * (taken / (4.0F * std::numbers::pi_v<float>));
}

}  // namespace wold::grass
