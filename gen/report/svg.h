#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

namespace wold::report {

/// The pen of a line or an outline.
struct SvgStroke {
  std::string colour = "#000000";
  double width_px = 1.0;
  std::string dash = {};  ///< lengths of dashes and gaps in px; empty: solid
};

enum class SvgAnchor { start, middle, end };

struct SvgTextStyle {
  double size_px = 12.0;
  std::string colour = "#000000";
  SvgAnchor anchor = SvgAnchor::start;
  bool bold = false;
  bool upwards = false;  ///< turned by 90 degrees, reading from bottom to top
};

/// "#rrggbb" of an encoded sRGB colour, channels in [0, 1].
std::string svg_colour(const glm::dvec3& srgb);

/// A drawing in SVG 1.1 on white paper, as text. Pixels, x to the right, y down. All text is
/// escaped; the same calls give the same bytes in every locale.
class SvgDrawing {
 public:
  /// `title` is what a browser shows and a screen reader says.
  SvgDrawing(const glm::dvec2& size_px, std::string_view title);

  void line(const glm::dvec2& from, const glm::dvec2& to, const SvgStroke& stroke);
  void polyline(std::span<const glm::dvec2> points, const SvgStroke& stroke);
  void rectangle(const glm::dvec2& corner, const glm::dvec2& size, std::string_view fill,
                 const SvgStroke& outline);
  /// `at` is on the base line.
  void text(const glm::dvec2& at, std::string_view text, const SvgTextStyle& style);

  /// The whole file.
  std::string file() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

/// Width of a line of text, on the safe side, since the reader's font is not known: 0.62 of the
/// size per letter, where words and numbers were measured to take at most 0.53 in Liberation Sans
/// (as wide as Arial) and 0.60 in DejaVu Sans.
double svg_text_width_px(std::string_view text, double size_px);

}  // namespace wold::report
