#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/interpolation.h"
#include "core/parallel.h"

namespace wold {

/// A square part of the ground: metres from the terrain's south-western corner, x east, y north.
struct Square {
  glm::dvec2 corner_m{0.0};
  double size_m = 0.0;

  bool contains(const glm::dvec2& at_m) const {
    return glm::all(glm::greaterThanEqual(at_m, corner_m)) &&
           glm::all(glm::lessThanEqual(at_m, corner_m + size_m));
  }
};

/// A square map of the terrain, or of a part of it: `samples` x `samples` values on the corners of
/// a regular grid that covers the square. Value (i, j) lies at the square's corner, which is mostly
/// the terrain's, plus (i, j) * step (x east, y north), stored with i fastest. Maps of values of
/// the same type that mean something else have a `Meaning` of their own: one is no other's.
template <class T, class Meaning = void>
class GroundMap {
 public:
  GroundMap() = default;
  GroundMap(int samples, double size_m, T value = {})
      : GroundMap(samples, Square{.size_m = size_m}, value) {}
  GroundMap(int samples, const Square& square, T value = {})
      : samples_(samples),
        size_m_(square.size_m),
        corner_m_(square.corner_m),
        values_(static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples), value) {
    if (samples < 2 || !(size_m_ > 0.0))
      throw std::invalid_argument(
          "a ground map needs at least 2 samples and a positive size, got " +
          std::to_string(samples) + " and " + std::to_string(size_m_));
  }

  int samples() const { return samples_; }
  double size_m() const { return size_m_; }
  double step_m() const { return size_m_ / (samples_ - 1); }
  const glm::dvec2& corner_m() const { return corner_m_; }
  Square square() const { return {corner_m_, size_m_}; }
  /// Where value (i, j) lies.
  glm::dvec2 place_m(int i, int j) const { return corner_m_ + glm::dvec2(i, j) * step_m(); }
  /// The same map with its corner elsewhere.
  GroundMap at_corner(const glm::dvec2& corner_m) && {
    corner_m_ = corner_m;
    return std::move(*this);
  }
  T& at(int i, int j) { return values_[index(i, j)]; }
  const T& at(int i, int j) const { return values_[index(i, j)]; }
  const std::vector<T>& values() const { return values_; }
  std::vector<T>& values() { return values_; }

  /// Bilinear value at (x_m, y_m); outside the map the border's value.
  T sample(double x_m, double y_m) const {
    const double fx = std::clamp((x_m - corner_m_.x) / step_m(), 0.0, samples_ - 1.0);
    const double fy = std::clamp((y_m - corner_m_.y) / step_m(), 0.0, samples_ - 1.0);
    const int i = std::min(static_cast<int>(fx), samples_ - 2);
    const int j = std::min(static_cast<int>(fy), samples_ - 2);
    const auto u = static_cast<float>(fx - i);
    const auto v = static_cast<float>(fy - j);
    return bilinear(at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), u, v);
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(samples_) +
           static_cast<std::size_t>(i);
  }

  int samples_ = 0;
  double size_m_ = 0.0;
  glm::dvec2 corner_m_{0.0};
  std::vector<T> values_;
};

/// Samples along a side of a map with this step, or as many as a picture should have.
inline int map_samples(double size_m, double step_m) {
  constexpr double max = 4097.0;
  return static_cast<int>(std::min(max, std::ceil(size_m / step_m - 1e-9) + 1.0));
}

/// Where the values of a map of a part of the ground lie.
struct GroundGrid {
  Square square;
  int samples = 2;

  double step_m() const { return square.size_m / (samples - 1); }
};

/// How much of something of size `feature_m` a map with this step shows: all up to half of it,
/// nothing from twice of it on, where single values would be chance.
inline double shown_fraction(double feature_m, double step_m) {
  return 1.0 - glm::smoothstep(0.5, 2.0, step_m / feature_m);
}

/// `map` times `factor` on the map's square, with the more samples of the two.
template <class T, class Meaning, class Factor, class FactorMeaning>
GroundMap<T, Meaning> product(const GroundMap<T, Meaning>& map,
                              const GroundMap<Factor, FactorMeaning>& factor) {
  GroundMap<T, Meaning> result(std::max(map.samples(), factor.samples()), map.square());
  parallel_for(static_cast<std::size_t>(result.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < result.samples(); ++i) {
      const glm::dvec2 at_m = result.place_m(i, j);
      result.at(i, j) = map.sample(at_m.x, at_m.y) * factor.sample(at_m.x, at_m.y);
    }
  });
  return result;
}

/// The same, in place where `map` has enough samples: it takes its values as they are.
template <class T, class Meaning, class Factor, class FactorMeaning>
GroundMap<T, Meaning> product(GroundMap<T, Meaning>&& map,
                              const GroundMap<Factor, FactorMeaning>& factor) {
  if (map.samples() < factor.samples()) return product(std::as_const(map), factor);
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      map.at(i, j) *= factor.sample(at_m.x, at_m.y);
    }
  });
  return std::move(map);
}

/// One pass of the binomial filter 1 2 1 along both axes; the border keeps its value beyond itself.
template <class T, class Meaning>
void smooth(GroundMap<T, Meaning>& map) {
  const GroundMap<T, Meaning> old = map;
  const auto inside = [&](int i) { return std::clamp(i, 0, old.samples() - 1); };
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      T sum{};
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di)
          sum += old.at(inside(i + di), inside(j + dj)) *
                 static_cast<float>((2 - std::abs(di)) * (2 - std::abs(dj)));
      map.at(i, j) = sum / 16.0F;
    }
  });
}

/// Terrain heights in metres above the scene's zero.
using Heightfield = GroundMap<float, struct Heights>;
/// Linear RGB per ground point.
using ColourMap = GroundMap<glm::vec3>;
/// A fraction, a factor or another number that is no height per ground point.
using FactorMap = GroundMap<float>;

}  // namespace wold
