#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "core/noise.h"
#include "phenology/film_season.h"
#include "scene/scene.h"
#include "wind/canopy_motion.h"

namespace wold::meadow {

/// How the wind has combed the meadow: blades lean with it, more in some strips than in others,
/// like waves that stand. The field is smooth, so that neighbouring patches lean nearly alike. In a
/// season it leans with the wind of the week before, the more the faster that was; the waves keep
/// their places. Grass that waves leans further under the wind of the moment: loads add up.
class WindLean {
 public:
  /// `change`: of the wind that has combed it, from `wind`. `seed`: the scene's. `motion`: what the
  /// wind of the moment adds, none where grass stands still.
  WindLean(const scene::Wind& wind, const phenology::WindChange& change, std::uint64_t seed,
           std::shared_ptr<const wind::CanopyMotion> motion = nullptr);

  /// Metres to the east and north by which the grass at a place leans over per metre of height.
  glm::dvec2 lean(const glm::dvec2& at_m) const;

  /// The same without the wind of the moment.
  glm::dvec2 combed(const glm::dvec2& at_m) const;

 private:
  scene::Wind wind_;
  phenology::WindChange change_;
  Fbm waves_;
  Fbm turns_;
  std::shared_ptr<const wind::CanopyMotion> motion_;
};

}  // namespace wold::meadow
