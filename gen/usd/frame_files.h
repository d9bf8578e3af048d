#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <string>

#include "landscape/landscape.h"

/// What a frame's files are called, from the exporter's folder on.
namespace wold::usd {

inline std::filesystem::path frame_folder(const landscape::Landscape& landscape) {
  return std::filesystem::path("data") / fmt::format("frame_{:04}", landscape.frame);
}
inline const std::filesystem::path blades_folder = "data/blades";
inline const std::filesystem::path volumes_folder = "data/volumes";
inline const std::filesystem::path flakes_folder = "data/flakes";

inline std::string detail_picture(std::size_t number) {
  return fmt::format("ground_detail_{}.exr", number);
}

}  // namespace wold::usd
