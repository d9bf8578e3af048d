#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "grass/optics/shading.h"
#include "meadow/turned_blade.h"
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

  /// Radiance that leaning fibres send to an eye, over that of upright ones to the baked eye. Both
  /// in half the sun and half the sky. `lean` is WindLean's, `to_eye` unit.
  glm::vec3 factor(const glm::dvec2& lean, const glm::dvec3& to_eye) const;

  /// The same of grass that was combed to `combed` and leans as `lean` for a moment: that of combed
  /// grass, times what the wind makes of what the eye sees of it. What the wind has bent shows its
  /// broad side (TurnedBlade), tips hide what is below them, and the sun reaches sunlit_share()
  /// over that of combed grass.
  glm::vec3 factor(const glm::dvec2& lean, const glm::dvec2& combed,
                   const glm::dvec3& to_eye) const;

  /// Of what an eye sees of a dense canopy of such fibres, the part that the sun reaches: with
  /// optical depths k per leaf area towards sun and eye, k_eye / (k_eye + k_sun), k = G / cosine of
  /// the zenith angle, G a fibre's mean projection ([Ross1981]). Where blades lean to the sun it
  /// shines in more deeply: waves are bright that way.
  double sunlit_share(const glm::dvec2& lean, const glm::dvec2& combed,
                      const glm::dvec3& to_eye) const;

  /// Mean radiance of the upright ones to the baked eye.
  const glm::vec3& upright() const { return upright_; }

 private:
  /// Mean radiance of blades towards an eye.
  struct Seen {
    glm::vec3 all;   ///< where none hides another
    glm::vec3 tips;  ///< where tips hide what is below them, as in a canopy
  };
  Seen seen(std::span<const TurnedBlade> blades, const glm::dvec3& to_eye, float sunlit) const;
  double sunlit_share(std::span<const TurnedBlade> blades, const glm::dvec3& to_eye) const;

  std::vector<grass::Fibre> fibres_;
  grass::Lighting lighting_;
  grass::DiffuseLight diffuse_;  ///< on each fibre
  float specular_exponent_;
  glm::vec3 upright_;
};

/// The factor everywhere on the terrain: it makes the waves visible, silvery where blades lie so
/// that they mirror the sun.
ColourMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view);
/// The same on another grid.
ColourMap lean_light_map(const LeanLight& light, const WindLean& wind_lean,
                         const Heightfield& terrain, const place::View& view,
                         const GroundGrid& grid);

}  // namespace wold::meadow
