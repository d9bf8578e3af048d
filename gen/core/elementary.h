#pragma once

#include <cmath>

/// Elementary functions that give the same bits with any compiler, C library and processor: they
/// are made of additions, multiplications, divisions and square roots, which IEEE 754 defines to
/// the last bit. Those of <cmath> differ in last bits between versions of the C library, and
/// between processors within one; so every number that reaches a file comes through these. What
/// <cmath> rounds exactly by definition (sqrt, floor, round, remainder ...) is taken from there.
///
/// Errors are below 1 unit in the last place where the result is a normal number (asinh: 2, erfc:
/// 8). Special values are those of C99, Annex F; errno and the floating-point exceptions say
/// nothing. Functions of floats are those of doubles, rounded.
namespace wold::math {

#define WOLD_PURE [[nodiscard, gnu::const]]

WOLD_PURE double exp(double x);
WOLD_PURE double exp2(double x);
WOLD_PURE double expm1(double x);  ///< exp(x) - 1
WOLD_PURE double tanh(double x);
WOLD_PURE double log(double x);
WOLD_PURE double log2(double x);
WOLD_PURE double log10(double x);
WOLD_PURE double log1p(double x);  ///< log(1 + x)
WOLD_PURE double asinh(double x);
WOLD_PURE double pow(double base, double exponent);
WOLD_PURE float pow(float base, float exponent);
WOLD_PURE double sin(double x);
WOLD_PURE double cos(double x);
WOLD_PURE float sin(float x);
WOLD_PURE float cos(float x);
WOLD_PURE double tan(double x);
WOLD_PURE double asin(double x);
WOLD_PURE double acos(double x);
WOLD_PURE double atan(double x);
WOLD_PURE double atan2(double y, double x);
WOLD_PURE double cbrt(double x);
WOLD_PURE double hypot(double x, double y);
WOLD_PURE double hypot(double x, double y, double z);
WOLD_PURE double erfc(double x);  ///< complement of the error function

#undef WOLD_PURE

inline float exp(float x) { return static_cast<float>(exp(double{x})); }
inline float exp2(float x) { return static_cast<float>(exp2(double{x})); }
inline float expm1(float x) { return static_cast<float>(expm1(double{x})); }
inline float tanh(float x) { return static_cast<float>(tanh(double{x})); }
inline float log(float x) { return static_cast<float>(log(double{x})); }
inline float log2(float x) { return static_cast<float>(log2(double{x})); }
inline float log10(float x) { return static_cast<float>(log10(double{x})); }
inline float log1p(float x) { return static_cast<float>(log1p(double{x})); }
inline float asinh(float x) { return static_cast<float>(asinh(double{x})); }
inline float tan(float x) { return static_cast<float>(tan(double{x})); }
inline float asin(float x) { return static_cast<float>(asin(double{x})); }
inline float acos(float x) { return static_cast<float>(acos(double{x})); }
inline float atan(float x) { return static_cast<float>(atan(double{x})); }
inline float cbrt(float x) { return static_cast<float>(cbrt(double{x})); }
inline float erfc(float x) { return static_cast<float>(erfc(double{x})); }
inline float atan2(float y, float x) { return static_cast<float>(atan2(double{y}, double{x})); }
/// Squares of floats are exact in a double.
inline float hypot(float x, float y) {
  return static_cast<float>(std::sqrt(double{x} * x + double{y} * y));
}
inline float hypot(float x, float y, float z) {
  return static_cast<float>(std::sqrt(double{x} * x + double{y} * y + double{z} * z));
}

}  // namespace wold::math
