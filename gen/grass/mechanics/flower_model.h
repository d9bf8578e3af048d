#pragma once

#include "grass/geometry/blade.h"
#include "grass/optics/flower_colour.h"
#include "scene/scene.h"

namespace wold::grass {

/// How the flowers of a species wither. Petals and disc are fresh until `fades`, then they turn
/// brown and petals shrivel to threads.
class FlowerModel {
 public:
  /// Throws FileError when a model is missing.
  explicit FlowerModel(const scene::Flower& flower);

  /// How far flowers have withered at their own weathering degree: 0 fresh to 1.
  double withered(double age) const;
  /// The colours of a petal or a disc of that age.
  LeafShade shade(Organ organ, double age) const;
  /// What remains of a petal's width at that age: 1 to 0.15.
  float petal_width(double age) const;

 private:
  double fades_;
  FlowerColour colour_;
};

}  // namespace wold::grass
