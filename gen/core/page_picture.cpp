#include "core/page_picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/image.h"

namespace wold {
namespace {

/// By OpenImageIO's own choice of a filter, in one thread.
OIIO::ImageBuf resized(const OIIO::ImageBuf& picture, const OIIO::ROI& size) {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
  return OIIO::ImageBufAlgo::resize(picture, OIIO::ImageBufAlgo::KWArgs{}, size, 1);
#else
  return OIIO::ImageBufAlgo::resize(picture, "", 0.0F, size, 1);
#endif
}

OIIO::ImageBuf shrunk(const OIIO::ImageBuf& picture, int widest_px) {
  const OIIO::ImageSpec& spec = picture.spec();
  if (spec.width <= widest_px) return picture;
  const double scale = static_cast<double>(widest_px) / spec.width;
  const int height_px = std::max(1, static_cast<int>(std::lround(scale * spec.height)));
  return resized(picture, {0, widest_px, 0, height_px});
}

OIIO::ImageBuf without_alpha(const OIIO::ImageBuf& picture) {
  if (picture.nchannels() <= 3) return picture;
  return OIIO::ImageBufAlgo::channels(picture, 3, std::array{0, 1, 2});
}

}  // namespace

std::string jpeg_of(const std::filesystem::path& picture, const PagePicture& form) {
  return jpeg_of(read_image(picture), form);
}

std::string jpeg_of(Image picture, const PagePicture& form) {
  const OIIO::ImageSpec spec(picture.width, picture.height, picture.channels,
                             OIIO::TypeDesc::FLOAT);
  const OIIO::ImageBuf read(spec, picture.values.data());
  OIIO::ImageBuf small = shrunk(without_alpha(read), form.widest_px);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  small.set_write_ioproxy(&memory);
  small.specmod().attribute("compression", fmt::format("jpeg:{}", form.quality));
  small.specmod().attribute("jpeg:subsampling", "4:2:0");
  if (!small.write("page.jpg", OIIO::TypeDesc::UINT8))
    throw FileError(fmt::format("cannot encode a picture: {}", small.geterror()));
  return {bytes.begin(), bytes.end()};
}

std::string data_uri(const std::string& type, const std::string& bytes) {
  return fmt::format("data:{};base64,{}", type, OIIO::Strutil::base64_encode(bytes));
}

}  // namespace wold
