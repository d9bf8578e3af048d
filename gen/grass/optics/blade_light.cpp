#include "grass/optics/blade_light.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "grass/optics/blade_picture.h"
#include "grass/optics/scattered_light.h"
#include "grass/texel/voxel_set.h"

namespace wold::grass {
namespace {

/// Which of the light from one direction reaches the blades.
class Shadows {
 public:
  Shadows(const std::vector<Piece>& pieces, double patch_m, const glm::dvec3& direction,
          double pixel_m)
      : direction_(direction),
        picture_(pieces, patch_m, direction,
                 std::clamp(static_cast<int>(patch_m / pixel_m), 64, 4096)) {}

  /// Fraction of the light that passes between the blades.
  double passing() const { return 1.0 - picture_.coverage(); }

  /// Fraction of a blade's width at a place that is not in shadow.
  float reaching(const BladePlace& place) const {
    const glm::vec3 across = glm::cross(place.fibre.tangent, direction_);
    const float sine = glm::length(across);
    const glm::vec3 step = sine > 1e-3F ? across * (place.radius_m / sine) : glm::vec3(0.0F);
    int lit = 0;
    for (const float offset : {-0.75F, -0.25F, 0.25F, 0.75F})
      if (!picture_.hides(place.position_m + offset * step, place.blade)) ++lit;
    return static_cast<float>(lit) / 4.0F;
  }

 private:
  glm::vec3 direction_;
  BladePicture picture_;
};

/// The places as a coarse texel: which voxel each is in, and what the voxels are.
class CoarseTexel {
 public:
  CoarseTexel(double patch_m, std::span<const BladePlace> places) : in_(places.size()) {
    constexpr int side = scattering_side;
    float top_m = 0.0F;
    for (const BladePlace& place : places) top_m = std::max(top_m, place.position_m.z);
    matter_.shape = {side, 1 + static_cast<int>(top_m * side / patch_m), patch_m / side};
    VoxelSet voxels(matter_.shape);
    for (const BladePlace& place : places) voxels.insert(voxel_at(place.position_m));
    matter_.voxel = voxels.number_members();
    for (std::size_t i = 0; i < places.size(); ++i)
      in_[i] = voxels.place(voxel_at(places[i].position_m));
  }

  std::size_t voxel_of(std::size_t place) const { return in_[place]; }

  /// The places as matter, each of which sends `sun_source` of the sun's light to all sides.
  Scatterer matter(std::span<const BladePlace> places,
                   std::span<const glm::vec3> sun_source) const {
    Scatterer result = matter_;
    const std::size_t size = result.voxel.size();
    result.extinction_per_m.resize(size);
    result.albedo.resize(size);
    result.sun_source.resize(size);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const float area_m2 = places[i].area_m2;
      result.extinction_per_m[in_[i]] += area_m2;
      result.albedo[in_[i]] += area_m2 * places[i].fibre.albedo;
      result.sun_source[in_[i]] += area_m2 * sun_source[i];
    }
    for (std::size_t v = 0; v < size; ++v) {
      const float area_m2 = std::max(result.extinction_per_m[v], 1e-12F);
      result.albedo[v] /= area_m2;
      result.sun_source[v] /= area_m2;
      result.extinction_per_m[v] /= static_cast<float>(result.shape.voxel_volume_m3());
    }
    return result;
  }

 private:
  std::uint32_t voxel_at(const glm::vec3& position_m) const {
    const TexelShape& shape = matter_.shape;
    const glm::ivec3 at(glm::floor(glm::dvec3(position_m) / shape.voxel_m));
    return shape.linear(shape.wrapped(at.x), shape.wrapped(at.y),
                        std::clamp(at.z, 0, shape.height - 1));
  }

  Scatterer matter_;  ///< shape and voxels alone
  std::vector<std::size_t> in_;
};

}  // namespace

PlaceLight place_light(const BladePatch& patch, std::span<const BladePlace> places,
                       const Lighting& lighting, double shadow_pixel_m) {
  const TurnedLight light(lighting, /*turn=*/0);
  const std::vector<Piece> pieces = BladePicture::pieces_of(patch);
  PlaceLight result{
      std::vector<float>(places.size()), std::vector<DiffuseLight>(places.size()), {}};
  const Shadows of_sun(pieces, patch.patch_m, light.sun, shadow_pixel_m);
  parallel_for(places.size(),
               [&](std::size_t i) { result.sunlit[i] = of_sun.reaching(places[i]); });
  // One picture at a time.
  for (const SkyDirection& sky : sky_directions(lighting)) {
    const Shadows of_sky(pieces, patch.patch_m, sky.direction, shadow_pixel_m);
    parallel_for(places.size(), [&](std::size_t i) {
      result.diffuse[i].add(glm::vec3(sky.direction),
                            of_sky.reaching(places[i]) * sky.irradiance());
    });
  }
  std::vector<glm::vec3> sun_source;
  for (std::size_t i = 0; i < places.size(); ++i)
    sun_source.push_back(scattered_sunlight(places[i].fibre, light, result.sunlit[i]));
  const CoarseTexel texel(patch.patch_m, places);
  const glm::vec3 sun_on_ground =
      light.sun_irradiance * static_cast<float>(light.sun.z * of_sun.passing());
  const ScatteredLight scattered = scattered_light(
      texel.matter(places, sun_source), {lighting.ground_albedo, sun_on_ground}, lighting);
  for (std::size_t i = 0; i < places.size(); ++i)
    result.diffuse[i].add(scattered.on_matter[texel.voxel_of(i)]);
  result.on_ground = scattered.on_ground;
  return result;
}

std::vector<glm::vec3> place_radiance(const BladePatch& patch, std::span<const BladePlace> places,
                                      const Lighting& lighting, const FibreLook& look,
                                      double shadow_pixel_m) {
  const TurnedLight turned(lighting, /*turn=*/0);
  const PlaceLight light = place_light(patch, places, lighting, shadow_pixel_m);
  std::vector<glm::vec3> radiance;
  for (std::size_t i = 0; i < places.size(); ++i)
    radiance.push_back(source_radiance(places[i].fibre, turned, light.sunlit[i], light.diffuse[i],
                                       look.specular_exponent));
  return radiance;
}

}  // namespace wold::grass
