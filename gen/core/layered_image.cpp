#include "core/layered_image.h"

#include <Imath/half.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "core/files.h"

namespace wold {
namespace {

OIIO::TypeDesc type_of(const ImageChannel& channel) {
  return channel.stored_as == PixelFormat::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
}

OIIO::ImageSpec spec_of(const LayeredImage& image) {
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()),
                       OIIO::TypeDesc::FLOAT);
  spec.channelnames.clear();
  for (const ImageChannel& channel : image.channels) {
    spec.channelnames.push_back(channel.name);
    spec.channelformats.push_back(type_of(channel));
  }
  // As write_image() has them, for the same reasons.
  spec.attribute("compression", "rle");
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  for (const auto& [name, text] : image.attributes) spec.attribute(name, text);
  return spec;
}

template <class Number>
void put(std::string& bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, sizeof(number));
}

/// Pixel by pixel, each channel as it is stored.
std::string stored_bytes(const LayeredImage& image, const OIIO::ImageSpec& spec) {
  const std::size_t pixel_bytes = spec.pixel_bytes(/*native=*/true);
  std::string bytes(image.pixels() * pixel_bytes, '\0');
  std::size_t offset = 0;
  for (const ImageChannel& channel : image.channels) {
    for (std::size_t i = 0; i < image.pixels(); ++i) {
      const std::size_t at = i * pixel_bytes + offset;
      if (channel.stored_as == PixelFormat::half)
        put(bytes, at, Imath::half(channel.values[i]));
      else
        put(bytes, at, channel.values[i]);
    }
    offset += type_of(channel).size();
  }
  return bytes;
}

}  // namespace

const ImageChannel* LayeredImage::find(const std::string& name) const {
  const auto found = std::ranges::find(channels, name, &ImageChannel::name);
  return found == channels.end() ? nullptr : &*found;
}

void write_layered_image(const std::filesystem::path& path, const LayeredImage& image) {
  write_file_by_path(path, [&](const std::filesystem::path& temporary) {
    const OIIO::ImageSpec spec = spec_of(image);
    auto out = OIIO::ImageOutput::create("openexr");
    if (!out || !out->open(temporary.string(), spec) ||
        !out->write_image(OIIO::TypeDesc::UNKNOWN, stored_bytes(image, spec).data()) ||
        !out->close())
      throw FileError(out ? out->geterror() : OIIO::geterror());
  });
}

}  // namespace wold
