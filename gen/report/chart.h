#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "report/chart_axis.h"
#include "report/svg.h"

/// Figures of panels with axes and lines, whatever they show, drawn as SVG.
namespace wold::report::chart {

/// How a line stands in the legend: by a piece of it, or by an area of its colour. The latter is
/// for colours that are what the line shows; such a line is outlined.
enum class KeyShape { line, swatch };

struct Line {
  std::string label;  ///< empty: not in the legend
  std::vector<glm::dvec2> points;
  SvgStroke stroke;
  KeyShape key = KeyShape::line;
};

struct Panel {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Line> lines;        ///< the last is on top
  std::string legend_title = {};  ///< stands before the legend; may be empty
};

/// Panels row by row; each is given its letter: (a), (b), ...
struct Figure {
  std::string title;
  std::string subtitle;
  std::vector<Panel> panels;
  int columns = 3;
  glm::dvec2 plot_px{340.0, 236.0};  ///< what the axes of a panel enclose
};

/// The figure as an SVG file. Throws std::invalid_argument when it has no panels or columns, or
/// when a line leaves its axes, naming panel and line.
std::string svg(const Figure& figure);

}  // namespace wold::report::chart
