#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/ground_map.h"
#include "scene/scene.h"

namespace wold::terrain {

/// The land around a scene's square, out to a distance: squares about it, each three times as wide
/// as the one before and as much coarser. Heights are metres above the scene's zero, places metres
/// from its south-western corner.
///
/// They are those of the scene's ground where that is, then of terrain.elevation as far as it
/// reaches, then of terrain.surroundings. Where nobody knows them the land goes on as high as its
/// border, and rises and falls as the scene's ground does (MadeUpLand). The earth is flat here.
///
/// Land that nobody knows is made when it is first asked for: most of a second of work, and many
/// frames never see it. Any thread may ask.
class Surroundings {
 public:
  /// `ground`: the scene's. The land reaches `reach_m` beyond it at least. Throws InputError as
  /// heights_around(), and where terrain.surroundings has no land in common with the square and
  /// what terrain.elevation has next to it.
  Surroundings(const scene::Terrain& terrain, const Heightfield& ground, std::uint64_t seed,
               double reach_m);

  /// The scene's square.
  const Square& square() const { return square_; }
  /// How far the land reaches beyond the scene's square.
  double reach_m() const { return reach_m_of(rings().back()); }
  /// Steps between known heights at a place.
  double step_m(const glm::dvec2& at_m) const { return rings()[ring_of(at_m)].step_m(); }

  double height_m(const glm::dvec2& at_m) const;
  /// Upward unit normal, by differences over two steps.
  glm::dvec3 up(const glm::dvec2& at_m) const;

 private:
  /// Fine to coarse; the scene's square is in the middle of each.
  using Rings = std::vector<Heightfield>;

  /// What rings are made of.
  struct Plan {
    scene::Terrain terrain;
    Heightfield ground;
    std::uint64_t seed;
    double reach_m;
  };

  Rings make(const Plan& plan) const;
  const Rings& rings() const;
  double reach_m_of(const Heightfield& ring) const {
    return 0.5 * (ring.size_m() - square_.size_m);
  }
  std::size_t ring_of(const glm::dvec2& at_m) const;

  Square square_;
  mutable std::once_flag made_;
  mutable std::unique_ptr<const Plan> plan_;  ///< until rings are made
  mutable Rings rings_;
};

}  // namespace wold::terrain
