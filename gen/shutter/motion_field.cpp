#include "shutter/motion_field.h"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string>

#include "core/error.h"
#include "core/layered_image.h"

namespace wold::shutter {
namespace {

std::span<const float> finite_channel(const LayeredImage& image, const std::string& name,
                                      const std::filesystem::path& file) {
  const ImageChannel* channel = image.find(name);
  if (channel == nullptr)
    throw FileError(
        fmt::format("{} has no \"{}\"; `wold passes` with --passes depth,motion makes it",
                    file.string(), name));
  for (const float value : channel->values)
    if (!std::isfinite(value))
      throw FileError(
          fmt::format("{}: \"{}\" holds {}, expected finite numbers", file.string(), name, value));
  return channel->values;
}

}  // namespace

MotionField read_motion_field(const std::filesystem::path& passes) {
  const LayeredImage image = read_layered_image(passes);
  const std::span<const float> right = finite_channel(image, "motion.X", passes);
  const std::span<const float> down = finite_channel(image, "motion.Y", passes);
  const std::span<const float> depth = finite_channel(image, "depth.Z", passes);
  MotionField field{image.width, image.height, {}, {depth.begin(), depth.end()}};
  field.motion_px.reserve(right.size());
  for (std::size_t i = 0; i < right.size(); ++i) field.motion_px.emplace_back(right[i], down[i]);
  return field;
}

}  // namespace wold::shutter
