#include <cstdint>
#include <cstdlib>

#include "core/error.h"
#include "core/image.h"
#include "scratch_file.h"

/// Any bytes are a picture or an error; a picture has as many numbers as it says. The first kind
/// that takes the bytes reads them: PNG, OpenEXR, JPEG, TIFF, Radiance HDR.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  using namespace wold;
  const fuzz::ScratchFile file(bytes, count);
  try {
    const ImageHeader header = read_image_header(file.path());
    constexpr double max = 1 << 22;  // more is right, but slow here
    if (1.0 * header.width * header.height * header.channels > max) return 0;
    const Image image = read_image(file.path());
    const auto numbers = static_cast<std::size_t>(image.width) *
                         static_cast<std::size_t>(image.height) *
                         static_cast<std::size_t>(image.channels);
    if (image.values.size() != numbers || image.width != header.width) std::abort();
  } catch (const FileError&) {
  }
  return 0;
}
