#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace wold::grass {

/// What a blade is of its plant: a leaf, the stalk of a flower, or a petal or the disc of the
/// flower on the tip of the last stalk before it.
enum class Organ : std::uint8_t { leaf, stalk, petal, disc };

/// A blade of grass as it grows: a cone that stands on the patch and leans, and what sets it apart
/// from its neighbours when it withers. Metres, radians.
struct Blade {
  glm::vec2 root_m;            ///< on the patch, [0, patch)^2; a petal's may lie beside it
  float root_height_m = 0.0F;  ///< of a twig that it stands on, or of a petal's outer end
  glm::vec2 heading;           ///< unit, the horizontal direction it leans and droops to
  float lean = 0.0F;           ///< angle of the axis from the vertical at the root
  float length_m = 0.0F;
  float radius_m = 0.0F;        ///< of the cone at the root; 0 at the tip
  float keel_depth_m = 0.001F;  ///< of its fold, edges to keel
  float fresh_droop = 0.0F;     ///< droop coefficient of the living blade, rad / sqrt(m)
  float droop_rate = 0.0F;      ///< omega: droop gained per unit of lost support, rad / sqrt(m)
  float head_start = 0.0F;      ///< its own weathering degree while the meadow is fresh
  float onset = 0.0F;           ///< how far it is ahead (+) or behind (-) in weathering degree
  float brightness = 1.0F;      ///< factor on its albedo
  float lump_m = 0.045F;        ///< from lump to lump of the snow along it
  float lump_phase = 0.0F;      ///< where the first one lies, 0 to 1
  std::optional<glm::vec3> own_albedo =
      {};                   ///< of its own while fresh: that of the texel it is from
  std::uint64_t tufts = 0;  ///< key of where snow gathers, of all the blades of a variant
  int species = 0;          ///< its place in scene::species_of()
  Organ organ = Organ::leaf;
};

/// Whether it is of a flower, which sits on a stalk.
inline bool sits_on_stalk(const Blade& blade) {
  return blade.organ == Organ::petal || blade.organ == Organ::disc;
}

/// Which blades to scatter: so many on a patch, keyed by a seed, the patch's variant and the
/// sample, all from 0.
struct Scattering {
  double patch_m = 0.0;
  int blades = 0;
  std::uint64_t seed = 0;
  int variant = 0;
  int sample = 0;
};

/// Where a blade stands, metres on the patch.
inline glm::vec3 foot_m(const Blade& blade) { return {blade.root_m, blade.root_height_m}; }

/// Blades of a plant. Roots are stratified within the sample, one per cell of a grid, so that no
/// bald spot repeats over the hillside; everything is keyed by (seed, sample, variant, blade
/// number).
std::vector<Blade> scatter_blades(const scene::Plant& plant, const scene::Physiology& physiology,
                                  const Scattering& scattering);

/// The blade that has the mean of everything: no spread, no head start. It grows at the corner and
/// leans to the east.
Blade mean_blade(const scene::Plant& plant, const scene::Physiology& physiology);

/// How blades bow: turning about their roots ([TVT]), or as elastic blades under their weight.
using scene::DroopRule;

/// Segments between the points of a blade's vein that Algorithm 1 moves.
inline constexpr int vein_segments = 32;
/// Where those points are relative to the root, at equal distances along the blade, within its
/// vertical plane: (along heading, up), metres.
using VeinPlaces = std::array<glm::vec2, vein_segments + 1>;

/// How far a blade has withered, and what it bears.
struct BladePose {
  DroopRule rule = DroopRule::paper;
  float droop = 0.0F;            ///< c of [TVT]'s rule, rad / sqrt(m)
  float load = 0.0F;             ///< B of the heavy elastica (elastica.h)
  float length_scale = 1.0F;     ///< of arc lengths
  float vein_width = 1.0F;       ///< of distances from the axis, vein tissue
  float mesophyll_width = 1.0F;  ///< the same, mesophyll tissue
  float snow = 0.0F;             ///< fraction of the snow it can carry, 0 to 1
  /// Its axis as Algorithm 1 has moved it; none: the closed form of the rule.
  std::shared_ptr<const VeinPlaces> vein = {};
};

}  // namespace wold::grass
