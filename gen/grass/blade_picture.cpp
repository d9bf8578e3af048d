#include "grass/blade_picture.h"

#include <algorithm>
#include <cmath>

#include "grass/silhouette.h"

namespace wold::grass {

BladePicture::BladePicture(const BladePatch& patch, const glm::dvec3& direction, int side)
    : patch_m_(patch.patch_m),
      slope_(glm::dvec2(direction) / direction.z),
      side_(side),
      pixels_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
  constexpr int segments = 24;
  for (std::uint32_t blade = 0; blade < patch.blades.size(); ++blade)
    each_strip(
        patch.blades[blade], patch.poses[blade], segments, patch.patch_m, glm::vec3(direction),
        [&](const Strip& strip) {
          each_covered_pixel(side, strip, [&](std::size_t at, double t) {
            const float height = std::lerp(strip.height_a, strip.height_b, static_cast<float>(t));
            Pixel& pixel = pixels_[at];
            if (pixel.blade != nothing && pixel.height_m >= height) return;
            const float along = std::lerp(strip.along_a, strip.along_b, static_cast<float>(t));
            pixel = {blade, along, height, strip.snow};
          });
        });
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
