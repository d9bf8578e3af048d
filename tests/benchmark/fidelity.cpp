#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/colour.h"
#include "core/colour_difference.h"
#include "grass/baking.h"
#include "grass/blade_picture.h"
#include "grass/blade_tubes.h"
#include "grass/columns.h"
#include "grass/levels.h"
#include "grass/samples.h"
#include "grass/time_varying_texel.h"
#include "light/daylight.h"

/// How true the texel is to the blades it stands for: what both show of the default meadow, from
/// three elevations and at four weathering degrees, under the same light. Prints a table; exit
/// status 1 when a figure is out of its bounds.
namespace {

using namespace wold;
using namespace wold::grass;

constexpr double coverage_bound = 0.03;
constexpr double colour_bound = 4.0;  // CIEDE2000
constexpr double brightness_bound = 0.05;

/// What is seen of a patch: the share of the ground it covers, and its own mean radiance there.
struct Seen {
  double coverage = 0.0;
  glm::dvec3 radiance{0.0};
};

/// Radiance with a white card in the open exposed as in the pictures (landscape/assemble.h).
glm::dvec3 lab(const glm::dvec3& radiance) {
  constexpr double gain = 1.6 * 3.14159265358979;
  return lab_from_xyz(xyz_from_srgb(glm::clamp(radiance * gain, 0.0, 1.0)));
}

Seen blades_seen(const BladePatch& patch, const Tubes& tubes, const glm::dvec3& direction) {
  const BladePicture picture(patch, direction, 1024);
  Seen seen;
  seen.coverage = picture.coverage();
  double count = 0.0;
  for (const BladePicture::Pixel& pixel : picture.pixels()) {
    if (pixel.blade == BladePicture::nothing) continue;
    const double place = double{pixel.along} * (tubes.rings - 1);
    const auto ring =
        std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(tubes.rings) - 2);
    const std::size_t at = pixel.blade * static_cast<std::size_t>(tubes.rings) + ring;
    seen.radiance += glm::dvec3(glm::mix(tubes.radiance[at], tubes.radiance[at + 1],
                                         static_cast<float>(place - static_cast<double>(ring))));
    count += 1.0;
  }
  seen.radiance /= count;
  return seen;
}

Seen texel_seen(const VolumeData& volume, const glm::dvec3& direction) {
  const VoxelRows voxels(volume.shape, volume.voxel);
  Seen seen;
  const std::vector<float> depths = optical_depths(voxels, volume.density, direction);
  for (float depth : depths) seen.coverage += -std::expm1(-double{depth});
  seen.coverage /= static_cast<double>(depths.size());
  seen.radiance =
      mean_radiance(voxels, volume.density, volume.emission.front(), direction) / seen.coverage;
  return seen;
}

class Meadow {
 public:
  Meadow()
      : model_(scene_.ageing, scene_.grass.specular),
        lighting_(make_lighting(light::Daylight(scene_.sun, scene_.sky), {0.0, -1.0, 0.0})),
        look_{static_cast<float>(scene_.grass.gloss), scene_.grass.width_m},
        shape_(
            TimeVaryingTexel(scene_, {lighting_}, std::filesystem::temp_directory_path()).shape()) {
  }

  /// Prints a line per direction; returns whether all are within bounds.
  bool compare(double weathering) const {
    const BladePatch patch = WitheringPatch(scene_, model_, 0).at(weathering);
    const Tubes tubes = blade_tubes(patch, model_, lighting_, look_);
    const std::vector<VolumeData> levels = baked_texel(weathering);
    bool good = true;
    for (const double elevation : {15.0, 45.0, 90.0}) {
      const auto mean = [&](const auto& seen_from) {
        Seen sum;
        const auto directions = transmittance_directions(elevation);
        for (const auto& direction : directions) {
          const Seen one = seen_from(direction);
          sum.coverage += one.coverage / static_cast<double>(directions.size());
          sum.radiance += one.radiance / static_cast<double>(directions.size());
        }
        return sum;
      };
      const Seen blades = mean([&](const auto& from) { return blades_seen(patch, tubes, from); });
      const Seen texel = mean([&](const auto& from) { return texel_seen(levels.front(), from); });
      good = print(weathering, elevation, blades, texel) && good;
    }
    return good;
  }

 private:
  std::vector<VolumeData> baked_texel(double weathering) const {
    Samples samples(scene_, shape_, 0, model_);
    samples.advance_to(weathering);
    const std::vector<int> sides = {shape_.side};
    return bake_levels(samples.texel(), samples.all(), lighting_, look_, sides, {0});
  }

  static bool print(double weathering, double elevation, const Seen& blades, const Seen& texel) {
    const double apart = texel.coverage - blades.coverage;
    const double colour = colour_difference(lab(blades.radiance), lab(texel.radiance));
    const double brightness = luminance(texel.radiance) / luminance(blades.radiance) - 1.0;
    const bool good = std::abs(apart) <= coverage_bound && colour <= colour_bound &&
                      std::abs(brightness) <= brightness_bound;
    fmt::print("{:10.3f} {:9.0f} {:8.3f} {:8.3f} {:+8.3f} {:10.2f} {:+10.1f} {}\n", weathering,
               elevation, blades.coverage, texel.coverage, apart, colour, 100.0 * brightness,
               good ? "" : " OUT OF BOUNDS");
    return good;
  }

  scene::Scene scene_;
  AgeingModel model_;
  Lighting lighting_;
  FibreLook look_;
  TexelShape shape_;
};

}  // namespace

int main() {
  fmt::print(
      "Texel against the blades it stands for. Bounds: coverage {}, colour {} (CIEDE2000), "
      "brightness {} %\n\n",
      coverage_bound, colour_bound, 100.0 * brightness_bound);
  fmt::print("{:>10} {:>9} {:>8} {:>8} {:>8} {:>10} {:>10}\n", "weathering", "elevation", "blades",
             "texel", "apart", "colour", "bright. %");
  const Meadow meadow;
  bool good = true;
  for (const double weathering : {0.0, 0.3, 0.6, 0.917}) good = meadow.compare(weathering) && good;
  return good ? 0 : 1;
}
