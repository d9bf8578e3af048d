// Light in texels against paths traced through the blades they stand for (canopy.py):
//
//     canopy_light REFERENCE.csv [--rows]
//
// Prints how far each level of the default meadow is off, over suns, weathering degrees and views;
// with --rows each of them. Exit status 1 when a figure is out of its bounds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "canopy_scene.h"
#include "core/colour.h"
#include "core/colour_difference.h"
#include "core/error.h"
#include "core/parallel.h"
#include "grass/optics/light_under_grass.h"
#include "grass/texel/baking.h"
#include "grass/texel/columns.h"
#include "grass/texel/fibres.h"
#include "grass/texel/samples.h"
#include "grass/texel/time_varying_texel.h"
#include "light/daylight.h"
#include "meadow/lean_light.h"

namespace wold::test {
namespace {

using grass::VolumeData;

/// A row of the reference. Radiance is times pi, over the irradiance of level ground.
struct Row {
  double sun_deg, weathering;
  std::string plane;
  double view_deg;
  glm::dvec3 radiance;
};

std::vector<Row> read_reference(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    Row row;
    cells >> row.sun_deg >> row.weathering >> row.plane >> row.view_deg >> row.radiance.r >>
        row.radiance.g >> row.radiance.b;
    if (!cells) throw FileError(fmt::format("{}: found \"{}\"", path.string(), line));
    rows.push_back(row);
  }
  return rows;
}

/// Towards the eye: from the north in the principal plane, from the east across it.
glm::dvec3 towards_eye(const Row& row) {
  const double view = glm::radians(row.view_deg);
  return row.plane == "principal" ? glm::dvec3(0.0, std::sin(view), std::cos(view))
                                  : glm::dvec3(std::sin(view), 0.0, std::cos(view));
}

glm::vec3 soil(const scene::Scene& scene) {
  const auto& albedo = scene.terrain.ground_albedo;
  return {albedo[0], albedo[1], albedo[2]};
}

/// The default meadow under one sun at one weathering degree, baked as it is for films.
class Canopy {
 public:
  Canopy(double sun_deg, double weathering)
      : scene_(canopy_scene(sun_deg)),
        model_(scene_),
        lighting_(
            grass::make_lighting(light::Daylight(scene_.sun, scene_.sky), baked_eye, soil(scene_))),
        lean_light_(grass::representative_fibres(
                        grass::WitheringPatch(scene_, model_, 0).at(weathering), model_, 150),
                    lighting_, static_cast<float>(scene_.grass.specular_exponent)),
        under_grass_(grass::light_under_grass(
            grass::WitheringPatch(scene_, model_, 0).at(weathering), model_, lighting_)),
        variants_(static_cast<std::size_t>(scene_.grass.variants)) {
    const grass::TexelShape shape =
        grass::TimeVaryingTexel(scene_, {lighting_}, std::filesystem::temp_directory_path())
            .shape();
    parallel_for(variants_.size(), [&](std::size_t variant) {
      grass::Samples samples(scene_, shape, static_cast<int>(variant), model_);
      samples.advance_to(weathering);
      variants_[variant] = grass::bake_lods(
          samples.texel(), samples.all(), lighting_,
          {static_cast<float>(scene_.grass.specular_exponent), scene_.grass.width_m},
          scene_.grass.lods, {0});
    });
  }

  std::size_t lods() const { return scene_.grass.lods.size(); }

  /// Radiance of grass and ground times pi.
  glm::dvec3 seen(std::size_t lod, const glm::dvec3& towards_eye) const {
    const glm::dvec3 factor(lean_light_.factor(glm::dvec2(0.0), towards_eye));
    glm::dvec3 sum(0.0);
    for (const std::vector<VolumeData>& lods : variants_)
      sum += seen(lods[lod], towards_eye, factor) / static_cast<double>(variants_.size());
    return sum * std::numbers::pi;
  }

 private:
  glm::dvec3 seen(const VolumeData& volume, const glm::dvec3& towards_eye,
                  const glm::dvec3& factor) const {
    const grass::VoxelRows voxels(volume.shape, volume.voxel);
    double uncovered = 0.0;
    const std::vector<float> depths = optical_depths(voxels, volume.density, towards_eye);
    for (const float depth : depths)
      uncovered += std::exp(-double{depth}) / static_cast<double>(depths.size());
    return factor * mean_radiance(voxels, volume.density, volume.emission.front(), towards_eye) +
           uncovered * ground();
  }

  /// Radiance of the ground under grass.
  glm::dvec3 ground() const {
    return glm::dvec3(soil(scene_)) * glm::dvec3(under_grass_) / std::numbers::pi;
  }

  /// That of a film whose camera stands in the north and looks down a little.
  static constexpr glm::dvec3 baked_eye{0.0, 0.9659, 0.2588};

  scene::Scene scene_;
  grass::MeadowModel model_;
  grass::Lighting lighting_;
  meadow::LeanLight lean_light_;
  glm::vec3 under_grass_;
  std::vector<std::vector<VolumeData>> variants_;
};

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

double quantile(std::vector<double> values, double fraction) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1))];
}

/// What a level may be off by at most: half of all figures, nineteen of twenty, and half of all
/// colours (CIEDE2000; 1 is just noticeable).
struct Bounds {
  double median, most, colour;
};
constexpr std::array bounds = {Bounds{0.026, 0.085, 0.65}, Bounds{0.027, 0.09, 0.65},
                               Bounds{0.03, 0.1, 0.7}, Bounds{0.032, 0.11, 0.7}};

/// Prints the errors of each level; whether all are within bounds.
bool sum_up(const std::map<std::size_t, Errors>& errors) {
  bool good = true;
  fmt::print("level  median %  95th %  worst %   CIEDE2000 median  worst\n");
  for (const auto& [lod, error] : errors) {
    const auto relative = [&](double fraction) { return quantile(error.relative, fraction); };
    const Bounds& bound = bounds.at(lod);
    const bool within = relative(0.5) <= bound.median && relative(0.95) <= bound.most &&
                        quantile(error.colour, 0.5) <= bound.colour;
    fmt::print("{:5} {:9.1f} {:7.1f} {:8.1f} {:19.2f} {:6.2f} {}\n", lod, 100.0 * relative(0.5),
               100.0 * relative(0.95), 100.0 * relative(1.0), quantile(error.colour, 0.5),
               quantile(error.colour, 1.0), within ? "" : "OUT OF BOUNDS");
    good = good && within;
  }
  return good;
}

}  // namespace

int compare(const std::filesystem::path& reference, bool prints_rows) {
  std::map<std::pair<double, double>, std::vector<Row>> rows;
  for (const Row& row : read_reference(reference))
    rows[{row.sun_deg, row.weathering}].push_back(row);
  std::map<std::size_t, Errors> errors;
  for (const auto& [light, views] : rows) {
    const Canopy canopy(light.first, light.second);
    for (std::size_t lod = 0; lod < canopy.lods(); ++lod)
      for (const Row& row : views) {
        const glm::dvec3 got = canopy.seen(lod, towards_eye(row));
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
