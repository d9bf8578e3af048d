#pragma once

#include <filesystem>
#include <string>

#include "core/expected_picture.h"
#include "render/renderer.h"

namespace wold::render {

/// Things that change a picture by less are not looked for: root mean square over all of it, of
/// sRGB in [0, 1].
constexpr double min_contrast = 0.02;

/// Why a picture cannot be right for what it does not show: too little of the grass,
/// blades or clouds that should be there, and what to do. Things that would change the picture by
/// less than `min_contrast` are not looked for. Empty when nothing is missing. Throws FileError
/// when the picture cannot be read.
std::string missing_things(const std::filesystem::path& picture, const ExpectedPicture& expected,
                           const Renderer& renderer);

}  // namespace wold::render
