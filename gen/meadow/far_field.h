#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/ground_map.h"
#include "grass/ageing/patch_state.h"
#include "meadow/frame_grass.h"
#include "meadow/patch_appearance.h"
#include "place/cell_window.h"
#include "place/mixture_field.h"
#include "place/view.h"
#include "place/withering.h"
#include "scene/scene.h"

namespace wold::meadow {

/// How far grass at a place is painted on the ground instead of standing on it: 0 near, 1 where it
/// looks lower than three quarters of grass.far_field_below_pixels, rising smoothly from five
/// quarters on, so that no line shows.
double far_fraction(const scene::Grass& grass, const place::View& view, const glm::dvec3& at_m);
/// The same, and all of it outside the window in which cells are laid.
double far_fraction(const scene::Grass& grass, const place::CellWindow& window,
                    const place::View& view, const glm::dvec3& at_m);

/// Whether any of the terrain's grass is painted, seen so.
bool has_far_field(const scene::Scene& scene, const Heightfield& terrain, const place::View& view);

/// The states whose looks a Meadow needs in a frame, ascending.
std::vector<grass::PatchState> far_states(const scene::Scene& scene,
                                          const place::Withering& withering, const FrameGrass& now);

/// What patches look like, by the number of their mixture in scene::mixtures_of() and their state.
using PatchAppearances = std::map<std::pair<int, grass::PatchState>, PatchAppearance>;

/// What the meadow of a frame looks like where single blades cannot be told apart.
class Meadow {
 public:
  /// `looks`: those of far_states() for each mixture that is present(). The others have to outlive
  /// it.
  Meadow(const scene::Scene& scene, const Heightfield& terrain, const place::MixtureField& mixtures,
         const place::Withering& withering, const place::View& view, FrameGrass now,
         PatchAppearances looks);

  /// The look along the line of sight to a place on the ground, of full growth under light 1: that
  /// of the mixture there, of the two key frames around the weathering there, of the two levels
  /// around the snow and of the two lights around the frame's, sheared to the slope and combed.
  landscape::AggregateAppearance look(const glm::dvec3& at_m) const;
  /// The same along another line of sight, a unit vector.
  landscape::AggregateAppearance look(const glm::dvec3& at_m, const glm::dvec3& sight) const;

 private:
  /// Of a mixture at a key frame, along a direction of the patch.
  landscape::AggregateAppearance at_key_frame(int mixture, int key_frame,
                                              const glm::dvec3& direction) const;
  /// And under a level of snow.
  landscape::AggregateAppearance at_snow(int mixture, int key_frame, int snow,
                                         const glm::dvec3& direction) const;

  const Heightfield& terrain_;
  const place::MixtureField& mixtures_;
  const place::Withering& withering_;
  const place::View& view_;
  FrameGrass now_;
  std::vector<double> key_frames_;
  double snow_;   ///< FrameGrass's, in levels
  double light_;  ///< FrameGrass's
  PatchAppearances looks_;
};

/// Paints the far grass over the ground's radiance by its fraction: what the meadow shows along the
/// line of sight, under the light there, over the ground.
void paint_far_grass(ColourMap& ground, const scene::Scene& scene, const Heightfield& terrain,
                     const FactorMap& growth, const ColourMap& light, const place::View& view,
                     const Meadow& meadow);

/// The fraction of the ground at a place that grass painted there hides: paint_far_grass()'s, where
/// the growth is `grown`.
double painted_opacity(const scene::Grass& mean_grass, const place::CellWindow& window,
                       const place::View& view, const Meadow& meadow, const glm::dvec3& at_m,
                       double grown);

/// Factor on the extinction of the grass that stands: its growth without the far share, over the
/// slope's cosine, which keeps the density per square metre of ground.
FactorMap grass_extinction_factor(const scene::Scene& scene, const Heightfield& terrain,
                                  const FactorMap& growth, const place::View& view);

}  // namespace wold::meadow
