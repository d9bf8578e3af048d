#include "core/image.h"

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "core/error.h"
#include "core/files.h"
#include "core/layered_image.h"
#include "core/png_chunks.h"
#include "core/rough_picture.h"

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

/// A kind of picture that is read; the name is OpenImageIO's.
struct Format {
  const char* name;
  std::array<std::string_view, 2> extensions;
};

constexpr std::array<Format, 5> formats = {{{"png", {".png", ""}},
                                            {"openexr", {".exr", ""}},
                                            {"jpeg", {".jpg", ".jpeg"}},
                                            {"tiff", {".tif", ".tiff"}},
                                            {"hdr", {".hdr", ".rgbe"}}}};

/// That of the extension first.
std::array<Format, formats.size()> formats_to_try(const std::filesystem::path& path) {
  auto all = formats;
  const std::string extension = OIIO::Strutil::lower(path.extension().string());
  std::stable_partition(all.begin(), all.end(), [&](const Format& format) {
    return !extension.empty() && std::find(format.extensions.begin(), format.extensions.end(),
                                           extension) != format.extensions.end();
  });
  return all;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw FileError(fmt::format("cannot read {}: {}", path.string(), why));
}

/// Sizes are checked before memory is taken.
void check_size(const std::filesystem::path& path, const OIIO::ImageSpec& spec) {
  constexpr OIIO::imagesize_t max_numbers = 1U << 28;
  constexpr int max_side = 1 << 17;
  if (spec.deep || spec.depth > 1)
    refuse(path, "found pixels in depth, expected one layer of them");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) refuse(path, "it has no pixels");
  // OpenImageIO takes memory for many whole rows at once, however few there are.
  if (std::max(spec.width, spec.height) > max_side)
    refuse(path, fmt::format("found {} x {} pixels, expected {} along a side at most", spec.width,
                             spec.height, max_side));
  if (spec.image_pixels() > max_numbers / static_cast<OIIO::imagesize_t>(spec.nchannels))
    refuse(path, fmt::format("found {} x {} pixels of {} numbers, expected {} numbers at most",
                             spec.width, spec.height, spec.nchannels, max_numbers));
}

/// By name of the format: given a name alone, OpenImageIO tries every reader it has, and takes what
/// follows a question mark for options.
std::unique_ptr<OIIO::ImageInput> open_picture(const std::filesystem::path& path) {
  require_regular_file(path);
  OIIO::ImageSpec as_stored;
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  std::string why;
  for (const Format& format : formats_to_try(path)) {
    auto in = OIIO::ImageInput::create(format.name);
    OIIO::ImageSpec spec;
    if (in && in->open(path.string(), spec, as_stored)) {
      check_size(path, in->spec());
      return in;
    }
    const std::string said = in ? in->geterror() : OIIO::geterror();
    if (why.empty()) why = said;
  }
  refuse(path, fmt::format("expected a PNG, JPEG, TIFF, OpenEXR or Radiance HDR picture: {}", why));
}

std::map<std::string, std::string> text_attributes(const OIIO::ImageSpec& spec) {
  std::map<std::string, std::string> attributes;
  for (const OIIO::ParamValue& value : spec.extra_attribs)
    if (value.type() == OIIO::TypeDesc::STRING)
      attributes[value.name().string()] = value.get_string();
  return attributes;
}

/// `packing` is OpenImageIO's name of how an OpenEXR picture is packed.
void write_packed(const std::filesystem::path& path, const Image& image, PixelFormat format,
                  const char* packing) {
  write_file_by_path(path, [&](const std::filesystem::path& temporary) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels, stored_type(format));
    // Otherwise colours are divided by alpha in some formats.
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (path.extension() == ".exr") {
      spec.attribute("compression", packing);
      // Without it OpenImageIO stores the time, and the same picture has other bytes every second.
      spec.attribute("DateTime", "1970:01:01 00:00:00");
    }
    auto out = OIIO::ImageOutput::create(temporary.string());
    if (!out || !out->open(temporary.string(), spec) ||
        !out->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) || !out->close())
      throw FileError(out ? out->geterror() : OIIO::geterror());
    if (path.extension() == ".png")
      write_file(temporary, without_ancillary_chunks(read_file(temporary)));
  });
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image, PixelFormat format) {
  // Others without loss are made by libraries whose versions choose other bytes.
  write_packed(path, image, format, "rle");
}

void write_rough_picture(const std::filesystem::path& path, const Image& image) {
  write_packed(path, image, PixelFormat::half, "b44");
}

ImageHeader read_image_header(const std::filesystem::path& path) {
  const auto in = open_picture(path);
  const OIIO::ImageSpec& spec = in->spec();
  return {spec.width, spec.height, spec.nchannels, spec.format.c_str()};
}

Image read_image(const std::filesystem::path& path) {
  const auto in = open_picture(path);
  const OIIO::ImageSpec& spec = in->spec();
  Image image(spec.width, spec.height, spec.nchannels);
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()))
    refuse(path, in->geterror());
  return image;
}

LayeredImage read_layered_image(const std::filesystem::path& path) {
  const auto in = open_picture(path);
  const OIIO::ImageSpec& spec = in->spec();
  LayeredImage image{spec.width, spec.height, {}, text_attributes(spec)};
  const auto channels = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> pixels(image.pixels() * channels);
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()))
    throw FileError("cannot read " + path.string() + ": " + in->geterror());
  for (std::size_t c = 0; c < channels; ++c) {
    const bool is_half = spec.channelformat(static_cast<int>(c)).basetype == OIIO::TypeDesc::HALF;
    ImageChannel channel{spec.channelnames[c], is_half ? PixelFormat::half : PixelFormat::float32,
                         std::vector<float>(image.pixels())};
    for (std::size_t i = 0; i < image.pixels(); ++i) channel.values[i] = pixels[i * channels + c];
    image.channels.push_back(std::move(channel));
  }
  return image;
}

}  // namespace wold
