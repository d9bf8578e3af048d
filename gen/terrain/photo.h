#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "core/ground_map.h"
#include "scene/scene.h"
#include "terrain/land_cover.h"

namespace wold::terrain {

/// A photo of the ground from above, on the scene's square: linear red, green and blue, which count
/// as albedo; NaN where it shows nothing.
using PhotoMap = GroundMap<glm::dvec3, struct PhotoColours>;

/// The photo without the light that was on its slopes: its brightness is regressed on the ground's
/// normals, which by Lambert's law gives the light of its sun and sky, and divided by that. Its
/// mean brightness stays. What grows by aspect alone is taken for light, too.
PhotoMap without_shading(PhotoMap photo, const Heightfield& heights_m);

/// What an orthophoto says of the scene's ground, without its shading: where grass grows, as far as
/// it is green, and the colour of all other ground.
class Photo {
 public:
  explicit Photo(PhotoMap albedo) : albedo_(std::move(albedo)) {}

  /// Of a place. Grass may grow on the share that is as green as grass and not as dark as woods, by
  /// the green chromatic coordinate, G / (R + G + B) of display values [Richardson2007].
  LandCover::Shares at(const glm::dvec2& at_m) const;

 private:
  PhotoMap albedo_;
};

/// terrain.photo on the scene's square: a raster of bytes, red, green and blue in sRGB, in any
/// coordinate system; none where the scene has none. `heights_m`: of the ground. Finer cells than a
/// photo of 2048 along a side has are averaged. Throws InputError where it is no such raster, shows
/// nothing of the square, or where one of it and terrain.elevation has a coordinate system and the
/// other has none.
std::optional<Photo> read_photo(const scene::Terrain& terrain, const Heightfield& heights_m);

}  // namespace wold::terrain
