#pragma once

#include <fmt/format.h>

#include <glm/glm.hpp>
#include <string>

/// Numbers and vectors in POV-Ray's scene description language.
namespace wold::povray {

/// Nine digits: what a float needs, and a tenth of a micrometre over a hundred metres.
inline std::string number(double value) { return fmt::format("{:.9g}", value); }

/// "<x, y, z>"
inline std::string vector(glm::dvec3 value) {
  return fmt::format("<{}, {}, {}>", number(value.x), number(value.y), number(value.z));
}

}  // namespace wold::povray
