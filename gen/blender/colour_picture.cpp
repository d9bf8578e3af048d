#include "blender/colour_picture.h"

#include <algorithm>
#include <limits>

namespace wold::blender {
namespace {

const glm::vec3& colour_at(const landscape::ColourGrid& grid, const glm::ivec3& at) {
  const auto row = static_cast<std::size_t>(at.z * grid.voxels.y + at.y);
  return grid
      .values[row * static_cast<std::size_t>(grid.voxels.x) + static_cast<std::size_t>(at.x)];
}

}  // namespace

ColourPicture colour_picture_of(const landscape::ColourGrid& colours) {
  float largest = std::numeric_limits<float>::min();
  for (const glm::vec3& colour : colours.values)
    largest = std::max({largest, colour.r, colour.g, colour.b});
  return {colours.voxels.x, colours.voxels.z + 2, largest};
}

Image pixels_of(const ColourPicture& picture, const landscape::ColourGrid& colours) {
  const int side = picture.side;
  const int tile = side + 2;
  Image image(tile, tile * picture.slices, 3);
  for (int slice = 0; slice < picture.slices; ++slice)
    for (int y = 0; y < tile; ++y)
      for (int x = 0; x < tile; ++x) {
        const glm::ivec3 at((x - 1 + side) % side, (y - 1 + side) % side,
                            std::clamp(slice - 1, 0, colours.voxels.z - 1));
        const glm::vec3 pixel = colour_at(colours, at) / picture.scale;
        std::copy_n(&pixel.x, 3, image.pixel(x, slice * tile + y));
      }
  return image;
}

}  // namespace wold::blender
