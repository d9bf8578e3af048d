#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/image.h"

namespace wold::snow {

/// Where a drawing lies on a canvas: at = turned * p + moved.
struct Placing {
  glm::dmat2 turned{1.0};
  glm::dvec2 moved{0.0};
};

/// Opacity drawn finely on the square [-1, 1]^2, x to the right, y up. What is drawn twice keeps
/// the higher opacity, as one body does; other bodies are laid over.
class Canvas {
 public:
  explicit Canvas(int side_px);

  /// What is drawn from now on is placed so.
  void place(const Placing& placing) { placing_ = placing; }
  /// A bar with round ends, half as wide as `width`, tapering to `end_width`; opaque along its
  /// ridge, a bit less so along its sides. Thinner than a sample it is fainter instead.
  void stroke(const glm::dvec2& from, const glm::dvec2& to, double width, double end_width,
              double opacity);
  /// A convex polygon, its corners anticlockwise before it is placed.
  void polygon(const std::vector<glm::dvec2>& corners, double opacity);

  /// Lays another body of the same size over this one.
  void lay_over(const Canvas& other);

  /// As a picture: every pixel the mean of its samples, transparent along its border.
  Image picture() const;

 private:
  /// Raises the samples between two corners to `opacity(at)`.
  template <class Opacity>
  void raise(const glm::dvec2& low, const glm::dvec2& high, const Opacity& opacity);
  static constexpr int samples = 3;  ///< along a pixel's side
  int side_;                         ///< in samples
  std::vector<float> values_;
  Placing placing_;
};

}  // namespace wold::snow
