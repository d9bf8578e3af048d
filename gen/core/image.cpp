#include "core/image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"

namespace wold {
namespace {

OIIO::TypeDesc stored_type(PixelFormat format) {
  switch (format) {
    case PixelFormat::uint8:
      return OIIO::TypeDesc::UINT8;
    case PixelFormat::uint16:
      return OIIO::TypeDesc::UINT16;
    case PixelFormat::half:
      return OIIO::TypeDesc::HALF;
    case PixelFormat::float32:
      break;
  }
  return OIIO::TypeDesc::FLOAT;
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image, PixelFormat format) {
  write_file_by_path(path, [&](const std::filesystem::path& temporary) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, stored_type(format));
    // Otherwise colours are divided by alpha in some formats.
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (path.extension() == ".exr") {
      spec.attribute("compression", "zip");
      // Without it OpenImageIO stores the time, and the same picture has other bytes every second.
      spec.attribute("DateTime", "1970:01:01 00:00:00");
    }
    auto out = OIIO::ImageOutput::create(temporary.string());
    if (!out || !out->open(temporary.string(), spec) ||
        !out->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) || !out->close())
      throw FileError(out ? out->geterror() : OIIO::geterror());
  });
}

ImageHeader read_image_header(const std::filesystem::path& path) {
  auto in = OIIO::ImageInput::open(path.string());
  if (!in) throw FileError(fmt::format("cannot read {}: {}", path.string(), OIIO::geterror()));
  return {in->spec().width, in->spec().height, in->spec().nchannels};
}

Image read_image(const std::filesystem::path& path) {
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  auto in = OIIO::ImageInput::open(path.string(), &as_stored);
  if (!in) throw FileError(fmt::format("cannot read {}: {}", path.string(), OIIO::geterror()));
  const OIIO::ImageSpec& spec = in->spec();
  Image image(spec.width, spec.height, spec.nchannels);
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
    throw FileError(fmt::format("cannot read {}: {}", path.string(), in->geterror()));
  return image;
}

}  // namespace wold
