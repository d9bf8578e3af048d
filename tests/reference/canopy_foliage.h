#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reference/sail.h"
#include "scene/scene.h"

namespace wold::test {

/// A bit of the leaves that canopy.py traces paths through.
struct LeafBit {
  double area_m2;
  double inclination;  ///< radians between leaf and ground
  double height_m;
  glm::dvec3 reflectance, transmittance;
};

/// The leaves of all variants of a meadow at a weathering degree: what theory asks of a canopy.
class CanopyFoliage {
 public:
  CanopyFoliage(const scene::Scene& scene, double weathering);

  /// Uppermost first.
  const std::vector<LeafBit>& bits() const { return bits_; }

  /// One-sided area of leaves over that of the ground.
  double leaf_area_index() const { return area_m2_ / ground_m2_; }

  /// The size of leaves, their mean chord (pi area / outline), over the height of a canopy as high
  /// in the mean that is evenly filled.
  double hot_spot() const;

 private:
  std::vector<LeafBit> bits_;
  double area_m2_ = 0.0;
  double ground_m2_ = 0.0;
  double outline_m_ = 0.0;
};

/// Angles of leaves in classes of 5 degrees.
LeafAngles leaf_angles(const std::vector<LeafBit>& bits);

/// Area, and mean reflectance and transmittance, of leaves.
struct MeanLeaf {
  double area_m2 = 0.0;
  glm::dvec3 reflectance{0.0}, transmittance{0.0};

  void add(const LeafBit& bit);
  Leaf leaf(int channel) const;
};

}  // namespace wold::test
