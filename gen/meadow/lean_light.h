#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "grass/optics/shading.h"
#include "meadow/wind_lean.h"
#include "place/view.h"
#include "scene/scene.h"

namespace wold::meadow {

/// What the grass's lean does to its light: patches are lit for blades as they grow and for one
/// eye.
class LeanLight {
 public:
  /// `fibres` stand for the meadow; `lighting` is what its patches were baked for.
  LeanLight(std::vector<grass::Fibre> fibres, grass::Lighting lighting, float specular_exponent);

  /// Luminance that leaning fibres send to an eye, over that of upright ones to the baked eye. Both
  /// in half the sun and half the sky. `lean` is WindLean's, `to_eye` unit.
  float factor(const glm::dvec2& lean, const glm::dvec3& to_eye) const;

  /// Radiance of the upright ones, all together, to the baked eye.
  const glm::vec3& upright() const { return upright_; }

 private:
  glm::vec3 radiance(const glm::dvec2& lean, const glm::dvec3& to_eye) const;

  std::vector<grass::Fibre> fibres_;
  grass::Lighting lighting_;
  glm::vec3 skylight_;
  float specular_exponent_;
  glm::vec3 upright_;
};

/// The factor everywhere on the terrain: it makes the waves visible, silvery where blades lie so
/// that they mirror the sun.
FactorMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view);
/// The same on another grid.
FactorMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view,
                         const GroundGrid& grid);

}  // namespace wold::meadow
