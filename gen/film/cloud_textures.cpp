#include "film/cloud_textures.h"

#include <fmt/format.h>

#include "cloud/compose.h"
#include "core/colour.h"
#include "core/files.h"
#include "core/image.h"
#include "core/parallel.h"

namespace wold::film {
namespace {

/// From linear colours that are multiplied by alpha to encoded ones that are not.
void encode(Image& picture) {
  parallel_for_blocks(picture.values.size() / 4, [&](std::size_t i) {
    float* pixel = &picture.values[4 * i];
    for (int c = 0; c < 3; ++c)
      pixel[c] =
          pixel[3] > 0.0F ? static_cast<float>(srgb_encoded(double{pixel[c] / pixel[3]})) : 0.0F;
  });
}

}  // namespace

std::vector<std::filesystem::path> write_cloud_textures(const cloud::Clouds& clouds,
                                                        const std::filesystem::path& folder) {
  const cloud::CloudState state = clouds.at(0.0);
  make_folder(folder);
  std::vector<std::filesystem::path> files(state.layers.size());
  parallel_for(state.layers.size(), [&](std::size_t i) {
    cloud::LayerState layer = state.layers[i];
    layer.moment = {};
    layer.next_map = nullptr;
    Image picture = cloud::layer_picture(layer, state.pixel_m);
    encode(picture);
    files[i] = folder / fmt::format("layer_{}.png", layer.layer->number);
    write_image(files[i], picture, PixelFormat::uint8);
  });
  return files;
}

}  // namespace wold::film
