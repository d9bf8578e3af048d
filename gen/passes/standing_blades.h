#pragma once

#include <array>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "landscape/box_tree.h"
#include "landscape/landscape.h"

namespace wold::passes {

/// Where a ray meets a blade.
struct BladeHit {
  double distance_m = std::numeric_limits<double>::infinity();
  int cell = 0;            ///< index into Landscape::blade_cells
  std::size_t ring = 0;    ///< of the mesh's tubes, the lower one of the two around the place
  glm::dvec3 normal{0.0};  ///< unit vector, towards the eye
};

/// The grass that stands as meshes of blades: two triangles between each two corners of two rings.
class StandingBlades {
 public:
  /// `landscape` has to outlive it.
  explicit StandingBlades(const landscape::Landscape& landscape);

  /// The first blade along a unit direction, up to `end_m`.
  BladeHit look(const glm::dvec3& eye_m, const glm::dvec3& direction, double end_m) const;

 private:
  struct Triangle {
    std::array<glm::vec3, 3> corners_m;  ///< cell space
    std::size_t ring = 0;
  };
  struct Mesh {
    std::vector<Triangle> triangles;
    landscape::BoxTree tree;
  };

  static Mesh mesh_of(const Tubes& tubes);
  landscape::Box box_of(const landscape::BladeCell& cell) const;

  const landscape::Landscape& landscape_;
  std::vector<Mesh> meshes_;
  std::vector<glm::dmat4> cell_from_world_;
  landscape::BoxTree cells_;
};

}  // namespace wold::passes
