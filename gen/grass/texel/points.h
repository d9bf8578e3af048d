#pragma once

#include <cstdint>
#include <vector>

#include "grass/geometry/blade.h"
#include "grass/texel/texel.h"

namespace wold::grass {

/// The point-based structure of [TVT] section 2.3. One array per attribute, points of a blade
/// together and ascending along it.
///
/// A point remembers its blade and its place on it (arc length, distances off the axis), which
/// [TVT] recovers from position and tangent; remembered, it stays exact however far the blade
/// bends. [TVT]'s mass (equal for all) becomes the projected area the point stands for, so
/// that rounding Num to whole points loses nothing.
struct Points {
  std::vector<std::uint32_t> blade_begin;  ///< first point of each blade, and the end

  // At rest, on the fresh blade.
  std::vector<float> arc_m;     ///< along the axis from the root
  std::vector<float> side_m;    ///< off the axis, within the blade's vertical plane
  std::vector<float> across_m;  ///< off the axis, horizontally
  std::vector<float> rest_area_m2;
  std::vector<std::uint8_t> vein;  ///< 1: vein tissue, 0: mesophyll

  // Now.
  std::vector<glm::vec3> position_m;     ///< on the patch, not wrapped
  std::vector<glm::vec3> tangent;        ///< unit
  std::vector<glm::vec3> normal;         ///< unit; zero for vein tissue
  std::vector<glm::vec3> albedo;         ///< md
  std::vector<glm::vec3> transmittance;  ///< what of it leaves on the other side
  std::vector<float> specular;           ///< ms
  std::vector<float> area_m2;            ///< zero once merged into another point

  std::size_t size() const { return arc_m.size(); }
  std::size_t blades() const { return blade_begin.empty() ? 0 : blade_begin.size() - 1; }
};

/// Texel to points: every voxel gives Num = proportion * rho points at keyed random places in it.
///
/// rho is made free of units as the optical depth density * voxel side. Sampling goes blade by
/// blade, through the blades' own texels, whose sum the texel is: Num is the same, but each point
/// inherits the frame of its own blade rather than a mean of blades that cross in its voxel. Num
/// below one is drawn by chance; the area of what is left out is carried by the blade's others.
/// Jitter that leaves the cone is pulled back to it, so that sampling does not thicken blades.
Points sample_points(const std::vector<Blade>& blades, const TexelShape& shape,
                     double points_per_voxel_face, std::uint64_t seed);

}  // namespace wold::grass
