#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace wold::landscape {

/// A box along the axes; empty at first.
struct Box {
  glm::vec3 low{std::numeric_limits<float>::max()};
  glm::vec3 high{std::numeric_limits<float>::lowest()};

  void add(const glm::vec3& at) {
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  void add(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
};

/// Things by the boxes they lie in, as a tree of boxes: rays look only at things whose boxes they
/// meet.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes);

  /// Calls visit(thing) for things, by their places in `boxes`, that the ray start + m * along may
  /// meet between 0 and `end_m`. What visit() returns is the end from then on.
  template <class Visit>
  void follow(const glm::dvec3& start, const glm::dvec3& along, double end_m,
              const Visit& visit) const;

  const Box& box() const { return nodes_.front().box; }
  bool is_empty() const { return things_.empty(); }

 private:
  /// Of things [first, first + count), or, where that is 0, of the node behind it and of `other`.
  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;
    std::uint32_t other = 0;
  };

  void build(std::span<const Box> boxes, std::uint32_t first, std::uint32_t count);
  static bool meets(const Box& box, const glm::dvec3& start, const glm::dvec3& inverse,
                    double end_m);

  std::vector<std::uint32_t> things_;
  std::vector<Node> nodes_;
};

template <class Visit>
void BoxTree::follow(const glm::dvec3& start, const glm::dvec3& along, double end_m,
                     const Visit& visit) const {
  if (is_empty()) return;
  const glm::dvec3 inverse = 1.0 / along;
  std::array<std::uint32_t, 64> waiting;  // halves: 64 are enough for 2^63 things
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    const Node& node = nodes_[number];
    if (!meets(node.box, start, inverse, end_m)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) end_m = visit(things_[i]);
    if (node.count > 0) continue;
    waiting[count++] = node.other;
    waiting[count++] = number + 1;
  }
}

}  // namespace wold::landscape
