#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace wold::shutter {

/// Where what a picture shows moves, and how far away it is: one value for each pixel, rows from
/// the top.
struct MotionField {
  int width = 0;
  int height = 0;
  std::vector<glm::vec2> motion_px;  ///< to the next frame: right and down
  std::vector<float> depth_m;        ///< along the camera's axis; huge where nothing is

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
};

/// From a file of passes with the layers "motion" and "depth". Throws FileError where it cannot be
/// read, has not both, or has motions or depths that are not finite.
MotionField read_motion_field(const std::filesystem::path& passes);

}  // namespace wold::shutter
