#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>

namespace wold {

/// The extent of a picture of 32-bit floats that is kept in square tiles on disk.
struct TiledExtent {
  glm::ivec2 size_px = {};
  int channels = 1;
  int tile_px = 256;  ///< side; a multiple of 16

  glm::ivec2 tiles() const { return (size_px + tile_px - 1) / tile_px; }
};

/// Writes a picture by extension (.tif, .exr) that may be larger than memory, whole or not at all,
/// the same bytes for the same values. fill(tile, values) gives the values of tile (column, row),
/// all tile_px^2 of it, row by row, channels interleaved; what is outside the picture is ignored.
/// It is called for `at_a_time` >= 1 tiles in parallel, whose values are all that is held in
/// memory. Throws FileError; what fill() throws reaches the caller.
void write_tiled_image(const std::filesystem::path& path, const TiledExtent& extent, int at_a_time,
                       const std::function<void(glm::ivec2 tile, std::span<float> values)>& fill);

/// Reads rectangles of tiled pictures and keeps their latest tiles in memory, up to a limit: that
/// of the latest object, for the tiles of all. Safe for any number of threads.
class TiledImages {
 public:
  explicit TiledImages(double memory_mb);

  /// count.x * count.y pixels from `first` on, row by row, channels interleaved; pixels outside the
  /// picture are 0. `values` has their number. Throws FileError when the picture is missing or
  /// damaged.
  void read(const std::filesystem::path& path, const glm::ivec2& first, const glm::ivec2& count,
            int channels, std::span<float> values) const;

  /// To be called when a picture's file has been removed or written anew.
  void forget(const std::filesystem::path& path) const;

 private:
  struct Cache;
  std::shared_ptr<Cache> cache_;
};

/// Writes the picture of half the size (rounded up): each pixel is the mean of the four, or at odd
/// borders two or one, that it covers.
void write_halved(const TiledImages& images, const std::filesystem::path& from,
                  const TiledExtent& extent, const std::filesystem::path& to, int at_a_time);

/// The extent of a picture's half.
inline TiledExtent halved(const TiledExtent& extent) {
  return {(extent.size_px + 1) / 2, extent.channels, extent.tile_px};
}

}  // namespace wold
