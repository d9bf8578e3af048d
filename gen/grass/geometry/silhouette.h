#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "grass/geometry/blade.h"

/// Silhouettes of bent blades, projected along a direction onto the plane of the ground and drawn
/// into a square of pixels that tiles like the patch.
namespace wold::grass {

/// A straight piece of a blade, or of the snow on it, in the patch's space, not wrapped.
struct Piece {
  std::uint32_t blade = 0;
  bool snow = false;
  glm::vec3 a_m{0.0F}, b_m{0.0F};  ///< ends of its axis
  glm::vec3 tangent{0.0F};
  glm::vec3 level{0.0F}, upper{0.0F};    ///< unit vectors along the axes of a ridge's section
  glm::vec2 half_m{0.0F};                ///< half its width and height; a blade's section is round
  float along_a = 0.0F, along_b = 0.0F;  ///< place on the blade: 0 root, 1 tip
};

/// Each blade's pieces, `segments` >= 1 of the blade itself and then those of its snow. A pose for
/// each blade.
std::vector<Piece> pieces_of(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                             int segments);

/// A piece on the ground's plane, in patches: the parallelogram from a - half to b + half.
struct Strip {
  glm::dvec2 a, b, half;
};

/// Seen along `direction` (unit, towards the eye, z > 0).
Strip strip_of(const Piece& piece, double patch_m, const glm::vec3& direction);

/// The whole numbers x in [first, end) for which linear functions of x lie between bounds.
class Run {
 public:
  Run(double first, double end) : first_(first), end_(end) {}
  /// Keeps x with low <= at_zero + slope x < high.
  void keep(double at_zero, double slope, double low, double high) {
    if (slope == 0.0) {
      if (at_zero < low || at_zero >= high) end_ = first_;
      return;
    }
    const double from = ((slope > 0.0 ? low : high) - at_zero) / slope;
    const double to = ((slope > 0.0 ? high : low) - at_zero) / slope;
    first_ = std::max(first_, std::ceil(from));
    end_ = std::min(end_, std::ceil(to));
  }
  /// Empty when end() <= first().
  int first() const { return static_cast<int>(first_); }
  int end() const { return static_cast<int>(end_); }

 private:
  double first_;
  double end_;
};

/// Calls visit(pixel, t) for the pixels of a side x side square whose centres lie in the strip; t
/// runs from 0 at a to 1 at b. Centres, because taking all that the strip touches would widen every
/// blade by a pixel.
template <class Visit>
void each_covered_pixel(int side, const Strip& strip, const Visit& visit) {
  const auto wrapped = [side](int i) {
    const int rest = i % side;
    return static_cast<std::size_t>(rest < 0 ? rest + side : rest);
  };
  const glm::dvec2 along = strip.b - strip.a;
  const double area = along.x * strip.half.y - along.y * strip.half.x;
  if (area == 0.0) return;
  const glm::dvec2 reach = (glm::abs(along) + 2.0 * glm::abs(strip.half)) * (side / 2.0);
  const glm::dvec2 middle = (strip.a + strip.b) * (side / 2.0);
  const glm::dvec2 first = glm::ceil(middle - reach - 0.5);
  const glm::dvec2 end = glm::floor(middle + reach + 0.5);
  const double pixel = 1.0 / side;
  for (auto y = static_cast<int>(first.y); y < static_cast<int>(end.y); ++y) {
    // Along the row, both coordinates in the parallelogram are linear in x.
    const glm::dvec2 from_a = glm::dvec2(0.5 * pixel, (y + 0.5) * pixel) - strip.a;
    const double t0 = (from_a.x * strip.half.y - from_a.y * strip.half.x) / area;
    const double t_step = pixel * strip.half.y / area;
    Run run(first.x, end.x);
    run.keep(t0, t_step, 0.0, 1.0);
    run.keep((along.x * from_a.y - along.y * from_a.x) / area, -pixel * along.y / area, -1.0, 1.0);
    const std::size_t row = wrapped(y) * static_cast<std::size_t>(side);
    for (int x = run.first(); x < run.end(); ++x) visit(row + wrapped(x), t0 + t_step * x);
  }
}

}  // namespace wold::grass
