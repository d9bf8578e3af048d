#include "cloud/ranks.h"

#include <algorithm>
#include <tuple>

#include "cloud/box_filter.h"

namespace wold::cloud {
namespace {

struct Pixel {
  float value;
  float around;  ///< mean of the surroundings
  std::uint32_t index;
};

/// Box filtered twice, which has no corners to show.
PeriodicMap<float> surroundings(const PeriodicMap<float>& field) {
  const int radius = std::max(1, std::min(field.width(), field.height()) / 16);
  return box_filtered(box_filtered(field, radius), radius);
}

/// All pixels, field after field.
std::vector<Pixel> pixels_of(const std::vector<PeriodicMap<float>>& fields) {
  std::vector<Pixel> pixels;
  for (const PeriodicMap<float>& field : fields) {
    const PeriodicMap<float> around = surroundings(field);
    for (std::size_t i = 0; i < around.values().size(); ++i)
      pixels.push_back(
          {field.values()[i], around.values()[i], static_cast<std::uint32_t>(pixels.size())});
  }
  return pixels;
}

}  // namespace

std::vector<PeriodicMap<float>> ranked(const std::vector<PeriodicMap<float>>& fields) {
  std::vector<Pixel> pixels = pixels_of(fields);
  std::sort(pixels.begin(), pixels.end(), [](const Pixel& a, const Pixel& b) {
    return std::tie(a.value, a.around, a.index) < std::tie(b.value, b.around, b.index);
  });
  std::vector<float> ranks(pixels.size());
  for (std::size_t place = 0; place < pixels.size(); ++place)
    ranks[pixels[place].index] =
        static_cast<float>((static_cast<double>(place) + 0.5) / static_cast<double>(pixels.size()));
  std::vector<PeriodicMap<float>> result;
  auto next = ranks.begin();
  for (const PeriodicMap<float>& field : fields) {
    PeriodicMap<float>& map = result.emplace_back(field.width(), field.height());
    const auto end = next + static_cast<std::ptrdiff_t>(map.values().size());
    std::copy(next, end, map.values().begin());
    next = end;
  }
  return result;
}

}  // namespace wold::cloud
