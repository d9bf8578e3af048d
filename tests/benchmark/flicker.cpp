#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "core/image.h"

/// How much the frames of a film with a still camera differ: the pictures on the command line in
/// their order, as means of 8x8 pixels in 255ths. A change is that from a frame to the next; a jump
/// is how far a frame lies beside the middle of the two around it: ageing changes, popping jumps.
namespace {

using wold::Image;

constexpr int box = 8;

/// Means of all channels of the blocks, row by row.
std::vector<double> blocks(const Image& picture) {
  std::vector<double> means;
  for (int y = 0; y + box <= picture.height; y += box)
    for (int x = 0; x + box <= picture.width; x += box) {
      double sum = 0.0;
      for (int j = 0; j < box; ++j)
        for (int i = 0; i < box; ++i)
          for (int c = 0; c < picture.channels; ++c) sum += double{picture.pixel(x + i, y + j)[c]};
      means.push_back(255.0 * sum / (box * box * picture.channels));
    }
  return means;
}

/// Mean and largest of what was added.
struct Statistics {
  double sum = 0.0;
  double largest = 0.0;
  long count = 0;

  void add(double value) {
    sum += value;
    largest = std::max(largest, value);
    ++count;
  }
  void print(const char* what) const {
    fmt::print("{}: {:.2f} on average, {:.2f} at most\n", what,
               sum / static_cast<double>(std::max(count, 1L)), largest);
  }
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "found {} pictures, expected at least 3: flicker PICTURES...\n", argc - 1);
    return 2;
  }
  std::vector<std::vector<double>> film;
  for (int i = 1; i < argc; ++i) film.push_back(blocks(wold::read_image(argv[i])));
  Statistics changes;
  Statistics jumps;
  for (std::size_t k = 1; k < film.size(); ++k)
    for (std::size_t b = 0; b < film[k].size(); ++b) {
      changes.add(std::abs(film[k].at(b) - film[k - 1].at(b)));
      if (k + 1 < film.size())
        jumps.add(std::abs(film[k].at(b) - 0.5 * (film[k - 1].at(b) + film[k + 1].at(b))));
    }
  changes.print("change");
  jumps.print("jump");
}
