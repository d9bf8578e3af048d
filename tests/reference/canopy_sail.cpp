// Four-stream theory against paths traced through the blades (canopy.py) and against texels:
//
//     canopy_sail REFERENCE.csv [--texels] [--rows]
//
// Measures the leaves that the paths were traced through and prints how far what 4SAIL2 makes of
// them is off; with --texels off what texels show, too; with --rows each view's ratio to the traced
// one. Exit status 1 when theory is out of its bounds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "core/error.h"
#include "grass/mechanics/meadow_model.h"
#include "grass/texel/blade_patch.h"
#include "grass/texel/coverage.h"
#include "light/daylight.h"
#include "reference/canopy_foliage.h"
#include "reference/canopy_scene.h"
#include "reference/canopy_table.h"
#include "reference/canopy_texels.h"
#include "reference/sail.h"

namespace wold::test {
namespace {

using std::numbers::pi;

/// Where light comes from, and how much of it level ground gets from there.
struct Beam {
  glm::dvec3 direction;
  glm::dvec3 irradiance;
};

/// The sun and the sky, the latter as beams that bring level ground as much.
std::vector<Beam> beams_of(const light::Daylight& day) {
  constexpr int rings = 8, around = 16;
  std::vector<Beam> beams;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double up = std::sqrt((i + 0.5) / rings), azimuth = 2.0 * pi * (j + 0.5) / around;
      const double across = std::sqrt(1.0 - up * up);
      const glm::dvec3 at(across * std::sin(azimuth), across * std::cos(azimuth), up);
      beams.push_back({at, glm::dvec3(day.sky_radiance(at)) * pi / double{rings * around}});
    }
  const glm::dvec3& sun = day.sun_direction();
  beams.push_back({sun, glm::dvec3(day.sun_irradiance()) * sun.z});
  return beams;
}

SunAndView between(const glm::dvec3& light, const glm::dvec3& eye) {
  const glm::dvec2 a(light), b(eye);
  const double lengths = glm::length(a) * glm::length(b);
  const double cosine = lengths > 1e-9 ? glm::dot(a, b) / lengths : 1.0;
  return {std::acos(std::min(1.0, light.z)), std::acos(std::min(1.0, eye.z)),
          std::acos(std::clamp(cosine, -1.0, 1.0))};
}

/// Leaves that send on more red than green are brown.
bool is_brown(const LeafBit& bit) {
  const glm::dvec3 albedo = bit.reflectance + bit.transmittance;
  return albedo.r > albedo.g;
}

/// 4SAIL2's canopy: green and brown leaves, as far above each other as they stand. Leaves of one
/// kind alone are one layer.
class TwoKinds {
 public:
  explicit TwoKinds(const CanopyFoliage& foliage)
      : angles_(leaf_angles(foliage.bits())), leaf_area_index_(foliage.leaf_area_index()) {
    for (const LeafBit& bit : foliage.bits()) (is_brown(bit) ? brown_ : green_).add(bit);
    brown_fraction_ = brown_.area_m2 / (brown_.area_m2 + green_.area_m2);
    if (is_one_kind()) return;
    double above_m2 = 0.0, brown_above_m2 = 0.0;
    for (const LeafBit& bit : foliage.bits()) {
      if (above_m2 > green_.area_m2) break;
      above_m2 += bit.area_m2;
      if (is_brown(bit)) brown_above_m2 += bit.area_m2;
    }
    dissociation_ = 1.0 - brown_above_m2 / brown_.area_m2 / (1.0 - brown_fraction_);
  }

  std::vector<LeafLayer> layers(int channel) const {
    if (is_one_kind())
      return {{angles_, (brown_fraction_ > 0.5 ? brown_ : green_).leaf(channel), leaf_area_index_}};
    return green_and_brown(
        {green_.leaf(channel), brown_.leaf(channel), brown_fraction_, dissociation_}, angles_,
        leaf_area_index_);
  }

  double brown_fraction() const { return brown_fraction_; }
  double dissociation() const { return dissociation_; }

 private:
  bool is_one_kind() const { return std::min(brown_fraction_, 1.0 - brown_fraction_) < 1e-3; }

  LeafAngles angles_;
  double leaf_area_index_;
  MeanLeaf green_, brown_;
  double brown_fraction_ = 0.0;
  double dissociation_ = 0.0;
};

/// A meadow at a weathering degree as theory has it.
class CanopyTheory {
 public:
  explicit CanopyTheory(const scene::Scene& scene, double weathering)
      : foliage_(scene, weathering),
        kinds_(foliage_),
        hot_spot_(foliage_.hot_spot()),
        soil_(scene.terrain.ground_albedo[0], scene.terrain.ground_albedo[1],
              scene.terrain.ground_albedo[2]) {
    for (int channel = 0; channel < 3; ++channel)
      layers_[static_cast<std::size_t>(channel)] = kinds_.layers(channel);
  }

  /// Radiance times pi.
  glm::dvec3 seen(const std::vector<Beam>& beams, const glm::dvec3& eye) const {
    glm::dvec3 sum(0.0);
    for (const Beam& beam : beams)
      for (int c = 0; c < 3; ++c)
        sum[c] += beam.irradiance[c] * sail(layers_[static_cast<std::size_t>(c)], hot_spot_,
                                            soil_[c], between(beam.direction, eye))
                                           .sun_to_eye;
    return sum;
  }

  /// Fraction of the ground that is seen at an angle off the vertical: black leaves over a white
  /// ground, which sun and eye meet by gaps that they do not share.
  double gaps(double zenith) const {
    const LeafLayer black{leaf_angles(foliage_.bits()), {1e-9, 1e-9}, foliage_.leaf_area_index()};
    return std::sqrt(sail({&black, 1}, 0.0, 1.0, {zenith, zenith, 0.0}).sun_to_eye);
  }

  const CanopyFoliage& foliage() const { return foliage_; }
  const TwoKinds& kinds() const { return kinds_; }
  double hot_spot() const { return hot_spot_; }

 private:
  CanopyFoliage foliage_;
  TwoKinds kinds_;
  double hot_spot_;
  glm::dvec3 soil_;
  std::array<std::vector<LeafLayer>, 3> layers_;  ///< per channel
};

/// gaps() of the blades themselves, whose places are not quite random.
double gaps_of_blades(const scene::Scene& scene, double weathering, double zenith) {
  constexpr int around = 16;
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < around; ++i) {
    const double azimuth = 2.0 * pi * i / around;
    directions.emplace_back(std::sin(zenith) * std::cos(azimuth),
                            std::sin(zenith) * std::sin(azimuth), std::cos(zenith));
  }
  const grass::MeadowModel model(scene);
  double sum = 0.0;
  for (int variant = 0; variant < scene.grass.variants; ++variant) {
    const grass::BladePatch patch = grass::WitheringPatch(scene, model, variant).at(weathering);
    sum += grass::blade_transmittance(patch.blades, patch.poses, patch.patch_m, directions);
  }
  return sum / scene.grass.variants;
}

/// Prints what was measured of the leaves. Whether theory's gaps are the blades' within 5 %.
bool describe(const CanopyTheory& theory, double weathering) {
  fmt::print(
      "degree {:5}: leaf area index {:.2f}, hot spot {:.3f}, brown {:.2f}, dissociation {:.2f}",
      weathering, theory.foliage().leaf_area_index(), theory.hot_spot(),
      theory.kinds().brown_fraction(), theory.kinds().dissociation());
  fmt::print("; gaps, theory over blades:");
  bool good = true;
  for (const double zenith_deg : {0.0, 20.0, 40.0, 60.0, 70.0}) {
    const double zenith = glm::radians(zenith_deg);
    const double ratio =
        theory.gaps(zenith) / gaps_of_blades(canopy_scene(45.0), weathering, zenith);
    fmt::print(" {:.3f}", ratio);
    good = good && std::abs(ratio - 1.0) < 0.05;
  }
  fmt::print("\n");
  return good;
}

/// How far one witness is off another, in red and green and in blue.
struct Errors {
  std::vector<double> red_green, blue;

  void add(const glm::dvec3& got, const glm::dvec3& wanted) {
    const glm::dvec3 off = glm::abs(got / wanted - 1.0);
    red_green.insert(red_green.end(), {off.r, off.g});
    blue.push_back(off.b);
  }
  double within(double limit) const {
    return static_cast<double>(
               std::ranges::count_if(red_green, [&](double e) { return e <= limit; })) /
           static_cast<double>(red_green.size());
  }
};

void print_row(const CanopyView& row, const glm::dvec3& got, const glm::dvec3& wanted) {
  const glm::dvec3 ratio = got / wanted;
  fmt::print("{:3} {:5} {:9} {:4}  {:.3f} {:.3f} {:.3f}\n", row.sun_deg, row.weathering, row.plane,
             row.view_deg, ratio.r, ratio.g, ratio.b);
}

void sum_up(const char* name, const Errors& errors) {
  fmt::print("{:28} {:9.1f} {:7.1f} {:8.1f} {:15.1f} {:14.1f} {:7.1f}\n", name,
             100.0 * quantile(errors.red_green, 0.5), 100.0 * quantile(errors.red_green, 0.95),
             100.0 * quantile(errors.red_green, 1.0), 100.0 * errors.within(0.1),
             100.0 * quantile(errors.blue, 0.5), 100.0 * quantile(errors.blue, 1.0));
}

/// Of red and green, what theory has been off the reference by: half of the figures, all of them,
/// and how many are within 10 %.
bool within_bounds(const Errors& errors) {
  return quantile(errors.red_green, 0.5) < 0.026 && quantile(errors.red_green, 1.0) < 0.2 &&
         errors.within(0.1) > 0.985;
}

}  // namespace

int compare(const std::filesystem::path& reference, bool with_texels, bool prints_rows) {
  const CanopyTable table = read_canopy_table(reference);
  std::map<double, CanopyTheory> theories;
  for (const auto& [light, views] : table)
    theories.try_emplace(light.second, canopy_scene(light.first), light.second);
  bool good = true;
  for (const auto& [weathering, theory] : theories) good = describe(theory, weathering) && good;
  Errors of_paths, of_texels;
  for (const auto& [light, views] : table) {
    const scene::Scene scene = canopy_scene(light.first);
    const std::vector<Beam> beams = beams_of(light::Daylight(scene.sun, scene.sky));
    const CanopyTheory& theory = theories.at(light.second);
    std::optional<CanopyTexels> texels;
    if (with_texels) texels.emplace(light.first, light.second);
    for (const CanopyView& row : views) {
      const glm::dvec3 got = theory.seen(beams, row.towards_eye());
      of_paths.add(got, row.radiance);
      if (texels) of_texels.add(got, texels->seen(0, row.towards_eye()));
      if (prints_rows) print_row(row, got, row.radiance);
    }
    std::fflush(stdout);
  }
  fmt::print(
      "4SAIL2, red and green:        median %  95th %  worst %  within 10 %, %  blue: median "
      "% worst %\n");
  sum_up("against traced paths", of_paths);
  if (with_texels) sum_up("against the finest texels", of_texels);
  good = good && within_bounds(of_paths);
  if (!good) fmt::print("OUT OF BOUNDS\n");
  return good ? 0 : 1;
}

}  // namespace wold::test

int main(int count, char** arguments) {
  if (count < 2) {
    fmt::print(stderr, "usage: canopy_sail REFERENCE.csv [--texels] [--rows]\n");
    return 2;
  }
  const auto given = [&](const char* name) {
    return std::any_of(arguments + 2, arguments + count,
                       [&](const char* argument) { return std::strcmp(argument, name) == 0; });
  };
  try {
    return wold::test::compare(arguments[1], given("--texels"), given("--rows"));
  } catch (const wold::Error& error) {
    fmt::print(stderr, "canopy_sail: {}\n", error.what());
    return 4;
  }
}
