#pragma once

#include <cstdint>
#include <memory>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/boulders.h"
#include "terrain/finer_relief.h"
#include "terrain/grazing_steps.h"
#include "terrain/land_cover.h"
#include "terrain/paths.h"
#include "terrain/photo.h"
#include "terrain/scree.h"
#include "terrain/surface.h"
#include "terrain/water.h"

namespace wold::terrain {

/// A scene's ground: heights in metres, and what is finer than their step.
struct Ground {
  Heightfield heights_m;
  std::shared_ptr<const FinerRelief>
      finer;                                ///< none where the step is no coarser than soil's creep
  std::shared_ptr<const Water> water = {};  ///< of lakes and rivers; none where there are none
  std::shared_ptr<const LandCover> cover = {};    ///< read_land_cover()'s
  std::shared_ptr<const Scree> scree = {};        ///< none where there is nothing finer
  std::shared_ptr<const Photo> photo = {};        ///< read_photo()'s
  std::shared_ptr<const Boulders> boulders = {};  ///< none where terrain.boulders is 0
  std::shared_ptr<const Paths> paths = {};        ///< none where the scene has none
  std::shared_ptr<const GrazingSteps> grazing_steps =
      {};  ///< none where terrain.grazing_steps is 0

  KnownGround known() const {
    return {water.get(),    cover.get(), scree.get(),        photo.get(),
            boulders.get(), paths.get(), grazing_steps.get()};
  }
};

/// The scene's ground: make_hillside(), make_mountain(), or the place of an elevation model when it
/// names one (elevation.h).
///
/// What was measured stays. Below the model's cells its relief goes on (FinerRelief) down to the
/// heights' step, unless terrain.relief is 0, and soil creeps (crept()). Where the model has lakes
/// (model_lakes()), or terrain.cover lakes and rivers (with_covered_water()), the ground is their
/// surface, unless terrain.water is none. Debris lies below its rock. The same for any number of
/// threads. Throws what read_elevation(), read_land_cover() and read_photo() throw.
///
/// `cover_classes`: scene::cover_classes_of(), of terrain.cover.
Ground make_ground(const scene::Terrain& terrain, std::uint64_t seed,
                   const std::vector<scene::CoverClass>& cover_classes = {},
                   const std::vector<scene::Path>& paths = {});

}  // namespace wold::terrain
