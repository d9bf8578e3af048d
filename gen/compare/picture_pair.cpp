#include "compare/picture_pair.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/images.h"
#include "compare/pixels.h"
#include "core/files.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
constexpr float difference_gain = 10.0F;

Json to_json(const Image& image, const ImageMetrics& metrics) {
  Json json = {{"width", image.width}, {"height", image.height}, {"channels", image.channels}};
  json.update(to_json(static_cast<const Differences&>(metrics)));
  json["worst_px"] = {metrics.worst_px.x, metrics.worst_px.y};
  json["psnr_db"] = metrics.psnr_db;  // JSON has no infinity: null for equal pictures
  json["ssim"] = metrics.ssim;
  json["flip"] = metrics.flip;
  json["mean_shift"] = metrics.mean_shift;
  json["mean_abs_blurred8"] = metrics.mean_abs_blurred8;
  json["mean_delta_e"] = metrics.mean_delta_e;
  return json;
}

}  // namespace

Evidence shown_picture(const fs::path& folder, const std::string& caption, const std::string& name,
                       const Image& image) {
  const int channels = std::min(image.channels, 4);
  const auto copy = [&](float* out, const float* pixel) { std::copy_n(pixel, channels, out); };
  make_folder(folder);
  write_image(folder / name, pixelwise(channels, copy, image), PixelFormat::uint8);
  return {caption, folder / name};
}

Comparison compare_pictures(const fs::path& got_path, const fs::path& want_path,
                            const Limits& limits, const fs::path& evidence_folder) {
  const Image got = read_image(got_path);
  const Image want = read_image(want_path);
  Comparison result;
  const auto show = [&](const std::string& caption, const std::string& name, const Image& image) {
    if (!evidence_folder.empty())
      result.evidence.push_back(shown_picture(evidence_folder, caption, name, image));
  };
  show("got", "got.png", got);
  show("want", "want.png", want);
  if (std::string why = shape_difference(got, want); !why.empty()) {
    result.faults.push_back(std::move(why));
    return result;
  }
  const ImageMetrics metrics = compare_images(got, want, limits.soft);
  result.metrics = to_json(got, metrics);
  result.measures = measures(metrics, limits);
  show("difference, times 10", "difference.png", difference_image(got, want, difference_gain));
  show("FLIP: what an eye sees differ", "flip.png", flip_picture(metrics.flip_map));
  return result;
}

}  // namespace wold::compare
