#pragma once

#include <atomic>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/highest_around.h"
#include "terrain/made_up_land.h"

namespace wold::terrain {

/// The land around a scene's square, out to a distance: squares about it, each three times as wide
/// as the one before and as much coarser. Heights are metres above the scene's zero, places metres
/// from its south-western corner.
///
/// They are those of the scene's ground where that is, then of terrain.elevation as far as it
/// reaches, then of terrain.surroundings. Where nobody knows them the land goes on as high as its
/// border, and rises and falls as the scene's ground does (MadeUpLand). So does what is finer than
/// the steps between known heights. The earth is flat here.
///
/// Without models all of it is made when it is first asked for: a second of work, and many frames
/// never see it. With them it is made at once. Any thread may ask.
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
  double reach_m() const { return reach_m_of(land().rings.back().map.size_m()); }
  /// Steps between the heights that are kept at a place.
  double step_m(const glm::dvec2& at_m) const { return land().rings[ring_of(at_m)].map.step_m(); }

  /// Height between those that are kept, without anything finer.
  double coarse_height_m(const glm::dvec2& at_m) const;
  /// Height with the finer features that a map with steps of `shown_m` shows, down to an eighth of
  /// the steps between kept heights; higher ones where the land is steep.
  double height_m(const glm::dvec2& at_m, double shown_m = 0.0) const;
  /// A bound, metres: neither of the two heights at a place is above it, whatever is shown. It is
  /// found in a fraction of their time.
  double highest_m(const glm::dvec2& at_m) const;
  /// The same bound for all places.
  double highest_m() const { return land().highest_m; }
  /// Upward unit normal of that land, by differences over two of those steps.
  glm::dvec3 up(const glm::dvec2& at_m, double shown_m) const;

 private:
  /// The land in one square.
  struct Ring {
    Heightfield map;
    double slope;           ///< its mean, rise per distance
    HighestAround highest;  ///< of the map alone
    double most_finer_m;    ///< finer features are nowhere higher
  };
  struct Land {
    MadeUpLand made_up;
    std::vector<Ring> rings;  ///< fine to coarse; the scene's square is in the middle of each
    double highest_m;         ///< no height is above it
  };

  /// What rings are made of.
  struct Plan {
    scene::Terrain terrain;
    Heightfield ground;
    std::uint64_t seed;
    double reach_m;
  };

  Land make(const Plan& plan) const;
  const Land& land() const;
  double reach_m_of(double ring_m) const { return 0.5 * (ring_m - square_.size_m); }
  std::size_t ring_of(const glm::dvec2& at_m) const;
  double part_within(std::size_t ring, const glm::dvec2& at_m) const;
  double finer_m(const Ring& ring, const glm::dvec2& at_m, double shown_m) const;
  template <class HeightInRing>
  double between_rings(const glm::dvec2& at_m, const HeightInRing& height_in) const;

  Square square_;
  // Not std::call_once: after an exception that hangs in some standard libraries (GCC bug 66146).
  mutable std::mutex making_;
  mutable std::unique_ptr<const Plan> plan_;  ///< until rings are made
  mutable std::unique_ptr<const Land> land_;
  mutable std::atomic<const Land*> made_ = nullptr;  ///< the land, when it is whole
};

}  // namespace wold::terrain
