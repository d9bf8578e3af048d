#pragma once

#include "grass/optics/leaf_colour.h"
#include "scene/scene.h"

namespace wold::grass {

/// The colours of a flower: petals by their pigment (models/flower/petals.toml), the disc is
/// yellow; both are brown when they are withered.
class FlowerColour {
 public:
  /// Throws FileError when a model is missing.
  explicit FlowerColour(scene::PetalColour petals);

  /// `withered`: 0 fresh to 1 brown.
  LeafShade petal(double withered) const { return petal_.at(withered); }
  LeafShade disc(double withered) const { return disc_.at(withered); }

 private:
  struct Ageing {
    LeafShade fresh, brown;
    LeafShade at(double withered) const;
  };
  Ageing petal_, disc_;
};

}  // namespace wold::grass
