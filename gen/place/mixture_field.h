#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/ground_map.h"
#include "place/habitat.h"
#include "scene/scene.h"

namespace wold::place {

/// Which mixture of the meadow's species stands at a place, by its number in scene::mixtures_of().
///
/// A species with a habitat stands where its probability is above its own noise, so that a border
/// is a strip of patches; the others stand everywhere. Where that leaves none, the likeliest does.
class MixtureField {
 public:
  /// Throws FileError when a mask cannot be read.
  MixtureField(const scene::Scene& scene, const Heightfield& terrain);

  int at(const glm::dvec2& at_m) const;

  /// Those that at() may give, ascending: found at 257 places along a side of the terrain, and as
  /// many of the CellWindow, and what grows around the shrubs of these. Elsewhere what would be
  /// another is the one of them that differs from it in the fewest species.
  const std::vector<int>& present() const { return present_; }

 private:
  int wanted(const glm::dvec2& at_m) const;
  void find_present(const Square& square);
  void add_present_without_shrubs(const scene::Scene& scene);

  std::shared_ptr<const Heightfield> terrain_;  ///< that habitats_ refer to; none without them
  std::shared_ptr<const Habitats> habitats_;
  int mixtures_;
  std::vector<int> present_ = {0};
  std::vector<int> instead_ = {0};  ///< by the mixture that is wanted
};

}  // namespace wold::place
