#include "preview/ground_and_sky.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"
#include "expectation/bare_view.h"
#include "expectation/ground_march.h"
#include "landscape/raised_cast.h"

namespace wold::preview {
namespace {

using expectation::GroundMarch;
using landscape::Landscape;

/// How far the ground is in each pixel of a canvas; infinite where there is none. Every second
/// pixel of every second row is marched to from the eye; between such that differ little, a march
/// begins shortly before them.
class Distances {
 public:
  Distances(const GroundMarch& march, const landscape::Perspective& perspective,
            const Image& picture)
      : march_(march),
        perspective_(perspective),
        columns_((picture.width + 1) / 2),
        rows_((picture.height + 1) / 2),
        coarse_m_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    parallel_for(static_cast<std::size_t>(rows_), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < columns_; ++i) coarse_m_[index(i, j)] = marched_m(2 * i, 2 * j, 0.0);
    });
  }

  double at_m(int x, int y) const {
    const int i = x / 2, j = y / 2;
    const int right = std::min(i + x % 2, columns_ - 1), below = std::min(j + y % 2, rows_ - 1);
    if (x % 2 == 0 && y % 2 == 0) return coarse_m_[index(i, j)];
    const auto [near_m, far_m] =
        std::minmax({coarse_m_[index(i, j)], coarse_m_[index(right, j)], coarse_m_[index(i, below)],
                     coarse_m_[index(right, below)]});
    constexpr double max_ratio = 1.1;
    const bool is_even = far_m < max_ratio * near_m;
    return marched_m(x, y, is_even ? near_m / max_ratio : 0.0);
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(i);
  }
  double marched_m(int x, int y, double above_to_m) const {
    return march_.distance_m(perspective_.eye_m(), perspective_.direction({x + 0.5, y + 0.5}),
                             above_to_m);
  }

  const GroundMarch& march_;
  const landscape::Perspective& perspective_;
  int columns_;
  int rows_;
  std::vector<double> coarse_m_;
};

}  // namespace

void paint_ground_and_sky(const Landscape& landscape, const landscape::Perspective& perspective,
                          Canvas& canvas) {
  const GroundMarch march(landscape.terrain);
  const Distances distances(march, perspective, canvas.radiance);
  const landscape::RaisedCast boulders(landscape.boulders);
  parallel_for(static_cast<std::size_t>(canvas.radiance.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < canvas.radiance.width; ++x) {
      const glm::dvec3 direction = perspective.direction({x + 0.5, y + 0.5});
      const double ground_m =
          boulders.distance_m(perspective.eye_m(), direction, distances.at_m(x, y));
      const expectation::Hit hit =
          expectation::bare_view(landscape, perspective.eye_m(), direction, ground_m);
      std::copy_n(&hit.radiance.x, 3, canvas.radiance.pixel(x, y));
      canvas.depth_at(x, y) =
          static_cast<float>(hit.distance_m * perspective.depth_along(direction));
    }
  });
}

}  // namespace wold::preview
