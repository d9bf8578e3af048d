#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "place/topography.h"
#include "scene/scene.h"

namespace wold::place {

/// Probability that grass grows at a place: growth.cover within the limits of slope, height and
/// mask, falling to 0 in a strip about each, which is wide on a large terrain. Throws FileError
/// when the mask cannot be read.
class GrowthLimits {
 public:
  /// Of the scene's terrain; `growth` is that of the scene or of a species.
  GrowthLimits(const scene::Scene& scene, const scene::Growth& growth);

  /// The probability on level ground: by cover, height and mask.
  double on_level(const glm::dvec2& at_m, double height_m) const;

  /// Whether a slope changes it.
  bool ask_for_slope() const { return growth_.steepest_deg < 90.0; }
  /// What of the probability on level ground is left on a slope.
  double on_slope(double slope_deg) const;

 private:
  class Mask;

  scene::Growth growth_;
  double slope_strip_deg_, height_strip_m_;
  std::shared_ptr<const Mask> mask_;  ///< if any
};

/// Noise whose values are uniform in (0, 1), in tufts of a size: what is less likely than it is
/// bare there.
class Tufts {
 public:
  Tufts(const Fbm& field, double feature_m) : field_(field), feature_m_(feature_m) {}

  double at(const glm::dvec2& at_m) const;

  /// The same tufts in groups: many here, few there. Groups have all sizes from 4 to 128 of theirs
  /// that are at most `largest_m`; there are none where that is less than 4.
  Tufts in_groups(std::uint64_t key, double largest_m) &&;

 private:
  Fbm field_;
  double feature_m_;
  double largest_group_m_ = 0.0;
  std::optional<Fbm> groups_;
};

/// Where those of a meadow's species grow that have a habitat, in their order; the terrain has to
/// outlive it. Each has keyed tufts of its own. Throws FileError when a mask cannot be read.
class Habitats {
 public:
  Habitats(const scene::Scene& scene, const Heightfield& terrain);

  int count() const { return static_cast<int>(species_.size()); }

  /// Probability that one of them grows at a place.
  double probability(int species, const glm::dvec2& at_m) const;

  /// How much more likely that is than the species' tufts have it: it grows where this is positive.
  double excess(int species, const glm::dvec2& at_m) const;

  /// Probability that any species of the meadow grows: the sum of all, 1 at most. Always 1 where
  /// one has no habitat.
  double any(const glm::dvec2& at_m) const;

 private:
  struct Placed {
    scene::Habitat habitat;
    GrowthLimits limits;
    Tufts tufts;
  };

  const Heightfield& terrain_;
  std::shared_ptr<const Topography> topography_;  ///< if any species asks for it
  std::vector<Placed> species_;
  bool some_everywhere_;
};

}  // namespace wold::place
