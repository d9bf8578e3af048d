#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "grass/mechanics/meadow_model.h"
#include "grass/optics/shading.h"
#include "grass/optics/shared_gaps.h"
#include "grass/texel/volume_data.h"
#include "meadow/lean_light.h"
#include "reference/canopy_scene.h"

namespace wold::test {

/// The texels of canopy_scene.h under one sun at one weathering degree, baked as they are for
/// films.
class CanopyTexels {
 public:
  CanopyTexels(double sun_deg, double weathering);

  std::size_t lods() const { return scene_.grass.lods.size(); }

  /// Radiance of grass and ground times pi, of a level of detail from a unit direction.
  glm::dvec3 seen(std::size_t lod, const glm::dvec3& towards_eye) const;

 private:
  glm::dvec3 seen(const grass::VolumeData& volume, const glm::dvec3& towards_eye,
                  const glm::dvec3& factor) const;
  glm::dvec3 ground(const glm::dvec3& towards_eye) const;

  scene::Scene scene_;
  grass::MeadowModel model_;
  grass::Lighting lighting_;
  meadow::LeanLight lean_light_;
  glm::vec3 under_grass_;
  grass::SharedGaps shared_gaps_;
  std::vector<std::vector<grass::VolumeData>> variants_;
};

}  // namespace wold::test
