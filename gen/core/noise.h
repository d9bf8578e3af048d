#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace wold {

/// Gradient noise (Perlin 1985, with the quintic fade of Perlin 2002): a smooth field that is zero
/// on the integer lattice, has features of size 1 and stays within +-sqrt(1/2). The unit gradients
/// (256 directions) are keyed by `key` and the lattice point. With period > 0 the field repeats
/// exactly after `period` units in x and y.
double gradient_noise(const glm::dvec2& at, std::uint64_t key, int period = 0);

/// The same with a period of its own along each axis, for features that are longer than wide.
double gradient_noise(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period);

/// A height of noise and its steepest ascent, per unit of length.
struct NoiseSlope {
  double value = 0.0;
  glm::dvec2 gradient{0.0};
};

/// Gradient noise without a period, and its gradient; another field than gradient_noise().
NoiseSlope gradient_noise_slope(const glm::dvec2& at, std::uint64_t key);

/// Cellular noise (Worley 1996, A cellular texture basis function): the distance, in cells, to the
/// nearest of the points that lie one in each unit cell, keyed by `key` and the cell; in [0, 1.5).
/// The field repeats exactly after `period` > 0 cells.
double cell_noise(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period);

/// Domes of different sizes on the points of cellular noise: the highest of r^2 - d^2 over all
/// points, d the distance to one, in cells, and r the radius of its dome (the power diagram of
/// Aurenhammer 1987). ln r^2 is spread evenly over +-spread, which lies in [0, 0.75]. The field
/// repeats exactly after `period` > 0 cells.
double dome_noise(const glm::dvec2& at, std::uint64_t key, const glm::ivec2& period, double spread);

/// Standard deviation of gradient_noise over the plane: closed form for unit gradients and the
/// quintic fade s, 2 sqrt(A B) with A = integral of u^2 (1 - s)^2 and B = integral of s^2 on [0,
/// 1].
inline constexpr double gradient_noise_deviation = 0.21571;

/// Fractional Brownian motion: octaves of gradient noise, each of half the size and 2^-hurst the
/// height of the one before (Mandelbrot and Van Ness 1968; Musgrave 1993). Octaves are shifted
/// against each other by keyed offsets, so no lattice point is special.
class Fbm {
 public:
  /// hurst: 1 smooth, 0.5 rugged; the variogram grows with distance^(2 hurst). With period > 0 the
  /// field repeats after that many units, without it never.
  explicit Fbm(std::uint64_t key, int octaves = 6, double hurst = 0.9, int period = 0);

  /// The field at a place, in units of its largest feature; mean 0, standard deviation 1.
  double at(const glm::dvec2& at) const;

 private:
  struct Octave {
    double scale, height;
    glm::dvec2 shift;
    std::uint64_t field;  ///< random bits that all corners of its lattice share
    int period;
  };

  std::vector<Octave> octaves_;
  double deviation_ = 1.0;
};

/// A field without a preferred size: fBm from features of `largest_m` down to some of
/// `smallest_m`, of which a map with steps of `step_m` shows what is larger than them. All octaves
/// together have deviation 1.
class ScaleFreeNoise {
 public:
  struct Sizes {
    double largest_m, smallest_m;
  };
  ScaleFreeNoise(std::uint64_t key, const Sizes& sizes, double hurst, double step_m);

  /// Of mean 0 and variance shown().
  double at(const glm::dvec2& at_m) const;
  /// What a map with steps of `step_m` shows of it; of a field that was made for one with steps of
  /// 0, or little is left of the finest features.
  double at(const glm::dvec2& at_m, double step_m) const;
  /// In [0, 1].
  double shown() const { return shown_; }
  /// The variance of at(at_m, step_m), in [0, 1].
  double shown(double step_m) const;

 private:
  struct Octave {
    double feature_m, height;
    glm::dvec2 shift;
    std::uint64_t field;  ///< random bits that all corners of its lattice share
  };

  std::vector<Octave> octaves_;
  double shown_ = 0.0;
};

}  // namespace wold
