#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "ground/snowy_ground.h"
#include "landscape/landscape.h"
#include "landscape/needs.h"
#include "meadow/cells.h"
#include "meadow/frame_grass.h"
#include "meadow/patch_appearance.h"
#include "place/site.h"
#include "scene/scene.h"

namespace wold::film {

/// What stands on the cells: the baked volume of a choice, of which only variant, state, turn and
/// level count, or its blades, for which only variant and state do.
struct PatchLookup {
  std::function<landscape::Volume(const meadow::CellChoice&)> volume;
  std::function<landscape::BladeMesh(const meadow::CellChoice&)> blades;
  /// What a mixture in a state looks like from afar: the mean of its variants' unturned volumes, as
  /// coarse as there are. Called for far_states() of the mixtures that are present(), where
  /// shows_distance() (lit_ground.h).
  std::function<meadow::PatchAppearance(int mixture, const grass::PatchState&)> far = {};
};

/// A frame and what it was made from.
struct AssembledFrame {
  landscape::Landscape landscape;
  std::unique_ptr<const ground::SnowyGround> ground;
  ColourMap light;  ///< the frame's on all of the ground
};

/// One frame: `choices` are choose_cells', `lookup` is called
/// once for each different volume and for each different part of a mesh, in ascending order, and
/// what it gives, or the part of it, are the landscape's in that order.
/// `site` is site_of_frame()'s. exposure_gain is metered_gain() (exposure.h), or towards
/// snow_gain() in a season, times dusk_gain() and 2^exposure.
/// `needs` is needs_of() (exporters.h). Scene and site have to outlive what is returned.
AssembledFrame assemble_frame(const scene::Scene& scene, const place::Site& site,
                              const meadow::FrameGrass& now,
                              std::span<const meadow::CellChoice> choices,
                              const PatchLookup& lookup, const landscape::Needs& needs);

/// Its landscape alone, as exporters want it.
landscape::Landscape assemble(const scene::Scene& scene, const place::Site& site,
                              const meadow::FrameGrass& now,
                              std::span<const meadow::CellChoice> choices,
                              const PatchLookup& lookup, const landscape::Needs& needs);

}  // namespace wold::film
