#pragma once

#include <span>
#include <vector>

#include "grass/mechanics/dynamics.h"
#include "scene/parts.h"

namespace wold::grass {

/// The ageing models of all species of a meadow.
class MeadowModel {
 public:
  /// Of the scene's species. Throws what AgeingModel's constructor throws.
  explicit MeadowModel(const scene::MeadowPart& meadow);
  /// Of these, one at least; Blade::species are their places. Throws what AgeingModel's constructor
  /// throws.
  explicit MeadowModel(std::span<const scene::Species> species);

  const AgeingModel& of_species(int species) const {
    return models_[static_cast<std::size_t>(species)];
  }
  const AgeingModel& of(const Blade& blade) const { return of_species(blade.species); }

 private:
  std::vector<AgeingModel> models_;
};

}  // namespace wold::grass
