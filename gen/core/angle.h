#pragma once

#include <numbers>

namespace wold {

/// An angle in radians from degrees. glm::radians() multiplies by the rounded pi / 180 and may
/// differ from it in the last bit; which of the two a formula has cannot be changed without other
/// bytes.
constexpr double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// An angle in degrees from radians.
constexpr double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// An angle of one degree, for formulas that multiply by it or divide by it.
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// An angle of one radian in degrees, for formulas that multiply by it.
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

}  // namespace wold
