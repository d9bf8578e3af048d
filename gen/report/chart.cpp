#include "report/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace wold::report::chart {
namespace {

// Sizes in px.
constexpr double margin = 18.0;
constexpr double figure_title_size = 17.0;
constexpr double subtitle_size = 12.5;
constexpr double panel_title_size = 13.5;
constexpr double text_size = 11.5;
constexpr double line_height = 18.0;
constexpr double tick_length = 4.0;
constexpr double gap = 7.0;
constexpr double column_gap = 24.0;
constexpr double row_gap = 22.0;
constexpr double line_key_width = 30.0;
constexpr double swatch_key_width = 20.0;
constexpr double swatch_height = 12.0;
constexpr double key_gap = 12.0;
/// From the middle of a line of text to its base line.
constexpr double to_base = 0.36 * text_size;

const SvgStroke axis_stroke{.colour = "#333333", .width_px = 1.0};
const SvgStroke grid_stroke{.colour = "#e3e3e3", .width_px = 1.0};
/// Around colours that mean something: they may be as pale as the paper.
const SvgStroke outline{.colour = "#666666", .width_px = 0.5};
constexpr const char* text_colour = "#222222";

SvgTextStyle style(double size_px, SvgAnchor anchor = SvgAnchor::start, bool bold = false) {
  return {.size_px = size_px, .colour = text_colour, .anchor = anchor, .bold = bold};
}

/// Middle of the pixel, where a line of one pixel is sharp.
double sharp(double px) { return std::floor(px) + 0.5; }

double width_of(std::string_view text) { return svg_text_width_px(text, text_size); }

void check_line(const Panel& panel, const Line& line) {
  for (const glm::dvec2& point : line.points)
    if (!is_on(panel.x, point.x) || !is_on(panel.y, point.y))
      throw std::invalid_argument(fmt::format("panel \"{}\", line \"{}\": ({}, {}) is off the axes",
                                              panel.title, line.label, point.x, point.y));
}

void check(const Figure& figure) {
  if (figure.panels.empty() || figure.columns < 1)
    throw std::invalid_argument("a figure needs a panel and a column");
  for (const Panel& panel : figure.panels)
    for (const Line& line : panel.lines) check_line(panel, line);
}

double key_width(const Line& line) {
  return line.key == KeyShape::swatch ? swatch_key_width : line_key_width;
}

/// Lines of the panel in its legend, and where each stands relative to the legend's corner.
struct Legend {
  struct Entry {
    const Line* line;
    double x;
    int row;
  };
  std::vector<Entry> entries;
  int rows = 0;
};

/// Entries from left to right, on to a new row where the plot ends.
Legend arranged_legend(const Panel& panel, double width) {
  Legend legend;
  double x = 0.0;
  if (!panel.legend_title.empty()) {
    legend.rows = 1;
    x = width_of(panel.legend_title) + key_gap;
  }
  for (const Line& line : panel.lines) {
    if (line.label.empty()) continue;
    const double entry = key_width(line) + gap + width_of(line.label);
    if (legend.rows == 0 || (x > 0.0 && x + entry > width)) {
      ++legend.rows;
      x = 0.0;
    }
    legend.entries.push_back({&line, x, legend.rows - 1});
    x += entry + key_gap;
  }
  return legend;
}

/// Where a panel is drawn.
struct Frame {
  glm::dvec2 corner;   ///< upper left of the plot
  glm::dvec2 end;      ///< its lower right
  double legend_top;   ///< the panel's title is above
  double y_title_end;  ///< right end of the y axis' title
};

struct Layout {
  glm::dvec2 size;
  std::vector<Frame> frames;
};

/// Room for labels and title of a y axis, enough for every panel.
double left_margin(const Figure& figure) {
  double widest = 0.0;
  for (const Panel& panel : figure.panels)
    for (const std::string& label : tick_labels(panel.y))
      widest = std::max(widest, width_of(label));
  return std::ceil(widest + line_height + tick_length + gap);
}

double header_height(const Figure& figure) {
  return margin + (figure.title.empty() ? 0.0 : line_height) +
         (figure.subtitle.empty() ? 0.0 : line_height) + gap;
}

/// Height of the longest legend among the panels from `first` to before `end`.
double legend_height(const Figure& figure, std::size_t first, std::size_t end) {
  int rows = 0;
  for (std::size_t i = first; i < end; ++i)
    rows = std::max(rows, arranged_legend(figure.panels[i], figure.plot_px.x).rows);
  return line_height * rows + gap;
}

/// The axes line up: margins are the same in all panels, legends as high as the row's highest.
Layout arranged(const Figure& figure) {
  constexpr double below_plot = 2.0 * line_height + gap;
  const std::size_t count = figure.panels.size();
  const std::size_t columns = std::min(static_cast<std::size_t>(figure.columns), count);
  const double left = left_margin(figure);
  const double pitch = left + figure.plot_px.x + column_gap;
  Layout layout;
  double bottom = header_height(figure) - row_gap;
  for (std::size_t first = 0; first < count; first += columns) {
    const std::size_t end = std::min(first + columns, count);
    const double legend_top = bottom + row_gap + line_height;
    const double top = legend_top + legend_height(figure, first, end);
    for (std::size_t i = first; i < end; ++i) {
      const glm::dvec2 corner(sharp(margin + left + pitch * static_cast<double>(i - first)),
                              sharp(top));
      layout.frames.push_back({corner, corner + glm::floor(figure.plot_px), legend_top,
                               corner.x - left + line_height - gap});
    }
    bottom = top + figure.plot_px.y + below_plot;
  }
  layout.size = glm::ceil(glm::dvec2(
      2.0 * margin + pitch * static_cast<double>(columns) - column_gap, bottom + margin));
  return layout;
}

/// One panel on the drawing.
class PanelDrawing {
 public:
  PanelDrawing(SvgDrawing& drawing, const Panel& panel, const Frame& frame)
      : drawing_(drawing), panel_(panel), frame_(frame) {}

  void draw(char letter) {
    draw_title(letter);
    draw_legend();
    draw_grid();
    draw_x_axis();
    draw_y_axis();
    for (const Line& line : panel_.lines) draw_line(line);
  }

 private:
  double x_px(double value) const {
    return frame_.corner.x + (frame_.end.x - frame_.corner.x) * axis_position(panel_.x, value);
  }
  double y_px(double value) const {
    return frame_.end.y - (frame_.end.y - frame_.corner.y) * axis_position(panel_.y, value);
  }

  void draw_title(char letter) {
    drawing_.text({frame_.corner.x, frame_.legend_top - 5.0},
                  fmt::format("({}) {}", letter, panel_.title),
                  style(panel_title_size, SvgAnchor::start, true));
  }

  void draw_legend() {
    const glm::dvec2 start(frame_.corner.x, frame_.legend_top + 0.5 * line_height);
    if (!panel_.legend_title.empty())
      drawing_.text(start + glm::dvec2(0.0, to_base), panel_.legend_title, style(text_size));
    const double width = frame_.end.x - frame_.corner.x;
    for (const Legend::Entry& entry : arranged_legend(panel_, width).entries) {
      const glm::dvec2 at = start + glm::dvec2(entry.x, line_height * entry.row);
      draw_key(*entry.line, at);
      drawing_.text(at + glm::dvec2(key_width(*entry.line) + gap, to_base), entry.line->label,
                    style(text_size));
    }
  }

  void draw_key(const Line& line, const glm::dvec2& at) {
    const double width = key_width(line);
    if (line.key == KeyShape::line)
      drawing_.line(at, at + glm::dvec2(width, 0.0), line.stroke);
    else
      drawing_.rectangle(at - glm::dvec2(0.0, 0.5 * swatch_height), {width, swatch_height},
                         line.stroke.colour, outline);
  }

  void draw_grid() {
    for (const double tick : panel_.x.ticks)
      vertical(tick, frame_.corner.y, frame_.end.y, grid_stroke);
    for (const double tick : panel_.y.ticks)
      horizontal(tick, frame_.corner.x, frame_.end.x, grid_stroke);
  }

  void draw_x_axis() {
    const double y = frame_.end.y;
    drawing_.line({frame_.corner.x, y}, {frame_.end.x, y}, axis_stroke);
    const std::vector<std::string> labels = tick_labels(panel_.x);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      vertical(panel_.x.ticks[i], y, y + tick_length, axis_stroke);
      drawing_.text({sharp(x_px(panel_.x.ticks[i])), y + tick_length + 13.0}, labels[i],
                    style(text_size, SvgAnchor::middle));
    }
    for (const double tick : panel_.x.minor_ticks)
      vertical(tick, y, y + 0.5 * tick_length, axis_stroke);
    drawing_.text({0.5 * (frame_.corner.x + frame_.end.x), y + 2.0 * line_height}, panel_.x.title,
                  style(text_size, SvgAnchor::middle));
  }

  void draw_y_axis() {
    const double x = frame_.corner.x;
    drawing_.line({x, frame_.corner.y}, {x, frame_.end.y}, axis_stroke);
    const std::vector<std::string> labels = tick_labels(panel_.y);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      horizontal(panel_.y.ticks[i], x - tick_length, x, axis_stroke);
      drawing_.text({x - tick_length - 4.0, sharp(y_px(panel_.y.ticks[i])) + to_base}, labels[i],
                    style(text_size, SvgAnchor::end));
    }
    for (const double tick : panel_.y.minor_ticks)
      horizontal(tick, x - 0.5 * tick_length, x, axis_stroke);
    SvgTextStyle upwards = style(text_size, SvgAnchor::middle);
    upwards.upwards = true;
    drawing_.text({frame_.y_title_end, 0.5 * (frame_.corner.y + frame_.end.y)}, panel_.y.title,
                  upwards);
  }

  void vertical(double tick, double from_px, double to_px, const SvgStroke& stroke) {
    const double x = sharp(x_px(tick));
    drawing_.line({x, from_px}, {x, to_px}, stroke);
  }
  void horizontal(double tick, double from_px, double to_px, const SvgStroke& stroke) {
    const double y = sharp(y_px(tick));
    drawing_.line({from_px, y}, {to_px, y}, stroke);
  }

  void draw_line(const Line& line) {
    std::vector<glm::dvec2> places;
    for (const glm::dvec2& point : line.points) places.emplace_back(x_px(point.x), y_px(point.y));
    if (line.key == KeyShape::swatch)
      drawing_.polyline(places, {.colour = outline.colour,
                                 .width_px = line.stroke.width_px + 2.0 * outline.width_px});
    drawing_.polyline(places, line.stroke);
  }

  SvgDrawing& drawing_;
  const Panel& panel_;
  const Frame& frame_;
};

void draw_titles(SvgDrawing& drawing, const Figure& figure) {
  double base = margin + 0.75 * figure_title_size;
  if (!figure.title.empty()) {
    drawing.text({margin, base}, figure.title, style(figure_title_size, SvgAnchor::start, true));
    base += line_height;
  }
  if (!figure.subtitle.empty()) drawing.text({margin, base}, figure.subtitle, style(subtitle_size));
}

}  // namespace

std::string svg(const Figure& figure) {
  check(figure);
  const Layout layout = arranged(figure);
  SvgDrawing drawing(layout.size, figure.title);
  draw_titles(drawing, figure);
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    PanelDrawing(drawing, figure.panels[i], layout.frames[i]).draw(static_cast<char>('a' + i));
  return drawing.file();
}

}  // namespace wold::report::chart
