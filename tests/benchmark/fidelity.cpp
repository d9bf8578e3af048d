#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "core/colour.h"
#include "core/colour_difference.h"
#include "core/parallel.h"
#include "grass/geometry/blade_tubes.h"
#include "grass/optics/blade_picture.h"
#include "grass/texel/baking.h"
#include "grass/texel/columns.h"
#include "grass/texel/lods.h"
#include "grass/texel/samples.h"
#include "grass/texel/time_varying_texel.h"
#include "light/daylight.h"

/// How true what is shipped is to the blades it stands for: what both show of the default meadow,
/// all its variants together, at each of its levels and at four weathering degrees, under the same
/// light. From elevations and azimuths that neither extinctions nor brightnesses were fitted at
/// (levels.h has those: 15, 30, 45 and 90 degrees). Prints a table; exit status 1 when a figure is
/// out of its bounds.
namespace {

using namespace wold;
using namespace wold::grass;

constexpr std::array<double, 4> elevations_deg = {10.0, 25.0, 60.0, 80.0};
constexpr std::array<double, 4> weathering_degrees = {0.0, 0.3, 0.6, 0.917};

/// Half-way between the azimuths of the fits.
std::vector<glm::dvec3> unfitted_directions(double elevation_deg) {
  std::vector<glm::dvec3> directions;
  for (const double azimuth_deg : {68.0, 158.0})
    directions.push_back(direction_at(glm::radians(elevation_deg), glm::radians(azimuth_deg)));
  return directions;
}

/// What a level may be off by. Coverage and colour alike for all: a fiftieth of the ground, and the
/// difference of colours that is just noticeable (Mahy and others 1994, Color Research and
/// Application 19:105: 2.3). Brightness is what the levels reach; it is worst from above, where
/// coarser ones have lost more of the gaps between blades.
constexpr double max_coverage = 0.02;
constexpr double max_colour = 2.3;                                          // CIEDE2000
constexpr std::array<double, 4> max_brightness = {0.06, 0.07, 0.08, 0.09};  ///< finest level first

/// What is seen of a patch: the fraction of the ground it covers, and its own mean radiance there.
struct Seen {
  double coverage = 0.0;
  glm::dvec3 radiance{0.0};
};

/// Radiance with a white card in the open exposed as in the pictures (film/assemble.h).
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

/// A sum of what is seen of several patches from several directions.
struct Sum {
  double coverage = 0.0;
  glm::dvec3 light{0.0};  ///< what patches send, not their own mean radiance
  int count = 0;

  void add(const Seen& seen) {
    coverage += seen.coverage;
    light += seen.coverage * seen.radiance;
    ++count;
  }
  void add(const Sum& other) {
    coverage += other.coverage;
    light += other.light;
    count += other.count;
  }
  Seen mean() const { return {coverage / count, light / coverage}; }
};

/// What is seen of blades and of each level, by elevation.
struct Sights {
  using ByElevation = std::array<Sum, elevations_deg.size()>;
  ByElevation blades;
  std::array<ByElevation, max_brightness.size()> lods;

  void add(const Sights& other) {
    for (std::size_t e = 0; e < elevations_deg.size(); ++e) {
      blades[e].add(other.blades[e]);
      for (std::size_t lod = 0; lod < lods.size(); ++lod) lods[lod][e].add(other.lods[lod][e]);
    }
  }
};

/// The largest differences of a level, over elevations and weathering degrees.
struct Worst {
  double coverage = 0.0, colour = 0.0, brightness = 0.0;
};

class Meadow {
 public:
  Meadow()
      : model_(scene_),
        lighting_(make_lighting(light::Daylight(scene_.sun, scene_.sky), {0.0, -1.0, 0.0},
                                glm::vec3(0.0F))),
        look_{static_cast<float>(scene_.grass.specular_exponent), scene_.grass.width_m},
        shape_(
            TimeVaryingTexel(scene_, {lighting_}, std::filesystem::temp_directory_path()).shape()) {
    if (scene_.grass.lods.size() != max_brightness.size())
      throw std::logic_error("the default scene has another number of levels than have bounds");
  }

  /// Prints a line for each level and elevation.
  void compare(double weathering) {
    std::vector<Sights> of_variant(static_cast<std::size_t>(scene_.grass.variants));
    parallel_for(of_variant.size(), [&](std::size_t variant) {
      of_variant[variant] = look_at(static_cast<int>(variant), weathering);
    });
    Sights all;
    for (const Sights& one : of_variant) all.add(one);
    for (std::size_t lod = 0; lod < max_brightness.size(); ++lod)
      for (std::size_t e = 0; e < elevations_deg.size(); ++e)
        judge(weathering, lod, elevations_deg[e], all.blades[e].mean(), all.lods[lod][e].mean());
  }

  /// Prints the largest differences; whether all are within bounds.
  bool sum_up() const {
    fmt::print("\n{:>10} {:>18} {:>18} {:>18}\n", "voxels", "coverage", "colour", "brightness %");
    bool good = true;
    for (std::size_t lod = 0; lod < max_brightness.size(); ++lod) {
      const Worst& worst = worst_[lod];
      const double brightness = max_brightness[lod];
      const bool within = worst.coverage <= max_coverage && worst.colour <= max_colour &&
                          worst.brightness <= brightness;
      fmt::print("{:10} {:8.3f} of {:6.3f} {:8.2f} of {:6.2f} {:8.1f} of {:6.1f} {}\n",
                 scene_.grass.lods[lod], worst.coverage, max_coverage, worst.colour, max_colour,
                 100.0 * worst.brightness, 100.0 * brightness, within ? "" : " OUT OF BOUNDS");
      good = good && within;
    }
    return good;
  }

 private:
  Sights look_at(int variant, double weathering) const {
    const BladePatch patch = WitheringPatch(scene_, model_, variant).at(weathering);
    const Tubes tubes = blade_tubes(patch, model_, lighting_, look_);
    const std::vector<VolumeData> lods = baked_lods(variant, weathering);
    Sights sights;
    for (std::size_t e = 0; e < elevations_deg.size(); ++e)
      for (const glm::dvec3& direction : unfitted_directions(elevations_deg[e])) {
        sights.blades[e].add(blades_seen(patch, tubes, direction));
        for (std::size_t lod = 0; lod < lods.size(); ++lod)
          sights.lods[lod][e].add(texel_seen(lods[lod], direction));
      }
    return sights;
  }

  std::vector<VolumeData> baked_lods(int variant, double weathering) const {
    Samples samples(scene_, shape_, variant, model_);
    samples.advance_to(weathering);
    return bake_lods(samples.texel(), samples.all(), lighting_, look_, scene_.grass.lods, {0});
  }

  void judge(double weathering, std::size_t lod, double elevation_deg, const Seen& blades,
             const Seen& texel) {
    const double apart = texel.coverage - blades.coverage;
    const double colour = colour_difference(lab(blades.radiance), lab(texel.radiance));
    const double brightness = luminance(texel.radiance) / luminance(blades.radiance) - 1.0;
    fmt::print("{:10.3f} {:6} {:9.0f} {:8.3f} {:8.3f} {:+8.3f} {:10.2f} {:+10.1f}\n", weathering,
               scene_.grass.lods[lod], elevation_deg, blades.coverage, texel.coverage, apart,
               colour, 100.0 * brightness);
    Worst& worst = worst_[lod];
    worst.coverage = std::max(worst.coverage, std::abs(apart));
    worst.colour = std::max(worst.colour, colour);
    worst.brightness = std::max(worst.brightness, std::abs(brightness));
  }

  scene::Scene scene_;
  MeadowModel model_;
  Lighting lighting_;
  FibreLook look_;
  TexelShape shape_;
  std::array<Worst, max_brightness.size()> worst_;
};

}  // namespace

int main() {
  fmt::print(
      "The default meadow's texels against the blades they stand for, from directions that\n"
      "nothing was fitted to: the mean of {} variants and two azimuths.\n\n",
      scene::Scene().grass.variants);
  fmt::print("{:>10} {:>6} {:>9} {:>8} {:>8} {:>8} {:>10} {:>10}\n", "weathering", "voxels",
             "elevation", "blades", "texel", "apart", "colour", "bright. %");
  Meadow meadow;
  for (const double weathering : weathering_degrees) meadow.compare(weathering);
  return meadow.sum_up() ? 0 : 1;
}
