#include "report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/markup.h"

namespace wold::report {
namespace {

constexpr double mean_advance = 0.62;

/// A hundredth of a pixel, without needless zeros and without "-0".
std::string number(double value) {
  return fmt::format("{}", std::round(value * 100.0) / 100.0 + 0.0);
}

std::string stroke_attributes(const SvgStroke& stroke) {
  std::string text =
      fmt::format(R"(stroke="{}" stroke-width="{}")", stroke.colour, number(stroke.width_px));
  if (!stroke.dash.empty()) text += fmt::format(R"( stroke-dasharray="{}")", stroke.dash);
  return text;
}

const char* anchor_name(SvgAnchor anchor) {
  switch (anchor) {
    case SvgAnchor::middle:
      return "middle";
    case SvgAnchor::end:
      return "end";
    case SvgAnchor::start:
      break;
  }
  return "start";
}

int channel(double encoded) {
  return static_cast<int>(std::lround(std::clamp(encoded, 0.0, 1.0) * 255.0));
}

}  // namespace

std::string svg_colour(const glm::dvec3& srgb) {
  return fmt::format("#{:02x}{:02x}{:02x}", channel(srgb.r), channel(srgb.g), channel(srgb.b));
}

SvgDrawing::SvgDrawing(const glm::dvec2& size_px, std::string_view title)
    : body_(fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}\" "
                        "height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
                        "font-family=\"Arial, Helvetica, sans-serif\">\n"
                        "<title>{2}</title>\n"
                        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                        number(size_px.x), number(size_px.y), markup_escaped(title))) {}

void SvgDrawing::line(const glm::dvec2& from, const glm::dvec2& to, const SvgStroke& stroke) {
  body_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {}/>\n", number(from.x),
                       number(from.y), number(to.x), number(to.y), stroke_attributes(stroke));
}

void SvgDrawing::polyline(std::span<const glm::dvec2> points, const SvgStroke& stroke) {
  std::string places;
  for (const glm::dvec2& point : points)
    places += fmt::format("{}{},{}", places.empty() ? "" : " ", number(point.x), number(point.y));
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n",
                       places, stroke_attributes(stroke));
}

void SvgDrawing::rectangle(const glm::dvec2& corner, const glm::dvec2& size, std::string_view fill,
                           const SvgStroke& outline) {
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" {}/>\n",
                       number(corner.x), number(corner.y), number(size.x), number(size.y), fill,
                       stroke_attributes(outline));
}

void SvgDrawing::text(const glm::dvec2& at, std::string_view text, const SvgTextStyle& style) {
  const std::string turn =
      style.upwards ? fmt::format(" transform=\"rotate(-90 {} {})\"", number(at.x), number(at.y))
                    : "";
  body_ += fmt::format(
      "<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n",
      number(at.x), number(at.y), number(style.size_px), style.colour, anchor_name(style.anchor),
      style.bold ? " font-weight=\"bold\"" : "", turn, markup_escaped(text));
}

double svg_text_width_px(std::string_view text, double size_px) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // not a UTF-8 continuation
  });
  return mean_advance * size_px * static_cast<double>(letters);
}

}  // namespace wold::report
