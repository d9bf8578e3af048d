#include "landscape/box_tree.h"

#include <cmath>
#include <numeric>

namespace wold::landscape {

BoxTree::BoxTree(std::span<const Box> boxes) : things_(boxes.size()) {
  std::iota(things_.begin(), things_.end(), 0U);
  if (!boxes.empty()) build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
}

/// Halves by the boxes' middles along the longest side.
void BoxTree::build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t count) {
  constexpr std::uint32_t few = 4;
  const std::size_t number = nodes_.size();
  nodes_.emplace_back();
  Box box;
  for (std::uint32_t i = first; i < first + count; ++i) box.add(boxes[things_[i]]);
  nodes_[number].box = box;
  if (count <= few) {
    nodes_[number].first = first;
    nodes_[number].count = count;
    return;
  }
  const glm::vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto place = [&](std::uint32_t thing) {
    return std::pair(boxes[thing].low[axis] + boxes[thing].high[axis], thing);
  };
  const auto begin = things_.begin() + first;
  std::sort(begin, begin + count,
            [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  build(boxes, first, count / 2);
  nodes_[number].other = static_cast<std::uint32_t>(nodes_.size());
  build(boxes, first + count / 2, count - count / 2);
}

bool BoxTree::meets(const Box& box, const glm::dvec3& start, const glm::dvec3& inverse,
                    double end_m) {
  double from_m = 0.0, to_m = end_m;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (double{box.low[axis]} - start[axis]) * inverse[axis];
    const double b = (double{box.high[axis]} - start[axis]) * inverse[axis];
    if (std::isnan(a) || std::isnan(b)) continue;  // it goes along a side
    from_m = std::max(from_m, std::min(a, b));
    to_m = std::min(to_m, std::max(a, b));
  }
  return from_m <= to_m;
}

}  // namespace wold::landscape
