// Light in clouds against paths followed through the same grid (clouds.py):
//
//     cloud_light [REFERENCES [PICTURES]]
//
// prints for each sun: mean radiance where the cloud hides all, over the reference's; FLIP between
// the pictures as a camera exposes them, and of means of 2 x 2 pixels, which leave half of the
// paths' noise; of both, the rim's radiance and the base's over the core's, and how much redder the
// base is. Exits with 1 where the product is beyond its bounds.
// PICTURES: a folder for pictures, the product's on the left.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "cloud_scene.h"
#include "compare/flip.h"
#include "core/colour.h"
#include "core/files.h"
#include "core/image.h"
#include "core/parallel.h"
#include "landscape/perspective.h"
#include "sky/exposure.h"
#include "support/places.h"

namespace wold {
namespace {

namespace fs = std::filesystem;

/// What lines of sight through a pixel meet.
struct Seen {
  glm::dvec3 sent{0.0};  ///< by the cloud
  double through = 1.0;
};

/// The numbers of a grid's eight voxels around a place, with what each counts.
class Corners {
 public:
  Corners(const cloud::VoxelBox& box, const glm::dvec3& place_m) {
    const glm::dvec3 at = (place_m - box.corner_m) / box.voxel_m - 0.5;
    const glm::dvec3 low = glm::floor(at);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 high(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 part = glm::mix(1.0 - (at - low), at - low, high);
      const glm::ivec3 voxel = glm::clamp(glm::ivec3(low + high), glm::ivec3(0), box.voxels - 1);
      index[corner] =
          static_cast<std::size_t>((voxel.z * box.voxels.y + voxel.y) * box.voxels.x + voxel.x);
      weight[corner] = part.x * part.y * part.z;
    }
  }
  std::size_t index[8];
  double weight[8];
};

/// Distances at which a line of sight goes into the box and leaves it.
std::pair<double, double> inside_m(const cloud::VoxelBox& box, const glm::dvec3& eye_m,
                                   const glm::dvec3& direction) {
  const glm::dvec3 low = (box.corner_m - eye_m) / direction;
  const glm::dvec3 high = (box.corner_m + glm::dvec3(box.voxels) * box.voxel_m - eye_m) / direction;
  const glm::dvec3 in = glm::min(low, high), out = glm::max(low, high);
  return {std::max({in.x, in.y, in.z, 0.0}), std::min({out.x, out.y, out.z})};
}

/// Emission and absorption along a line of sight, as renderers have it.
Seen seen_along(const cloud::CloudVolume& volume, const std::vector<glm::vec3>& source,
                const glm::dvec3& eye_m, const glm::dvec3& direction) {
  constexpr double step_m = 4.0;
  const auto [first_m, last_m] = inside_m(volume.box, eye_m, direction);
  Seen seen;
  for (double at_m = first_m + 0.5 * step_m; at_m < last_m; at_m += step_m) {
    const Corners corners(volume.box, eye_m + at_m * direction);
    double extinction_per_m = 0.0;
    glm::dvec3 emission_per_m(0.0);
    for (int i = 0; i < 8; ++i) {
      const double part = corners.weight[i] * double{volume.extinction_per_m[corners.index[i]]};
      extinction_per_m += part;
      emission_per_m += part * glm::dvec3(source[corners.index[i]]);
    }
    if (extinction_per_m <= 0.0) continue;
    const double hidden = seen.through * -std::expm1(-extinction_per_m * step_m);
    seen.sent += hidden * emission_per_m / extinction_per_m;
    seen.through -= hidden;
  }
  return seen;
}

/// A sun's picture: what the cloud sends, what it lets through, and all that is seen.
struct Picture {
  std::vector<Seen> seen;
  Image radiance;
};

Picture product_picture(const cloud::CloudVolume& volume, const light::Daylight& day) {
  constexpr int rays = 3;
  const landscape::Camera camera = test::cloud_camera();
  const glm::ivec2 size = test::cloud_picture_px;
  const landscape::Perspective perspective(camera, size);
  const std::vector<glm::vec3> source =
      cloud::source_radiance(volume, cloud::cloud_light(day, test::cloud_middle_m, camera.eye_m));
  Picture picture{std::vector<Seen>(static_cast<std::size_t>(size.x * size.y)),
                  Image(size.x, size.y, 3)};
  parallel_for(picture.seen.size(), [&](std::size_t i) {
    const glm::dvec2 corner(i % static_cast<std::size_t>(size.x),
                            i / static_cast<std::size_t>(size.x));
    Seen sum{{}, 0.0};
    glm::dvec3 radiance(0.0);
    for (int ray = 0; ray < rays * rays; ++ray) {
      const glm::dvec2 part = (glm::dvec2(ray % rays, ray / rays) + 0.5) / double{rays};
      const glm::dvec3 direction = perspective.direction(corner + part);
      const Seen seen = seen_along(volume, source, camera.eye_m, direction);
      sum.sent += seen.sent / double{rays * rays};
      sum.through += seen.through / double{rays * rays};
      radiance += seen.sent + seen.through * glm::dvec3(test::cloud_surroundings(day, direction));
    }
    picture.seen[i] = sum;
    for (int c = 0; c < 3; ++c)
      picture.radiance.values[3 * i + static_cast<std::size_t>(c)] =
          static_cast<float>(radiance[c] / double{rays * rays});
  });
  return picture;
}

Image exposed(Image picture, double gain) {
  for (float& value : picture.values)
    value = static_cast<float>(srgb_encoded(std::clamp(gain * double{value}, 0.0, 1.0)));
  return picture;
}

/// Means of 2 x 2 pixels; sides are even.
Image halved(const Image& picture) {
  Image half(picture.width / 2, picture.height / 2, 3);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int c = 0; c < 3; ++c)
        half.pixel(x, y)[c] =
            0.25F * (picture.pixel(2 * x, 2 * y)[c] + picture.pixel(2 * x + 1, 2 * y)[c] +
                     picture.pixel(2 * x, 2 * y + 1)[c] + picture.pixel(2 * x + 1, 2 * y + 1)[c]);
  return half;
}

/// FLIP's mean over the pictures as a camera with that gain exposes them.
double mean_flip(const Image& got, const Image& want, double gain) {
  const Image difference = compare::flip_map(exposed(got, gain), exposed(want, gain));
  double sum = 0.0;
  for (const float value : difference.values) sum += double{value};
  return sum / static_cast<double>(difference.values.size());
}

glm::dvec3 mean_where(const Image& picture, const std::vector<bool>& counts) {
  glm::dvec3 sum(0.0);
  int pixels = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (!counts[i]) continue;
    for (int c = 0; c < 3; ++c)
      sum[c] += double{picture.values[3 * i + static_cast<std::size_t>(c)]};
    ++pixels;
  }
  return sum / std::max(1.0, static_cast<double>(pixels));
}

/// Parts of the picture.
struct Parts {
  std::vector<bool> cloud, rim, core, base;
};

/// Of the cloud: the rim lets a fifth to four fifths through, the core nothing; the base is the
/// lowest fifth of every column of pixels through the core.
Parts parts_of(const Picture& product) {
  const glm::ivec2 size = test::cloud_picture_px;
  const std::size_t count = product.seen.size();
  Parts parts{std::vector<bool>(count), std::vector<bool>(count), std::vector<bool>(count),
              std::vector<bool>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const double through = product.seen[i].through;
    parts.cloud[i] = through < 0.5;
    parts.rim[i] = through > 0.2 && through < 0.8;
  }
  for (int x = 0; x < size.x; ++x) {
    int low = -1, high = -1;
    for (int y = 0; y < size.y; ++y) {
      if (product.seen[static_cast<std::size_t>(y * size.x + x)].through > 0.02) continue;
      if (high < 0) high = y;
      low = y;
    }
    const int height = low - high + 1;
    if (high < 0 || height < 5) continue;
    for (int y = high; y <= low; ++y) {
      const auto i = static_cast<std::size_t>(y * size.x + x);
      parts.base[i] = low - y < height / 5;
      parts.core[i] = y - high >= height / 3 && low - y >= height / 3;
    }
  }
  return parts;
}

double brightness(const glm::dvec3& colour) { return luminance(glm::vec3(colour)); }
double redness(const glm::dvec3& colour) { return colour.r / colour.b; }

/// Over the core's.
struct Ratios {
  double rim, base, redness_of_base;
};

Ratios ratios_of(const Image& picture, const Parts& parts) {
  const glm::dvec3 rim = mean_where(picture, parts.rim), core = mean_where(picture, parts.core),
                   base = mean_where(picture, parts.base);
  return {brightness(rim) / brightness(core), brightness(base) / brightness(core),
          redness(base) / redness(core)};
}

std::string text_of(const Ratios& ratios) {
  return fmt::format("{:5.2f} {:5.2f} {:5.2f}", ratios.rim, ratios.base, ratios.redness_of_base);
}

void write_beside(const fs::path& path, const Image& left, const Image& right) {
  constexpr int times = 8;
  Image both(2 * times * left.width, times * left.height, 3);
  for (int y = 0; y < both.height; ++y)
    for (int x = 0; x < both.width; ++x) {
      const int at = x / times;
      const Image& from = at < left.width ? left : right;
      std::copy_n(from.pixel(at % left.width, y / times), 3, both.pixel(x, y));
    }
  write_image(path, both, PixelFormat::uint8);
}

/// The references have 4,096 paths a pixel, whose noise is a small part of FLIP's bounds.
bool is_within_bounds(const test::CloudSun& sun, double mean_ratio, double flip,
                      double flip_of_halved, const Ratios& ratios) {
  const bool is_low = sun.elevation_deg < 10.0;
  const double max_flip = is_low ? 0.085 : 0.058, max_flip_of_halved = is_low ? 0.078 : 0.052;
  const bool is_before_the_sun = sun.side == "towards";
  if (sun.elevation_deg < 5.0)
    return !is_before_the_sun || (ratios.base > 1.0 && ratios.redness_of_base > 1.0);
  return std::abs(mean_ratio - 1.0) < 0.10 && flip <= max_flip &&
         flip_of_halved <= max_flip_of_halved &&
         (!is_before_the_sun || sun.elevation_deg > 30.0 || ratios.rim > 3.0);
}

bool compare_all(const fs::path& references, const fs::path& pictures) {
  const cloud::CloudVolume volume = test::cloud_volume(test::tests_folder() / "data/light");
  bool good = true;
  fmt::print(
      "sun            mean   FLIP  2x2    rim   base  redder  (reference: rim base redder)\n");
  for (const test::CloudSun& sun : test::cloud_suns()) {
    const std::string name = fmt::format("{:.0f}_{}", sun.elevation_deg, sun.side);
    const fs::path file = references / fmt::format("cloud_{}.exr", name);
    if (sun.elevation_deg < 5.0 && !fs::exists(file)) continue;
    const scene::Scene scene = test::cloud_scene(sun);
    const light::Daylight day(scene.sun, scene.sky);
    const Picture product = product_picture(volume, day);
    const Image reference = read_image(file);
    const Parts parts = parts_of(product);
    const double gain = sky::metered_gain(day, sky::Subject::clouds);
    const double flip = mean_flip(product.radiance, reference, gain);
    const double flip_of_halved = mean_flip(halved(product.radiance), halved(reference), gain);
    const double mean_ratio = brightness(mean_where(product.radiance, parts.cloud)) /
                              brightness(mean_where(reference, parts.cloud));
    const Ratios got_ratios = ratios_of(product.radiance, parts);
    const bool is_good = is_within_bounds(sun, mean_ratio, flip, flip_of_halved, got_ratios);
    good = good && is_good;
    fmt::print("{:<14} {:5.3f} {:5.3f} {:5.3f}  {}   ({}) {}\n", name, mean_ratio, flip,
               flip_of_halved, text_of(got_ratios), text_of(ratios_of(reference, parts)),
               is_good ? "" : "BEYOND");
    if (!pictures.empty())
      write_beside(pictures / (name + ".png"), exposed(product.radiance, gain),
                   exposed(reference, gain));
  }
  return good;
}

}  // namespace
}  // namespace wold

int main(int count, char** arguments) {
  const std::filesystem::path own = wold::test::tests_folder() / "data/light";
  const bool good =
      wold::compare_all(count > 1 ? arguments[1] : own, count > 2 ? arguments[2] : "");
  return good ? 0 : 1;
}
