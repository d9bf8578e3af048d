#include "grass/mechanics/meadow_model.h"

#include "scene/species.h"

namespace wold::grass {

MeadowModel::MeadowModel(const scene::MeadowPart& meadow)
    : MeadowModel(scene::species_of(meadow)) {}

MeadowModel::MeadowModel(std::span<const scene::Species> species) {
  for (const scene::Species& one : species)
    models_.emplace_back(one.physiology, one.plant.specular, one.flower);
}

}  // namespace wold::grass
