#pragma once

#include <cstdint>

#include "core/ground_map.h"
#include "core/row_parts.h"
#include "light/daylight.h"
#include "scene/scene.h"

namespace wold::terrain {

class LandShadow;
class Surface;

/// The light that falls on the ground, relative to flat open ground, per channel: the sun's
/// irradiance by Lambert's law with a soft cast shadow, and the sky's radiance above the local
/// horizon. The daylight's unit makes both together 1 on flat open ground. A sample every 20 cm,
/// or every half step of the terrain where that is more (4097 a side at most), smoothed over the
/// height of grass, so that a shadow's edge is about half a metre, or two such steps, wide.
struct GroundLight {
  ColourMap sun;
  ColourMap sky;
  FactorMap overcast;  ///< instead of both, under a sky three times as bright overhead as at the
                       ///< horizon and without colour (CIE S 011:2003, type 1)

  ColourMap together() const;
};
/// `around`: what land around the terrain takes of the sun; null takes nothing.
GroundLight ground_light(const Heightfield& terrain, const light::Daylight& day,
                         const LandShadow* around = nullptr);
/// The same on another grid, smoothed over one of its steps or, where its values are to be single
/// ones of a finer map, not at all. `parts`: of the grid's rows, what counts; empty: all. It is
/// dark elsewhere, and less light than there is lies beside that.
GroundLight ground_light(const Heightfield& terrain, const light::Daylight& day,
                         const GroundGrid& grid, const LandShadow* around = nullptr,
                         const RowParts& parts = {}, bool smoothed = true);

/// Albedo of clear water by what it scatters back: less than 5 % of the light, most of it blue and
/// green ([Mobley1994], irradiance reflectances of lakes).
inline constexpr glm::vec3 water_albedo(0.010F, 0.026F, 0.032F);

/// What the bare ground makes of the light that falls on it: radiance over irradiance, albedo / pi.
///
/// The albedo varies about terrain.ground_albedo: moist hollows and litter (keyed fBm), detail down
/// to the grid's step, what is smaller shows its mean; beyond terrain.rock_slope it turns to rock,
/// whose relief the sun shows. Scree is stones of that rock. Where grass grows, `growth` in [0, 1],
/// the ground is soil. Where land cover or a photo has a colour, the ground has it beside the
/// grass, with the detail of its soil or rock. Water has what comes back out of it, without what
/// its surface mirrors. Places that do not count are black.
ColourMap ground_reflectance(const Surface& surface, const glm::dvec3& sun_direction,
                             const scene::Terrain& look, std::uint64_t seed,
                             const FactorMap& growth);

}  // namespace wold::terrain
