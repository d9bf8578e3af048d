#include "report/curves_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace wold::report {
namespace {

using chart::Axis;
using chart::Line;
using chart::Panel;
using grass::ShippedCurve;
using grass::WitheredState;
using grass::WitheringCurves;
using ValueOf = std::function<double(const WitheredState&)>;

/// A quantity's colour, strong for the scene's own curve and pale for the others. The strong ones
/// can be told apart by the colour-blind (Okabe and Ito 2008, Color Universal Design).
struct Ink {
  const char* strong;
  const char* pale;
};
constexpr Ink green = {"#009e73", "#4fb495"};
constexpr Ink blue = {"#0072b2", "#559bcb"};
constexpr const char* orange = "#e69f00";
constexpr const char* vermilion = "#d55e00";
constexpr double bold_px = 2.6;
constexpr double thin_px = 1.4;
constexpr double spectrum_px = 3.0;

/// The states whose spectra are shown: weathering degrees 0, 0.25, 0.5, 0.75 and 1.
constexpr std::size_t spectra_step = 25;
// Chlorophyll's bands and the red edge; models/leaf goes on to 780 nm.
constexpr double first_nm = 400.0;
constexpr double last_nm = 750.0;

Axis weathering_axis() { return chart::linear_axis("weathering degree", 0.0, 1.0); }

SvgStroke bold(const char* colour) { return {.colour = colour, .width_px = bold_px}; }

/// The dashes of [TVT], figure 9: the standard case is solid, cold is dash-dotted.
const char* dash_of(const std::string& name) {
  if (name == "standard") return "";
  return name == "cold" ? "8 3 2 3" : "6 3.5";
}

Line scene_line(const WitheringCurves& curves, const ValueOf& value_of, std::string label,
                SvgStroke stroke) {
  Line line{std::move(label), {}, std::move(stroke)};
  for (const WitheredState& state : curves.states)
    line.points.emplace_back(state.weathering, value_of(state));
  return line;
}

Line case_line(const WitheringCurves& curves, const ShippedCurve& curve, const char* colour) {
  Line line{curve.name, {}, {.colour = colour, .width_px = thin_px, .dash = dash_of(curve.name)}};
  for (std::size_t i = 0; i < curve.values.size(); ++i)
    line.points.emplace_back(curves.states[i].weathering, curve.values[i]);
  return line;
}

/// The shipped cases, pale, and on top of them the scene's own curve.
std::vector<Line> case_lines(const WitheringCurves& curves, const std::vector<ShippedCurve>& cases,
                             const ValueOf& own, const Ink& ink) {
  std::vector<Line> lines;
  std::string own_label = "this scene";
  for (const ShippedCurve& curve : cases) {
    if (curve.is_scenes_own)
      own_label = fmt::format("{} (scene)", curve.name);
    else
      lines.push_back(case_line(curves, curve, ink.pale));
  }
  lines.push_back(scene_line(curves, own, own_label, bold(ink.strong)));
  return lines;
}

Panel pigments_panel(const WitheringCurves& curves) {
  std::vector<Line> lines = case_lines(
      curves, curves.chlorophyll, [](const WitheredState& s) { return s.chlorophyll; }, green);
  lines.push_back(scene_line(
      curves, [](const WitheredState& s) { return s.carotenoid; }, "carotenoids", bold(orange)));
  return {"Pigments", weathering_axis(), chart::linear_axis("content (fresh leaf = 1)", 0.0, 1.0),
          std::move(lines), "chlorophyll:"};
}

Panel water_panel(const WitheringCurves& curves) {
  return {"Water", weathering_axis(), chart::linear_axis("content (turgid leaf = 1)", 0.0, 1.0),
          case_lines(
              curves, curves.water, [](const WitheredState& s) { return s.water; }, blue)};
}

double largest(const WitheringCurves& curves, const ValueOf& value_of) {
  double max = 0.0;
  for (const WitheredState& state : curves.states) max = std::max(max, value_of(state));
  return max;
}

/// The two tissues by two of their properties, in the same pens everywhere.
std::vector<Line> tissue_lines(const WitheringCurves& curves, const ValueOf& mesophyll,
                               const ValueOf& vein) {
  return {scene_line(curves, mesophyll, "mesophyll", bold(green.strong)),
          scene_line(curves, vein, "vein", bold(vermilion))};
}

Panel strain_panel(const WitheringCurves& curves) {
  const ValueOf mesophyll = [](const WitheredState& s) { return s.tissue.strain_mesophyll; };
  const ValueOf vein = [](const WitheredState& s) { return s.tissue.strain_vein; };
  const double max = std::max(largest(curves, mesophyll), largest(curves, vein));
  return {"Shrinkage of the tissues", weathering_axis(),
          chart::linear_axis("strain (share of volume lost)", 0.0, max),
          tissue_lines(curves, mesophyll, vein)};
}

Panel stiffness_panel(const WitheringCurves& curves) {
  constexpr double megapascal = 1e6;
  const ValueOf mesophyll = [](const WitheredState& s) {
    return s.tissue.modulus_mesophyll_pa / megapascal;
  };
  const ValueOf vein = [](const WitheredState& s) { return s.tissue.modulus_vein_pa / megapascal; };
  return {"Stiffness of the tissues", weathering_axis(),
          chart::logarithmic_axis("Young's modulus (MPa)", mesophyll(curves.states.front()),
                                  largest(curves, vein)),
          tissue_lines(curves, mesophyll, vein)};
}

Panel posture_panel(const WitheringCurves& curves) {
  return {"Droop of the mean blade",
          weathering_axis(),
          chart::linear_axis("tip angle from the vertical (deg)", 0.0, 90.0, 15.0),
          {scene_line(
              curves, [](const WitheredState& state) { return state.tip_angle_deg; },
              "line from root to tip", bold(blue.strong))}};
}

Line spectrum_line(const WitheringCurves& curves, const WitheredState& state) {
  Line line{fmt::format("{:.2g}", state.weathering),
            {},
            {.colour = svg_colour(state.srgb), .width_px = spectrum_px},
            chart::KeyShape::swatch};
  for (std::size_t i = 0; i < state.reflectance.size(); ++i)
    if (curves.wavelength_nm[i] >= first_nm && curves.wavelength_nm[i] <= last_nm)
      line.points.emplace_back(curves.wavelength_nm[i], state.reflectance[i]);
  return line;
}

Panel spectra_panel(const WitheringCurves& curves) {
  double max = 0.0;
  std::vector<Line> lines;
  for (std::size_t i = 0; i < curves.states.size(); i += spectra_step) {
    lines.push_back(spectrum_line(curves, curves.states[i]));
    for (const glm::dvec2& point : lines.back().points) max = std::max(max, point.y);
  }
  return {"Reflectance, in the leaf's own colour",
          chart::linear_axis("wavelength (nm)", first_nm, last_nm, 50.0),
          chart::linear_axis("reflectance", 0.0, max), std::move(lines), "degree:"};
}

}  // namespace

chart::Figure withering_figure(const std::string& scene_name, const WitheringCurves& curves) {
  return {fmt::format("Withering of a leaf in the scene {}", scene_name),
          "What its [ageing] settings make of a leaf over that leaf's own weathering degree: 0 is "
          "fresh, 1 fully withered.",
          {pigments_panel(curves), water_panel(curves), strain_panel(curves),
           stiffness_panel(curves), posture_panel(curves), spectra_panel(curves)}};
}

}  // namespace wold::report
