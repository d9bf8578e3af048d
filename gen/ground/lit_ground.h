#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "grass/ageing/patch_state.h"
#include "grass/optics/shared_gaps.h"
#include "grass/texel/blade_patch.h"
#include "ground/haze.h"
#include "ground/lake_surface.h"
#include "ground/land_around.h"
#include "ground/snowy_ground.h"
#include "landscape/landscape.h"
#include "meadow/cells.h"
#include "meadow/far_field.h"
#include "meadow/frame_grass.h"
#include "meadow/lean_light.h"
#include "meadow/pigment_spread.h"
#include "meadow/shrub_shade.h"
#include "meadow/sward.h"
#include "meadow/tint.h"
#include "place/site.h"
#include "place/view.h"
#include "scene/scene.h"

namespace wold::ground {

/// Whether a frame's camera sees land around the scene's square.
bool sees_land_around(const place::Site& site, const landscape::Camera& camera,
                      const scene::Render& render);

/// Whether what a frame (from 1) sees is so far that grass is painted on the ground, haze shows, or
/// land around the scene's square; and where water mirrors far land.
bool shows_distance(const scene::Scene& scene, const place::Site& site, int frame);

/// What a mixture in a state looks like from afar; see PatchLookup.
using FarLook = std::function<meadow::PatchAppearance(int mixture, const grass::PatchState& state)>;

/// The meadow as a frame shows it from afar; nothing where no distance is shown. Everything but
/// `far` has to outlive it.
std::optional<meadow::Meadow> far_meadow(const scene::Scene& scene, const place::Site& site,
                                         const meadow::FrameGrass& now, const place::View& view,
                                         const FarLook& far);

/// The ground of one frame with what is painted on it, and the light on the grass that stands.
class LitGround {
 public:
  /// Weathering, camera and size of the picture are `landscape`'s. `far` is called as
  /// PatchLookup's. Scene, site and choices have to outlive it.
  LitGround(const scene::Scene& scene, const place::Site& site, const meadow::FrameGrass& now,
            const landscape::Landscape& landscape, std::span<const meadow::CellChoice> choices,
            const FarLook& far, Illuminate illuminate);
  LitGround(const LitGround&) = delete;
  LitGround& operator=(const LitGround&) = delete;

  /// Sets the landscape's pictures of the ground, its light on the grass, and how much of that
  /// stands, on a large terrain only where cells are; paints the land around on the landscape's
  /// backdrop, if it has one. `light`: the frame's on all of the ground, from which it takes what
  /// shrubs shade; `sky` is what water mirrors.
  void show(const SnowyGround& ground, ColourMap& light, const SkyRadiance& sky,
            landscape::Landscape& landscape) const;

 private:
  /// The light without what shrubs keep off, at least as fine as `grid` where they do. `clear`:
  /// under a clear sky, on the light's own grid.
  ColourMap shaded_by_shrubs(ColourMap light, const terrain::GroundLight& clear,
                             const SnowyGround& ground, const GroundGrid& grid) const;
  /// `light`: the frame's; `clear`: under a clear sky, on the same square.
  /// `shown_step_m`: see sward_light_map().
  ColourMap on_grass(ColourMap light, const terrain::GroundLight& clear, const GroundGrid& grid,
                     const place::View& view, const meadow::Sward::StepAt& shown_step_m = {}) const;
  /// Adds to the ground's radiance what is more sunlit of it between blades where it is seen than
  /// elsewhere. `bare`: reflectance of what is no snow; `clear`: the light under a clear sky.
  void add_hot_spot(const ColourMap& bare, const terrain::GroundLight& clear,
                    const FactorMap& growth, const place::View& view, ColourMap& radiance) const;
  /// `around`: the land around, which water mirrors, too.
  std::unique_ptr<const LakeSurface> lake_surface(const SnowyGround& ground, const ColourMap& light,
                                                  const ColourMap& grass_light,
                                                  const LandAround& around, const SkyRadiance& sky,
                                                  const landscape::Landscape& landscape) const;
  ColourMap sun_alone(const terrain::GroundLight& clear) const;
  /// Water, far grass and haze over the ground's own radiance. `light`: on it.
  ColourMap painted(ColourMap ground, const FactorMap& growth, const ColourMap& light,
                    const ColourMap& grass_light, const LakeSurface* lakes,
                    const place::View& view) const;
  /// Where the camera does not see it, it is as the `coarser` picture has it. `view`: over the
  /// terrain.
  landscape::GroundDetail detail(const SnowyGround& ground, const GroundGrid& grid,
                                 const place::View& view, const LakeSurface* lakes,
                                 const ColourMap& coarser) const;
  /// How the ground looks along a level line of sight of the camera: radiance over irradiance.
  struct LevelLook;
  LandAppearance land_appearance(const LevelLook& look) const;
  LandAround land_around(const LevelLook& look) const;
  /// Radiance that the eye sees of a place on the land around, of which a pixel covers `step_m`.
  glm::vec3 seen_around(const LandAround& around, const LakeSurface* lakes, const glm::dvec2& at_m,
                        double step_m) const;
  void show_land_around(const LandAround& around, const LakeSurface* lakes,
                        landscape::Landscape& landscape) const;
  std::vector<place::View> views_of_pictures(const SnowyGround& ground,
                                             const std::vector<GroundGrid>& details,
                                             const landscape::Landscape& landscape) const;
  /// On the grass of a part of a large terrain, on which cells stand.
  ColourMap light_on_cells(const SnowyGround& ground, const GroundGrid& grid,
                           const place::View& in_sight) const;
  /// A map of light on cells as haze shows it, for cells that show one key frame each. `colour` is
  /// what grass looks like, `tint_grid` has the steps by which the light follows the cells.
  ColourMap veiled_and_tinted(ColourMap grass_light, const meadow::GrassColour& colour,
                              const GroundGrid& tint_grid) const;
  /// `grass_light`: what shines on all of the ground's grass; on a large terrain it is made anew,
  /// where cells are.
  void show_light_on_grass(const SnowyGround& ground, ColourMap grass_light,
                           landscape::Landscape& landscape) const;

  const scene::Scene& scene_;
  const place::Site& site_;
  std::span<const meadow::CellChoice> choices_;
  Illuminate illuminate_;
  meadow::FrameGrass now_;
  place::View view_;
  glm::dvec3 eye_m_;
  Haze haze_;
  grass::MeadowModel model_;
  grass::WitheringPatch patch_;
  meadow::LeanLight lean_light_;
  glm::vec3 under_grass_;  ///< fraction of the light that reaches the ground where grass grows
  grass::SharedGaps shared_gaps_;
  meadow::ShrubShade shrub_shade_;
  std::optional<meadow::PigmentSpread> pigment_spread_;  ///< of colour, if any
  std::optional<meadow::Meadow> meadow_;  ///< as it looks from afar, where it is seen so
};

}  // namespace wold::ground
