#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace wold {

/// What a tile of a picture shows: mean radiance after exposure, cut off at 1, per channel.
struct ExpectedTile {
  int tile = 0;       ///< row by row from the upper left corner, from 0
  glm::vec3 with;     ///< the whole picture
  glm::vec3 without;  ///< the same if nothing of a kind were drawn
};

/// Things of one kind, and the tiles in which they can be told from their absence.
struct ExpectedThings {
  std::string name;           ///< for people: "grass"
  double min_fraction = 0.0;  ///< a right picture shows more than that of the change they make
  std::vector<ExpectedTile> tiles;
};

/// What a picture should show, roughly: enough to see whether something has not been drawn.
struct ExpectedPicture {
  glm::ivec2 tiles{1};  ///< columns and rows, of equal size
  std::vector<ExpectedThings> things;
};

/// Writes it as JSON, with four digits after the point. Throws FileError.
void write_expected_picture(const std::filesystem::path& path, const ExpectedPicture& expected);

/// Reads it back. Throws FileError when it is missing or damaged.
ExpectedPicture read_expected_picture(const std::filesystem::path& path);

}  // namespace wold
