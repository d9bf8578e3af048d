#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "grass/geometry/silhouette.h"
#include "grass/texel/blade_patch.h"

namespace wold::grass {

/// What is seen of a tiled patch of opaque blades along a direction: for every pixel of the
/// ground's plane, which tiles too, the blade nearest to the eye, or the snow on it.
class BladePicture {
 public:
  static constexpr std::uint32_t nothing = 0xFFFFFFFFU;
  struct Pixel {
    std::uint32_t blade = nothing;
    float along = 0.0F;     ///< place on it: 0 root, 1 tip
    float height_m = 0.0F;  ///< of its axis there, or the snow's
    bool snow = false;
  };

  /// direction: unit, towards the eye or the light, z > 0. `side`: pixels along the patch.
  BladePicture(const BladePatch& patch, const glm::dvec3& direction, int side);
  /// The same of the patch's pieces, which are made but once for many directions.
  BladePicture(const std::vector<Piece>& pieces, double patch_m, const glm::dvec3& direction,
               int side);
  /// As many of each blade as its picture needs.
  static std::vector<Piece> pieces_of(const BladePatch& patch);

  const std::vector<Pixel>& pixels() const { return pixels_; }
  /// Fraction of the pixels that show a blade.
  double coverage() const;
  /// Whether another blade stands between the eye and a place on blade `blade`. A blade does not
  /// hide itself: a fibre of the Kajiya-Kay model does not shadow itself.
  bool hides(const glm::vec3& place_m, std::uint32_t blade) const;

 private:
  double patch_m_;
  glm::vec2 slope_;  ///< horizontal way of the direction per metre of height
  int side_;
  std::vector<Pixel> pixels_;
};

}  // namespace wold::grass
