#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace wold::wind {

/// A sum of plane waves over the ground: at a place sum height cos(2 pi (k . place + phase)).
/// Places are in metres, k in turns per metre, phases in turns.
class WaveSum {
 public:
  void add(const glm::dvec2& per_m, double phase, double height);
  /// Within 1e-6 of the sum of the heights; some 2 ns per wave.
  double at(const glm::dvec2& place_m) const;

 private:
  static constexpr std::size_t lanes = 8;
  /// Some of the waves, so that loops over them have no branches; those that are missing have
  /// height 0.
  struct Group {
    std::array<double, lanes> east_per_m{}, north_per_m{}, phase{};
    std::array<float, lanes> height{};
  };
  std::vector<Group> groups_;
  std::size_t count_ = 0;
};

}  // namespace wold::wind
