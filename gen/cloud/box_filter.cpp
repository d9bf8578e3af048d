#include "cloud/box_filter.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"

namespace wold::cloud {
namespace {

/// Means along a row, by a running sum.
void filter_row(const PeriodicMap<float>& map, int y, int radius, PeriodicMap<float>& result) {
  double sum = 0.0;
  for (int x = -radius; x <= radius; ++x) sum += map.wrapped(x, y);
  for (int x = 0; x < map.width(); ++x) {
    result.at(x, y) = static_cast<float>(sum / (2 * radius + 1));
    sum += map.wrapped(x + radius + 1, y) - map.wrapped(x - radius, y);
  }
}

/// Means along the columns [from, to), all of them at once, as they lie side by side in memory.
void filter_columns(const PeriodicMap<float>& map, int from, int to, int radius,
                    PeriodicMap<float>& result) {
  std::vector<double> sums(static_cast<std::size_t>(to - from));
  const auto add = [&](long y, double factor) {
    const float* row = &map.wrapped(from, y);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += factor * static_cast<double>(row[i]);
  };
  for (int y = -radius; y <= radius; ++y) add(y, 1.0);
  for (int y = 0; y < map.height(); ++y) {
    for (std::size_t i = 0; i < sums.size(); ++i)
      result.at(from + static_cast<int>(i), y) = static_cast<float>(sums[i] / (2 * radius + 1));
    add(y + radius + 1, 1.0);
    add(y - radius, -1.0);
  }
}

}  // namespace

PeriodicMap<float> box_filtered(const PeriodicMap<float>& map, int radius) {
  if (radius <= 0) return map;
  PeriodicMap<float> along(map.width(), map.height()), result(map.width(), map.height());
  parallel_for(static_cast<std::size_t>(map.height()),
               [&](std::size_t y) { filter_row(map, static_cast<int>(y), radius, along); });
  constexpr int strip = 256;
  parallel_for(static_cast<std::size_t>((map.width() + strip - 1) / strip), [&](std::size_t i) {
    const int from = static_cast<int>(i) * strip;
    filter_columns(along, from, std::min(from + strip, map.width()), radius, result);
  });
  return result;
}

int tops_radius_px(double thickness_px, int side_px) {
  constexpr double radius = 0.08;  // of the thickness
  return std::min(static_cast<int>(std::lround(radius * thickness_px)), (side_px - 1) / 2);
}

std::vector<PeriodicMap<float>> with_halves(PeriodicMap<float> map) {
  constexpr int few_px = 8;
  std::vector<PeriodicMap<float>> maps;
  maps.push_back(std::move(map));
  for (;;) {
    const PeriodicMap<float>& fine = maps.back();
    if (fine.width() % 2 != 0 || fine.height() % 2 != 0) return maps;
    if (std::min(fine.width(), fine.height()) <= few_px) return maps;
    PeriodicMap<float> half(fine.width() / 2, fine.height() / 2);
    for (int y = 0; y < half.height(); ++y)
      for (int x = 0; x < half.width(); ++x)
        half.at(x, y) = 0.25F * (fine.at(2 * x, 2 * y) + fine.at(2 * x + 1, 2 * y) +
                                 fine.at(2 * x, 2 * y + 1) + fine.at(2 * x + 1, 2 * y + 1));
    maps.push_back(std::move(half));
  }
}

PeriodicMap<float> smoothed_for_tops(const PeriodicMap<float>& map, double thickness_px) {
  const int radius_px = tops_radius_px(thickness_px, std::min(map.width(), map.height()));
  return box_filtered(box_filtered(map, radius_px), radius_px);
}

}  // namespace wold::cloud
