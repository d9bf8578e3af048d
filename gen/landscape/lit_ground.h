#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/ground_map.h"
#include "grass/blade_patch.h"
#include "grass/patch_state.h"
#include "landscape/cells.h"
#include "landscape/combed_light.h"
#include "landscape/combing.h"
#include "landscape/far_field.h"
#include "landscape/haze.h"
#include "landscape/landscape.h"
#include "landscape/site.h"
#include "landscape/snowy_ground.h"
#include "landscape/variety.h"
#include "landscape/view.h"
#include "scene/scene.h"

namespace wold::landscape {

/// Whether what a frame (from 1) sees is so far that grass is painted on the ground, or haze shows.
bool shows_distance(const scene::Scene& scene, const Site& site, int frame);

/// The frame's light on ground that has some light under a clear sky.
using Illuminate = std::function<ColourMap(const terrain::GroundLight& clear)>;

/// The ground of one frame with what is painted on it, and the light on the grass that stands.
class LitGround {
 public:
  /// Frame, weathering, camera and size of the picture are `landscape`'s. `far` is called as
  /// PatchLookup's. Scene, site and choices have to outlive it.
  LitGround(const scene::Scene& scene, const Site& site, const Landscape& landscape,
            std::span<const CellChoice> choices,
            const std::function<PatchLook(const grass::PatchState&)>& far, Illuminate illuminate);
  LitGround(const LitGround&) = delete;
  LitGround& operator=(const LitGround&) = delete;

  /// Sets the landscape's pictures of the ground, its light on the grass, and how much of that
  /// stands. `light`: the frame's on all of the ground.
  void show(const SnowyGround& ground, const ColourMap& light, Landscape& landscape) const;

 private:
  ColourMap on_grass(const ColourMap& light, const GroundGrid& grid) const;
  /// Far grass and haze over the ground's own radiance.
  ColourMap painted(ColourMap ground, const FactorMap& growth, const ColourMap& grass_light) const;
  GroundDetail detail(const SnowyGround& ground, const GroundGrid& grid) const;
  /// On the grass of a large terrain's window of cells.
  ColourMap light_in_window() const;

  const scene::Scene& scene_;
  const Site& site_;
  std::span<const CellChoice> choices_;
  Illuminate illuminate_;
  int frame_;
  View view_;
  Haze haze_;
  Combing combing_;
  double snow_;  ///< canopy_snow()
  grass::AgeingModel model_;
  grass::WitheringPatch patch_;
  CombedLight combed_;
  std::optional<Variety> variety_;  ///< of colour, if any
  std::optional<Meadow> meadow_;    ///< as it looks from afar, where it is seen so
};

}  // namespace wold::landscape
