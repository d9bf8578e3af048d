#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "compare/images.h"
#include "core/image.h"
#include "support/blurred_difference.h"

/// How far two pictures of one scene are apart. Prints two numbers: mean FLIP from 0 to 1, and the
/// mean difference after a blur of 8x8 pixels, in 255ths.
namespace {

using namespace wold;

constexpr double soft = 0.02;  // counts pixels only; neither number depends on it

void print_difference(const char* got_path, const char* want_path) {
  const Image got = read_image(got_path);
  const Image want = read_image(want_path);
  const double flip = compare::compare_images(got, want, soft).flip;
  fmt::print("{:.4f} {:.2f}\n", flip, 255.0 * test::blurred_difference(got, want));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "found {} pictures, expected 2: picture_difference GOT WANT\n", argc - 1);
    return 2;
  }
  try {
    print_difference(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 4;
  }
}
