#include "shutter/motion_blur.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/parallel.h"

namespace wold::shutter {
namespace {

/// What goes less far while the shutter is open stays sharp.
constexpr double still_px = 0.05;
constexpr double most_moments = 128.0;
/// Steps of following a motion back; it hardly changes from one to the next.
constexpr int steps = 4;
/// How near a place has to come to the pixel at a moment to be what stands there, and to be looked
/// for no longer.
constexpr float close_px = 0.5F;
constexpr float near_enough_px = 0.05F;

/// The fastest motion in each square of pixels and the eight around it ([McGuire2012]): squares are
/// so large that nothing farther away reaches a pixel of theirs, up to a sixteenth of the picture.
/// What moves farther hides only what lies within two squares of it.
class FastestNearby {
 public:
  FastestNearby(const MotionField& field, double shutter)
      : side_px_(side_px(field, shutter)),
        columns_((field.width + side_px_ - 1) / side_px_),
        rows_((field.height + side_px_ - 1) / side_px_),
        fastest_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    std::vector<glm::vec2> own(fastest_.size());
    for (int y = 0; y < field.height; ++y)
      for (int x = 0; x < field.width; ++x)
        keep_faster(own[square(x / side_px_, y / side_px_)], field.motion_px[field.index(x, y)]);
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        fastest_[square(column, row)] = fastest_around(own, column, row);
  }

  const glm::vec2& at(int x, int y) const { return fastest_[square(x / side_px_, y / side_px_)]; }

 private:
  static int side_px(const MotionField& field, double shutter) {
    glm::vec2 fastest(0.0F);
    for (const glm::vec2& motion : field.motion_px) keep_faster(fastest, motion);
    const double reach_px = 0.5 * shutter * glm::length(glm::dvec2(fastest));
    const double most_px = std::max(16.0, std::max(field.width, field.height) / 16.0);
    return static_cast<int>(std::clamp(std::ceil(reach_px), 1.0, most_px));
  }
  static void keep_faster(glm::vec2& fastest, const glm::vec2& motion) {
    if (glm::length(glm::dvec2(motion)) > glm::length(glm::dvec2(fastest))) fastest = motion;
  }
  std::size_t square(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  glm::vec2 fastest_around(const std::vector<glm::vec2>& own, int column, int row) const {
    glm::vec2 fastest(0.0F);
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows_ - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns_ - 1); ++x)
        keep_faster(fastest, own[square(x, y)]);
    return fastest;
  }

  int side_px_, columns_, rows_;
  std::vector<glm::vec2> fastest_;
};

/// A place of the sharp picture that may stand at a pixel at another moment.
struct Candidate {
  glm::vec2 at_px{0.0F};
  float depth_m = 0.0F;
  bool is_there = false;  ///< its motion leads to the pixel
};

/// Of two places the one that is seen: what is nearer hides what is there too; of places that are
/// not there the farther one.
const Candidate& seen(const Candidate& a, const Candidate& b) {
  if (a.is_there != b.is_there) return a.is_there ? a : b;
  return (a.depth_m <= b.depth_m) == a.is_there ? a : b;
}

class Exposure {
 public:
  Exposure(const Image& sharp, const MotionField& field, double shutter)
      : sharp_(sharp), field_(field), shutter_(shutter), fastest_(field, shutter) {}

  void expose(int x, int y, float* blurred) const {
    const glm::vec2 fastest = fastest_.at(x, y);
    const double length_px = shutter_ * glm::length(glm::dvec2(fastest));
    if (length_px < still_px) {
      std::copy_n(sharp_.pixel(x, y), sharp_.channels, blurred);
      return;
    }
    const int moments = static_cast<int>(std::min(std::ceil(length_px) + 1.0, most_moments));
    for (int i = 0; i < moments; ++i) {
      const double moment = shutter_ * ((i + 0.5) / moments - 0.5);
      const glm::vec2 at_px = place_seen({x, y}, static_cast<float>(moment), fastest);
      add(at_px, 1.0F / static_cast<float>(moments), blurred);
    }
  }

 private:
  /// Where in the sharp picture that is which stands at a pixel at a moment.
  glm::vec2 place_seen(const glm::vec2& pixel, float moment, const glm::vec2& fastest) const {
    const glm::vec2& own = field_.motion_px[index(pixel)];
    const Candidate by_own = followed_back(pixel, moment, own);
    if (own == fastest) return by_own.at_px;
    return seen(by_own, followed_back(pixel, moment, fastest)).at_px;
  }

  Candidate followed_back(const glm::vec2& pixel, float moment, glm::vec2 motion) const {
    Candidate best{pixel, -1.0F, false};
    for (int step = 0; step < steps; ++step) {
      const glm::vec2 at_px = pixel - moment * motion;
      motion = field_.motion_px[index(at_px)];
      const float off_px = glm::length(at_px + moment * motion - pixel);
      const Candidate found{at_px, field_.depth_m[index(at_px)], off_px < close_px};
      best = found.is_there ? found : seen(best, found);
      if (off_px < near_enough_px) break;
    }
    return best;
  }

  std::size_t index(const glm::vec2& at_px) const {
    const glm::vec2 last(field_.width - 1, field_.height - 1);
    const glm::ivec2 nearest(glm::clamp(glm::round(at_px), glm::vec2(0.0F), last));
    return field_.index(nearest.x, nearest.y);
  }

  /// Adds the sharp picture between its pixels.
  void add(const glm::vec2& at_px, float weight, float* sum) const {
    const glm::vec2 last(sharp_.width - 1, sharp_.height - 1);
    const glm::vec2 inside = glm::clamp(at_px, glm::vec2(0.0F), last);
    const glm::ivec2 low(inside), high = glm::min(low + 1, glm::ivec2(last));
    const glm::vec2 share = inside - glm::vec2(low);
    const float* rows[2][2] = {{sharp_.pixel(low.x, low.y), sharp_.pixel(high.x, low.y)},
                               {sharp_.pixel(low.x, high.y), sharp_.pixel(high.x, high.y)}};
    for (int c = 0; c < sharp_.channels; ++c) {
      const float above = glm::mix(rows[0][0][c], rows[0][1][c], share.x);
      const float below = glm::mix(rows[1][0][c], rows[1][1][c], share.x);
      sum[c] += weight * glm::mix(above, below, share.y);
    }
  }

  const Image& sharp_;
  const MotionField& field_;
  double shutter_;
  FastestNearby fastest_;
};

}  // namespace

Image motion_blurred(const Image& sharp, const MotionField& field, double shutter) {
  if (sharp.width != field.width || sharp.height != field.height)
    throw std::invalid_argument("motion_blurred: the picture and its motions differ in size");
  const Exposure exposure(sharp, field, shutter);
  Image blurred(sharp.width, sharp.height, sharp.channels);
  parallel_for(static_cast<std::size_t>(sharp.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < sharp.width; ++x) exposure.expose(x, y, blurred.pixel(x, y));
  });
  return blurred;
}

}  // namespace wold::shutter
