#pragma once

#include <chrono>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>

#include "render/renderer_program.h"

namespace wold::render {

/// One picture to make from an exported scene folder.
struct Job {
  RendererProgram program;
  std::filesystem::path scene_folder;  ///< as its exporter has written it
  int frame = 1;                       ///< from 1
  glm::ivec2 size_px{0};
  int samples = 1;                   ///< per pixel
  std::string device = "cpu";        ///< "cpu", "gpu", or "auto", a graphics card if there is one
  int threads = 0;                   ///< 0: all processors
  double memory_bytes = 0.0;         ///< that the program may take of its own; 0: no limit
  std::chrono::seconds timeout{0};   ///< from the start; longer than 0
  std::filesystem::path picture;     ///< where the finished picture goes
  std::filesystem::path log;         ///< the renderer's own words, kept in any case
  std::filesystem::path expected{};  ///< what it should show (expected_picture.h); empty: not known
};

}  // namespace wold::render
