#include "report/pass_pictures.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/colour.h"
#include "core/error.h"
#include "core/image.h"
#include "core/layered_image.h"
#include "core/page_picture.h"
#include "core/random.h"

namespace wold::report {
namespace fs = std::filesystem;
namespace {

constexpr float nothing = 1e10F;
constexpr PagePicture thumbnail = {320, 85};

using Channels = std::vector<const ImageChannel*>;

std::string layer_of(const std::string& channel) { return channel.substr(0, channel.rfind('.')); }

/// The layers' names in the order of the file; of ids, which take several, the first.
std::vector<std::string> layers_of(const LayeredImage& image) {
  std::vector<std::string> layers;
  for (const ImageChannel& channel : image.channels)
    if (const std::string layer = layer_of(channel.name);
        layer != channel.name && std::ranges::count(layers, layer) == 0)
      layers.push_back(layer);
  return layers;
}

Channels channels_of(const LayeredImage& image, const std::string& layer,
                     std::string_view letters) {
  Channels channels;
  for (const char letter : letters)
    if (const ImageChannel* channel = image.find(layer + '.' + letter)) channels.push_back(channel);
  return channels;
}

struct Range {
  float min = std::numeric_limits<float>::max();
  float max = std::numeric_limits<float>::lowest();

  void take(const ImageChannel& channel) {
    for (const float value : channel.values)
      if (std::abs(value) < nothing) {
        min = std::min(min, value);
        max = std::max(max, value);
      }
  }
  /// From 0 to 1; what is no number is 0.
  float part(float value) const {
    return std::abs(value) < nothing && max > min ? (value - min) / (max - min) : 0.0F;
  }
};

Image blank(const LayeredImage& image) { return {image.width, image.height, 3}; }

/// `value(channel, pixel)` of red, green and blue; where there are fewer channels the last one
/// stands for those that are missing.
template <class Value>
Image painted(const LayeredImage& image, std::size_t count, const Value& value) {
  Image picture = blank(image);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel)
    for (std::size_t i = 0; i < 3; ++i)
      picture.values[3 * pixel + i] = value(std::min(i, count - 1), pixel);
  return picture;
}

/// Each channel over its own range.
Image numbers(const LayeredImage& image, const Channels& channels) {
  std::vector<Range> ranges(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) ranges[i].take(*channels[i]);
  return painted(image, channels.size(), [&](std::size_t i, std::size_t pixel) {
    return ranges[i].part(channels[i]->values[pixel]);
  });
}

/// Unit vectors, from -1 to 1; black where there is none.
Image directions(const LayeredImage& image, const Channels& channels) {
  return painted(image, channels.size(), [&](std::size_t i, std::size_t pixel) {
    const bool is_none = std::ranges::all_of(
        channels, [&](const ImageChannel* channel) { return channel->values[pixel] == 0.0F; });
    return is_none ? 0.0F : 0.5F + 0.5F * channels[i]->values[pixel];
  });
}

/// Linear colours, the brightest of them as 1.
Image colours(const LayeredImage& image, const Channels& channels) {
  Range range;
  for (const ImageChannel* channel : channels) range.take(*channel);
  const double scale = range.max > 0.0F ? 1.0 / static_cast<double>(range.max) : 0.0;
  return painted(image, channels.size(), [&](std::size_t i, std::size_t pixel) {
    const double linear = std::max(0.0, double{channels[i]->values[pixel]} * scale);
    return static_cast<float>(srgb_encoded(std::min(1.0, linear)));
  });
}

/// Not too dark, from a number's last byte.
float part_of_byte(std::uint64_t bits) {
  return 0.25F + 0.75F * static_cast<float>(bits & 255U) / 255.0F;
}

/// A colour for each number; black where it says that nothing is there.
Image ids(const LayeredImage& image, const Channels& channels, float without) {
  Image picture = blank(image);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    if (channels.front()->values[pixel] == without) continue;
    std::uint64_t id = 0;
    for (const ImageChannel* channel : channels)
      id = mixed(id ^ std::bit_cast<std::uint32_t>(channel->values[pixel]));
    for (std::size_t i = 0; i < 3; ++i) picture.values[3 * pixel + i] = part_of_byte(id >> (8 * i));
  }
  return picture;
}

Image picture_of(const LayeredImage& image, const std::string& layer) {
  if (layer == "instance") return ids(image, channels_of(image, layer, "XY"), -1.0F);
  if (image.find(layer + ".R") && layer.ends_with("00"))
    return ids(image, channels_of(image, layer, "R"), 0.0F);
  if (const Channels rgb = channels_of(image, layer, "RGB"); !rgb.empty())
    return colours(image, rgb);
  const Channels axes = channels_of(image, layer, "XYZ");
  if (layer == "normal") return directions(image, axes);
  return numbers(image, axes.empty() ? channels_of(image, layer, "V") : axes);
}

/// "species" of the layer "species00"; the other layers of ids are left out.
bool is_shown(const std::string& layer) {
  return std::isdigit(static_cast<unsigned char>(layer.back())) == 0 || layer.ends_with("00");
}

}  // namespace

std::vector<PassPicture> pass_pictures(const fs::path& file) {
  std::vector<PassPicture> pictures;
  try {
    const LayeredImage image = read_layered_image(file);
    for (const std::string& layer : layers_of(image)) {
      if (!is_shown(layer)) continue;
      const std::string name = layer.substr(0, layer.find_last_not_of("0123456789") + 1);
      pictures.push_back(
          {name, data_uri("image/jpeg", jpeg_of(picture_of(image, layer), thumbnail))});
    }
  } catch (const FileError&) {
    return {};
  }
  return pictures;
}

}  // namespace wold::report
