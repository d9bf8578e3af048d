#include "grass/optics/blade_picture.h"

#include <algorithm>
#include <cmath>

namespace wold::grass {

BladePicture::BladePicture(const BladePatch& patch, const glm::dvec3& direction, int side)
    : BladePicture(pieces_of(patch), patch.patch_m, direction, side) {}

BladePicture::BladePicture(const std::vector<Piece>& pieces, double patch_m,
                           const glm::dvec3& direction, int side)
    : patch_m_(patch_m),
      slope_(glm::dvec2(direction) / direction.z),
      side_(side),
      pixels_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
  for (const Piece& piece : pieces)
    each_covered_pixel(
        side, strip_of(piece, patch_m, glm::vec3(direction)), [&](std::size_t at, double t) {
          const float height_m = std::lerp(piece.a_m.z, piece.b_m.z, static_cast<float>(t));
          Pixel& pixel = pixels_[at];
          if (pixel.blade != nothing && pixel.height_m >= height_m) return;
          const float along = std::lerp(piece.along_a, piece.along_b, static_cast<float>(t));
          pixel = {piece.blade, along, height_m, piece.snow};
        });
}

std::vector<Piece> BladePicture::pieces_of(const BladePatch& patch) {
  constexpr int segments = 24;
  return grass::pieces_of(patch.blades, patch.poses, segments);
}

double BladePicture::coverage() const {
  const auto shown = std::count_if(pixels_.begin(), pixels_.end(),
                                   [](const Pixel& pixel) { return pixel.blade != nothing; });
  return static_cast<double>(shown) / static_cast<double>(pixels_.size());
}

bool BladePicture::hides(const glm::vec3& place_m, std::uint32_t blade) const {
  const glm::dvec2 ground = glm::dvec2(glm::vec2(place_m) - place_m.z * slope_) / patch_m_;
  const glm::ivec2 at =
      glm::min(glm::ivec2((ground - glm::floor(ground)) * double(side_)), glm::ivec2(side_ - 1));
  const Pixel& pixel = pixels_[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(side_) +
                               static_cast<std::size_t>(at.x)];
  return pixel.blade != nothing && pixel.blade != blade && pixel.height_m > place_m.z;
}

}  // namespace wold::grass
