#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/image.h"

namespace wold::preview {

inline constexpr int sheet_width_px = 1440;
inline constexpr int margin_px = 24;
inline constexpr int gap_px = 16;

/// Width of each of `count` equal pictures side by side on a sheet.
constexpr int width_of_each(int count) {
  return (sheet_width_px - 2 * margin_px - (count - 1) * gap_px) / count;
}

/// A picture in encoded sRGB with a line of text below it.
struct Tile {
  Image picture;
  std::string caption;
};

/// A title and rows of tiles that are no wider than the sheet.
struct Sheet {
  std::string title;
  std::string subtitle;
  std::vector<std::vector<Tile>> rows;
};

/// The font of labels, DejaVu Sans; empty when it is not installed.
std::filesystem::path label_font();

/// The sheet as one picture in encoded sRGB; without texts when `font` is empty. Throws FileError
/// when the font cannot be used.
Image drawn(const Sheet& sheet, const std::filesystem::path& font);

/// A straight line, a pixel and a half wide, of an encoded colour; what is outside is left out.
void draw_line(Image& picture, const glm::dvec2& from_px, const glm::dvec2& to_px,
               const glm::vec3& colour);

/// A line of text whose base line begins at a place, or has its middle there.
struct Label {
  glm::ivec2 at_px{0};
  int size_px = 13;
  glm::vec3 colour{1.0F};
  bool centred = false;
  int shadow_px = 0;  ///< of a dark outline
};
void write_label(Image& picture, const std::string& text, const Label& label,
                 const std::filesystem::path& font);

}  // namespace wold::preview
