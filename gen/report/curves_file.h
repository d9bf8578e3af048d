#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace wold::report {

/// How curves are written: as a drawing (SVG) or as a table (CSV).
enum class CurvesForm : std::uint8_t { figure, table };

/// The form of a file by its extension, in small or capital letters: .svg or .csv. Throws
/// InputError when it is another.
CurvesForm curves_form_of(const std::filesystem::path& file);

/// The curves of a scene as the content of a file: those of its ageing, or in a season those of its
/// days. With a file of daily weather, which may be empty, they are those of its days instead.
/// Throws InputError and FileError.
std::string curves_file(const scene::Scene& scene, const std::filesystem::path& weather,
                        CurvesForm form);

}  // namespace wold::report
