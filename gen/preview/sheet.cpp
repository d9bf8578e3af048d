#include "preview/sheet.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/segment.h"

namespace wold::preview {
namespace {

constexpr int header_px = 76;
constexpr int caption_px = 34;
const glm::vec3 paper(0.075F, 0.086F, 0.078F);
const glm::vec3 ink(0.91F, 0.92F, 0.91F);
const glm::vec3 soft(0.62F, 0.66F, 0.63F);

int height_of(const std::vector<Tile>& row) {
  int height = 0;
  for (const Tile& tile : row) height = std::max(height, tile.picture.height);
  return height + caption_px;
}

void place(const Image& picture, const glm::ivec2& corner, Image& sheet) {
  const int width = std::min(picture.width, sheet.width - corner.x);
  for (int y = 0; y < picture.height; ++y)
    std::copy_n(picture.pixel(0, y), 3 * std::max(0, width), sheet.pixel(corner.x, corner.y + y));
}

}  // namespace

std::filesystem::path label_font() {
  const std::filesystem::path font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
  std::error_code ignored;
  return std::filesystem::exists(font, ignored) ? font : std::filesystem::path();
}

void draw_line(Image& picture, const glm::dvec2& from_px, const glm::dvec2& to_px,
               const glm::vec3& colour) {
  constexpr double half_width_px = 0.75;
  const glm::dvec2 along = to_px - from_px;
  const glm::dvec2 size(picture.width, picture.height);
  const glm::dvec2 low =
      glm::clamp(glm::floor(glm::min(from_px, to_px)) - 2.0, glm::dvec2(0), size);
  const glm::dvec2 high =
      glm::clamp(glm::ceil(glm::max(from_px, to_px)) + 2.0, glm::dvec2(0), size);
  for (int y = static_cast<int>(low.y); y < high.y; ++y)
    for (int x = static_cast<int>(low.x); x < high.x; ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5);
      const double away = glm::length(at - from_px - share_of_way(at, from_px, to_px) * along);
      const auto fraction = static_cast<float>(std::clamp(half_width_px + 0.5 - away, 0.0, 1.0));
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] = std::lerp(picture.pixel(x, y)[c], colour[c], fraction);
    }
}

void write_label(Image& picture, const std::string& text, const Label& label,
                 const std::filesystem::path& font) {
  if (font.empty() || text.empty()) return;
  OIIO::ImageBuf buffer(
      OIIO::ImageSpec(picture.width, picture.height, picture.channels, OIIO::TypeDesc::FLOAT),
      picture.values.data());
  using OIIO::ImageBufAlgo::TextAlignX;
  if (!OIIO::ImageBufAlgo::render_text(
          buffer, label.at_px.x, label.at_px.y, text, label.size_px, font.string(),
          {label.colour.x, label.colour.y, label.colour.z},
          label.centred ? TextAlignX::Center : TextAlignX::Left,
          OIIO::ImageBufAlgo::TextAlignY::Baseline, label.shadow_px, {}, 1))
    throw FileError(
        fmt::format("cannot write labels with {}: {}", font.string(), buffer.geterror()));
}

Image drawn(const Sheet& sheet, const std::filesystem::path& font) {
  int height = header_px + margin_px / 2;
  for (const std::vector<Tile>& row : sheet.rows) height += height_of(row);
  Image picture(sheet_width_px, height, 3);
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = paper[static_cast<int>(i % 3)];
  write_label(picture, sheet.title, {{margin_px, 38}, 24, ink}, font);
  write_label(picture, sheet.subtitle, {{margin_px, 61}, 13, soft}, font);
  int top = header_px;
  for (const std::vector<Tile>& row : sheet.rows) {
    int left = margin_px;
    for (const Tile& tile : row) {
      place(tile.picture, {left, top}, picture);
      write_label(picture, tile.caption, {{left, top + tile.picture.height + 18}, 13, soft}, font);
      left += tile.picture.width + gap_px;
    }
    top += height_of(row);
  }
  return picture;
}

}  // namespace wold::preview
