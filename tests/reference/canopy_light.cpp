// Light in texels against paths traced through the blades they stand for (canopy.py):
//
//     canopy_light REFERENCE.csv [--rows]
//
// Prints how far each level of the default meadow is off, over suns, weathering degrees and views;
// with --rows each of them. Exit status 1 when a figure is out of its bounds.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <vector>

#include "core/colour.h"
#include "core/colour_difference.h"
#include "core/error.h"
#include "reference/canopy_table.h"
#include "reference/canopy_texels.h"

namespace wold::test {
namespace {

glm::dvec3 lab(const glm::dvec3& radiance) {
  constexpr double gain = 1.6;  // as in the pictures (film/assemble.h)
  return lab_from_xyz(xyz_from_srgb(glm::clamp(radiance * gain, 0.0, 1.0)));
}

/// How far a level is off, over all rows: of each channel, and as colours differ.
struct Errors {
  std::vector<double> relative, colour;

  void add(const glm::dvec3& got, const glm::dvec3& wanted) {
    for (int c = 0; c < 3; ++c) relative.push_back(std::abs(got[c] / wanted[c] - 1.0));
    colour.push_back(colour_difference(lab(wanted), lab(got)));
  }
};

/// What a level may be off by at most: half of all figures, nineteen of twenty and all, and half of
/// all colours and all (CIEDE2000; 1 is just noticeable).
struct Bounds {
  double median, most, worst, colour, worst_colour;
};
constexpr std::array bounds = {
    Bounds{0.022, 0.07, 0.17, 0.6, 2.4}, Bounds{0.022, 0.07, 0.18, 0.6, 2.4},
    Bounds{0.022, 0.075, 0.19, 0.6, 2.4}, Bounds{0.025, 0.085, 0.2, 0.6, 2.7}};

/// Prints the errors of each level; whether all are within bounds.
bool sum_up(const std::map<std::size_t, Errors>& errors) {
  bool good = true;
  fmt::print("level  median %  95th %  worst %   CIEDE2000 median  worst\n");
  for (const auto& [lod, error] : errors) {
    const auto relative = [&](double fraction) { return quantile(error.relative, fraction); };
    const Bounds& bound = bounds.at(lod);
    const bool within = relative(0.5) <= bound.median && relative(0.95) <= bound.most &&
                        relative(1.0) <= bound.worst &&
                        quantile(error.colour, 0.5) <= bound.colour &&
                        quantile(error.colour, 1.0) <= bound.worst_colour;
    fmt::print("{:5} {:9.1f} {:7.1f} {:8.1f} {:19.2f} {:6.2f} {}\n", lod, 100.0 * relative(0.5),
               100.0 * relative(0.95), 100.0 * relative(1.0), quantile(error.colour, 0.5),
               quantile(error.colour, 1.0), within ? "" : "OUT OF BOUNDS");
    good = good && within;
  }
  return good;
}

}  // namespace

int compare(const std::filesystem::path& reference, bool prints_rows) {
  std::map<std::size_t, Errors> errors;
  for (const auto& [light, views] : read_canopy_table(reference)) {
    const CanopyTexels canopy(light.first, light.second);
    for (std::size_t lod = 0; lod < canopy.lods(); ++lod)
      for (const CanopyView& row : views) {
        const glm::dvec3 got = canopy.seen(lod, row.towards_eye());
        errors[lod].add(got, row.radiance);
        if (!prints_rows) continue;
        const glm::dvec3 ratio = got / row.radiance;
        fmt::print(
            "{} {:3} {:5} {:9} {:4}  {:.4f} {:.4f} {:.4f}  {:5.2f} {:5.2f} {:5.2f}  {:.1f}\n", lod,
            row.sun_deg, row.weathering, row.plane, row.view_deg, row.radiance.r, row.radiance.g,
            row.radiance.b, ratio.r, ratio.g, ratio.b,
            colour_difference(lab(row.radiance), lab(got)));
      }
    std::fflush(stdout);
  }
  return sum_up(errors) ? 0 : 1;
}

}  // namespace wold::test

int main(int count, char** arguments) {
  if (count < 2) {
    fmt::print(stderr, "usage: canopy_light REFERENCE.csv [--rows]\n");
    return 2;
  }
  try {
    return wold::test::compare(arguments[1], count > 2 && std::strcmp(arguments[2], "--rows") == 0);
  } catch (const wold::Error& error) {
    fmt::print(stderr, "canopy_light: {}\n", error.what());
    return 4;
  }
}
