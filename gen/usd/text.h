#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

/// Numbers, vectors, arrays and paths as USD's text files (.usda) have them.
namespace wold::usd {

/// Nine digits: what a float needs. Throws FileError for what is no number.
std::string number(double value);

/// With so many decimals at most, without zeros at the end. Throws FileError for what is no number.
std::string rounded(double value, int decimals);

/// "(x, y, z)"
std::string vector(const glm::dvec3& value);
/// "(x, y)"
std::string pair(const glm::dvec2& value);
std::string rounded(const glm::dvec3& value, int decimals);
std::string rounded(const glm::dvec2& value, int decimals);

/// A matrix4d. USD multiplies rows by matrices: its rows are our columns.
std::string matrix(const glm::dmat4& matrix);

/// "@path@": a file, from the layer's folder on.
std::string asset(const std::filesystem::path& from_layer);

/// "[a, b, c]" of the texts of values.
template <class Values, class ToText>
std::string array(const Values& values, const ToText& to_text) {
  std::string text = "[";
  for (const auto& value : values) {
    if (text.size() > 1) text += ", ";
    text += to_text(value);
  }
  return text + "]";
}

/// Every line of a text moved to the right by so many steps.
std::string indented(std::string_view text, int steps = 1);

/// The name of a frame's layer, "frame.0001.usda": numbered as hosts number sequences.
std::string frame_layer(int frame);

}  // namespace wold::usd
