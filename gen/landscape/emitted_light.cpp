#include "landscape/emitted_light.h"

#include <utility>

#include "core/colour.h"

namespace wold::landscape {
namespace {

float relative_luminance(const glm::vec3& rgb) { return static_cast<float>(luminance(rgb)); }

std::vector<float> emitted_luminance(std::span<const float> extinction_per_m,
                                     std::span<const glm::vec3> radiance) {
  std::vector<float> emitted(extinction_per_m.size());
  for (std::size_t i = 0; i < emitted.size(); ++i)
    emitted[i] = extinction_per_m[i] * relative_luminance(radiance[i]);
  return emitted;
}

/// Colours of luminance 1; black where it is dark.
std::vector<glm::vec3> colours_of(std::vector<glm::vec3> radiance) {
  for (glm::vec3& value : radiance)
    if (const float luminance = relative_luminance(value); luminance > 0.0F) value /= luminance;
  return radiance;
}

}  // namespace

EmittedLight emitted_light(std::span<const float> extinction_per_m, std::vector<glm::vec3> radiance,
                           glm::ivec3 voxels) {
  EmittedLight light;
  light.luminance_per_m = emitted_luminance(extinction_per_m, radiance);
  light.colours = coarse_colours(light.luminance_per_m, colours_of(std::move(radiance)), voxels);
  return light;
}

}  // namespace wold::landscape
