#include "wind/fourier.h"

#include <bit>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::wind {
namespace {

using Complex = std::complex<double>;

/// Without what std::complex asks of infinities.
Complex times(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// exp(-2 pi i k / side) for k below half the side.
std::vector<Complex> roots_of_one(std::size_t side) {
  std::vector<Complex> roots(side / 2);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const double angle =
        -2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(side);
    roots[k] = {math::cos(angle), math::sin(angle)};
  }
  return roots;
}

void reorder(std::vector<Complex>& line) {
  for (std::size_t i = 1, reversed = 0; i < line.size(); ++i) {
    std::size_t bit = line.size() >> 1;
    for (; (reversed & bit) != 0; bit >>= 1) reversed ^= bit;
    reversed ^= bit;
    if (i < reversed) std::swap(line[i], line[reversed]);
  }
}

void transform(std::vector<Complex>& line, const std::vector<Complex>& roots) {
  reorder(line);
  for (std::size_t length = 2; length <= line.size(); length *= 2)
    for (std::size_t first = 0; first < line.size(); first += length)
      for (std::size_t k = 0; k < length / 2; ++k) {
        Complex& low = line[first + k];
        Complex& high = line[first + k + length / 2];
        const Complex turned = times(high, roots[k * (line.size() / length)]);
        high = low - turned;
        low += turned;
      }
}

void transform_rows(ComplexSquare& square, const std::vector<Complex>& roots) {
  const auto side = static_cast<std::size_t>(square.side);
  parallel_for(side, [&](std::size_t row) {
    const auto first = square.values.begin() + static_cast<std::ptrdiff_t>(row * side);
    std::vector<Complex> line(first, first + square.side);
    transform(line, roots);
    std::copy(line.begin(), line.end(), first);
  });
}

void transpose(ComplexSquare& square) {
  const auto side = static_cast<std::size_t>(square.side);
  for (std::size_t j = 0; j < side; ++j)
    for (std::size_t i = 0; i < j; ++i)
      std::swap(square.values[j * side + i], square.values[i * side + j]);
}

}  // namespace

void transform(ComplexSquare& square) {
  const auto side = static_cast<std::size_t>(square.side);
  if (!std::has_single_bit(side) || square.values.size() != side * side)
    throw std::invalid_argument(
        "a Fourier transform needs a square whose side is a power of two, got " +
        std::to_string(square.side) + " and " + std::to_string(square.values.size()) + " values");
  const std::vector<Complex> roots = roots_of_one(side);
  for (int axis = 0; axis < 2; ++axis) {
    transform_rows(square, roots);
    transpose(square);
  }
}

void transform_back(ComplexSquare& square) {
  for (Complex& value : square.values) value = std::conj(value);
  transform(square);
  const double count = static_cast<double>(square.values.size());
  for (Complex& value : square.values) value = std::conj(value) / count;
}

}  // namespace wold::wind
