#include "core/tiled_image.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"

namespace wold {
namespace {

OIIO::ImageSpec spec_of(const TiledExtent& extent) {
  OIIO::ImageSpec spec(extent.size_px.x, extent.size_px.y, extent.channels, OIIO::TypeDesc::FLOAT);
  spec.tile_width = spec.tile_height = extent.tile_px;
  spec.attribute("compression", "none");  // it would take longer than all else
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  return spec;
}

std::size_t values_per_tile(const TiledExtent& extent) {
  return static_cast<std::size_t>(extent.tile_px) * static_cast<std::size_t>(extent.tile_px) *
         static_cast<std::size_t>(extent.channels);
}

}  // namespace

void write_tiled_image(const std::filesystem::path& path, const TiledExtent& extent, int at_a_time,
                       const std::function<void(glm::ivec2 tile, std::span<float> values)>& fill) {
  write_file_by_path(path, [&](const std::filesystem::path& temporary) {
    auto out = OIIO::ImageOutput::create(temporary.string());
    if (!out || !out->supports("tiles") || !out->open(temporary.string(), spec_of(extent)))
      throw FileError(out ? out->geterror() : OIIO::geterror());
    const int across = extent.tiles().x, all = across * extent.tiles().y;
    const std::size_t each = values_per_tile(extent);
    std::vector<float> values(static_cast<std::size_t>(std::min(at_a_time, all)) * each);
    for (int first = 0; first < all; first += at_a_time) {
      const int count = std::min(at_a_time, all - first);
      const auto tile = [&](std::size_t i) { return first + static_cast<int>(i); };
      const auto values_of = [&](std::size_t i) {
        return std::span(values).subspan(i * each, each);
      };
      parallel_for(static_cast<std::size_t>(count), [&](std::size_t i) {
        fill({tile(i) % across, tile(i) / across}, values_of(i));
      });
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        if (!out->write_tile(tile(i) % across * extent.tile_px, tile(i) / across * extent.tile_px,
                             0, OIIO::TypeDesc::FLOAT, values_of(i).data()))
          throw FileError(out->geterror());
    }
    if (!out->close()) throw FileError(out->geterror());
  });
}

struct TiledImages::Cache {
  // The shared one: threads keep pointers into a private one beyond its end, and a new one in its
  // place would follow them (OpenImageIO 2.4). A plain pointer until OpenImageIO 3.0, a shared one
  // from then on.
  decltype(OIIO::ImageCache::create(true)) images = OIIO::ImageCache::create(true);
  Cache() = default;
  Cache(const Cache&) = delete;
  Cache& operator=(const Cache&) = delete;
  ~Cache() { OIIO::ImageCache::destroy(images); }
};

TiledImages::TiledImages(double memory_mb) : cache_(std::make_shared<Cache>()) {
  cache_->images->attribute("max_memory_MB", static_cast<float>(memory_mb));
}

void TiledImages::read(const std::filesystem::path& path, const glm::ivec2& first,
                       const glm::ivec2& count, int channels, std::span<float> values) const {
  const glm::ivec2 end = first + count;
  if (!cache_->images->get_pixels(OIIO::ustring(path.string()), 0, 0, first.x, end.x, first.y,
                                  end.y, 0, 1, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
    throw FileError(fmt::format("cannot read {}: {}", path.string(), cache_->images->geterror()));
}

void TiledImages::forget(const std::filesystem::path& path) const {
  cache_->images->invalidate(OIIO::ustring(path.string()), true);
}

void write_halved(const TiledImages& images, const std::filesystem::path& from,
                  const TiledExtent& extent, const std::filesystem::path& to, int at_a_time) {
  const auto channels = static_cast<std::size_t>(extent.channels);
  const auto side = static_cast<std::size_t>(extent.tile_px);
  const auto fill = [&](const glm::ivec2& tile, std::span<float> values) {
    const glm::ivec2 first = tile * extent.tile_px * 2;
    const glm::ivec2 there = glm::min(extent.size_px - first, glm::ivec2(2 * extent.tile_px));
    const auto width = static_cast<std::size_t>(there.x),
               height = static_cast<std::size_t>(there.y);
    std::vector<float> fine(width * height * channels);
    images.read(from, first, there, extent.channels, fine);
    std::ranges::fill(values, 0.0F);
    for (std::size_t y = 0; y < (height + 1) / 2; ++y)
      for (std::size_t x = 0; x < (width + 1) / 2; ++x) {
        const std::size_t x1 = std::min(2 * x + 1, width - 1), y1 = std::min(2 * y + 1, height - 1);
        const auto at = [&](std::size_t i, std::size_t j) {
          return fine.data() + (j * width + i) * channels;
        };
        const float *a = at(2 * x, 2 * y), *b = at(x1, 2 * y), *c = at(2 * x, y1), *d = at(x1, y1);
        float* const mean = values.data() + (y * side + x) * channels;
        for (std::size_t k = 0; k < channels; ++k) mean[k] = 0.25F * (a[k] + b[k] + c[k] + d[k]);
      }
  };
  write_tiled_image(to, halved(extent), at_a_time, fill);
}

}  // namespace wold
