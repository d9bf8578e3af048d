#pragma once

#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>
#include <iomanip>
#include <sstream>
#include <string>
#include <string_view>

#include "core/error.h"

/// Numbers, vectors, strings and whole files in POV-Ray's scene description language.
namespace wold::povray {

/// Nine digits: what a float needs, and a tenth of a micrometre over a hundred metres. Throws
/// FileError for what is no number: POV-Ray would take its name for a variable.
inline std::string number(double value) {
  if (!std::isfinite(value))
    throw FileError(fmt::format(
        "found {} among the numbers for POV-Ray, expected a finite one: this is a fault of wold",
        value));
  return fmt::format("{:.9g}", value);
}

/// "<x, y, z>"
inline std::string vector(glm::dvec3 value) {
  return fmt::format("<{}, {}, {}>", number(value.x), number(value.y), number(value.z));
}

/// The text as a string literal: a quote would end it, a backslash begin an escape.
inline std::string literal(const std::string& text) {
  std::ostringstream out;
  out << std::quoted(text);
  return out.str();
}

/// What stands before and after the text of an include file: POV-Ray reads it as version 3.7, and
/// what includes it goes on with its own version.
inline constexpr std::string_view include_begin =
    "#local _version = version;\n"
    "#version 3.7;\n";
inline constexpr std::string_view include_end = "#version _version;\n";

/// An include file's text.
inline std::string include_file(std::string_view text) {
  return fmt::format("{}{}{}", include_begin, text, include_end);
}

}  // namespace wold::povray
