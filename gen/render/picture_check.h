#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>

namespace wold::render {

/// Why a rendered picture cannot be right: missing, unreadable, not `size_px`, values that are no
/// numbers, or every pixel the same colour. Empty when nothing is wrong.
std::string picture_problem(const std::filesystem::path& picture, glm::ivec2 size_px);

}  // namespace wold::render
