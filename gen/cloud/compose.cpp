#include "cloud/compose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// Pixels at a time: their colours, ranks and looks stay in the processor's nearest memory.
constexpr int block_px = 512;

/// `count` values of a map's row from any column on: where they lie, or in `scratch`, put together
/// from the row's end and its start.
const std::uint16_t* row_from(const LayerMap& map, long x, long y, int count,
                              std::uint16_t* scratch) {
  const std::uint16_t* row = map.row(wrapped_index(y, map.height()));
  int from = wrapped_index(x, map.width());
  if (from + count <= map.width()) return row + from;
  for (std::uint16_t* to = scratch; count > 0; from = 0) {
    const int run = static_cast<int>(std::min<long>(count, map.width() - from));
    to = std::copy_n(row + from, run, to);
    count -= run;
  }
  return scratch;
}

/// Four floats that the processor adds and multiplies at once; glm::vec4 is taken apart.
using Float4 = float __attribute__((vector_size(16)));

/// A shift by whole pixels and the bilinear weights of what is left, in 1/65536; they sum to one
/// step less than 1.
struct Shift {
  long x, y;
  long nearest_x, nearest_y;
  std::array<std::uint16_t, 4> weights;

  explicit Shift(const glm::dvec2& by_px)
      : x(std::lround(std::floor(by_px.x))),
        y(std::lround(std::floor(by_px.y))),
        nearest_x(std::lround(by_px.x)),
        nearest_y(std::lround(by_px.y)),
        weights() {
    const glm::dvec2 part = by_px - glm::floor(by_px);
    const auto whole = [](double fraction) { return static_cast<int>(fraction * 65535.0); };
    const int w10 = whole(part.x * (1.0 - part.y));
    const int w01 = whole((1.0 - part.x) * part.y);
    const int w11 = whole(part.x * part.y);
    const auto small = [](int weight) { return static_cast<std::uint16_t>(weight); };
    weights = {small(65535 - w10 - w01 - w11), small(w10), small(w01), small(w11)};
  }
};

/// The upper half of a product of 16 bits by 16, which one instruction makes for eight numbers.
std::uint16_t scaled(std::uint16_t value, std::uint16_t weight) {
  return static_cast<std::uint16_t>(static_cast<std::uint32_t>(value) * weight >> 16);
}

/// `count` values from the map's pixel (x, y) + shift on.
void shifted_row(const LayerMap& map, long x, long y, const Shift& shift, int count,
                 std::uint16_t* values) {
  std::array<std::uint16_t, block_px + 1> low_scratch, high_scratch;
  const std::uint16_t* low = row_from(map, x + shift.x, y + shift.y, count + 1, low_scratch.data());
  const std::uint16_t* high =
      row_from(map, x + shift.x, y + shift.y + 1, count + 1, high_scratch.data());
  const auto [w00, w10, w01, w11] = shift.weights;
  for (int i = 0; i < count; ++i) {
    values[i] = static_cast<std::uint16_t>(scaled(low[i], w00) + scaled(low[i + 1], w10) +
                                           scaled(high[i], w01) + scaled(high[i + 1], w11));
  }
}

/// A sheet and where the picture's south-western pixel lies in its map.
struct PlacedSheet {
  Sheet sheet;
  Shift shift;
};

/// Stores a pixel past the caches, which a picture would only flush: the processor need not read
/// what it overwrites. The address is a multiple of 16.
void store(const Float4& pixel, float* to) {
#ifdef __SSE__
  _mm_stream_ps(to, pixel);
#else
  std::memcpy(to, &pixel, sizeof pixel);
#endif
}

/// Makes stored pixels visible to other threads.
void finish_stores() {
#ifdef __SSE__
  _mm_sfence();
#endif
}

/// The numbers of a sheet's maps under a block of the picture.
struct BlockMaps {
  std::array<std::uint16_t, block_px> ranks, scratch;
  const std::uint16_t* sunlit = nullptr;  ///< in the map, or in `scratch`
};

/// Lays what is seen of `sheets` sheets over each other: the operator "over", premultiplied (Porter
/// and Duff 1984). The compiler knows the number and keeps a pixel at hand for all of them.
template <std::size_t sheets>
void lay_over(const PlacedSheet* placed, const BlockMaps* maps, int count, float* pixels) {
  std::array<const float*, sheets> opacity_by_rank;
  std::array<const glm::vec4*, sheets> colour_by_light;
  std::array<const std::uint16_t*, sheets> sunlit;
  for (std::size_t s = 0; s < sheets; ++s) {
    opacity_by_rank[s] = placed[s].sheet.opacity_by_rank.data();
    colour_by_light[s] = placed[s].sheet.colour_by_light.data();
    sunlit[s] = maps[s].sunlit;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    Float4 pixel = {0.0F, 0.0F, 0.0F, 0.0F};
    for (std::size_t s = 0; s < sheets; ++s) {
      const float opacity = opacity_by_rank[s][maps[s].ranks[i] / ranks_per_entry];
      Float4 colour;
      std::memcpy(&colour, colour_by_light[s] + sunlit[s][i] / lights_per_entry, sizeof colour);
      pixel = opacity * colour + (1.0F - opacity) * pixel;
    }
    store(pixel, pixels + 4 * i);
  }
}

/// As many sheets as 16 layers have that all change their shapes.
constexpr std::size_t max_sheets = 32;

template <std::size_t... zero_to>
constexpr auto lay_over_for(std::index_sequence<zero_to...>) {
  return std::array{lay_over<zero_to>...};
}
constexpr auto lay_over_by_count = lay_over_for(std::make_index_sequence<max_sheets + 1>());

void compose_block(const std::vector<PlacedSheet>& sheets, long x, long y, int count,
                   float* pixels) {
  std::array<BlockMaps, max_sheets> maps;
  for (std::size_t s = 0; s < sheets.size(); ++s) {
    const auto& [sheet, shift] = sheets[s];
    shifted_row(sheet.map->ranks, x, y, shift, count, maps[s].ranks.data());
    // Light is smooth: the nearest pixel will do.
    maps[s].sunlit = row_from(sheet.map->sunlit, x + shift.nearest_x, y + shift.nearest_y, count,
                              maps[s].scratch.data());
  }
  lay_over_by_count[sheets.size()](sheets.data(), maps.data(), count, pixels);
}

void compose_row(const std::vector<PlacedSheet>& sheets, long y, int width, float* row) {
  for (int x = 0; x < width; x += block_px)
    compose_block(sheets, x, y, std::min(block_px, width - x), row + std::ptrdiff_t{4} * x);
  finish_stores();
}

void compose_rows(const std::vector<PlacedSheet>& sheets, Image& picture) {
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int from_top = static_cast<int>(row);
    compose_row(sheets, picture.height - 1 - from_top, picture.width, picture.pixel(0, from_top));
  });
}

}  // namespace

void compose(const CloudState& state, const SkyWindow& window, Image& picture) {
  if (picture.width != window.width_px || picture.height != window.height_px ||
      picture.channels != 4)
    throw std::invalid_argument("the picture has not the window's size and 4 channels");
  std::vector<PlacedSheet> sheets;
  for (const LayerState& layer : state.layers)
    for (Sheet& sheet : sheets_of(layer, state.pixel_m)) {
      const Shift shift(window.south_west_m / state.pixel_m - sheet.way_px);
      sheets.push_back({std::move(sheet), shift});
    }
  if (sheets.size() > max_sheets) throw std::invalid_argument("too many layers of clouds");
  compose_rows(sheets, picture);
}

Image composed(const CloudState& state, const SkyWindow& window) {
  Image picture(window.width_px, window.height_px, 4);
  compose(state, window, picture);
  return picture;
}

Image layer_picture(const LayerState& state, double pixel_m) {
  LayerState here = state;
  here.moment.way_m = {};
  const CloudState alone{0.0, pixel_m, {here}};
  return composed(alone, {{}, state.layer->period_px.x, state.layer->period_px.y});
}

}  // namespace wold::cloud
