#include "preview/ground_and_sky.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/parallel.h"

namespace wold::preview {
namespace {

using landscape::Landscape;

/// Bilinear value at a place in pixels from the upper left corner; `around`: columns repeat.
glm::vec3 sampled(const Image& image, double x, double y, bool around) {
  const double fx = x - 0.5;
  const double fy = std::clamp(y - 0.5, 0.0, image.height - 1.0);
  const auto i = static_cast<int>(std::floor(fx));
  const int j = std::min(static_cast<int>(fy), std::max(0, image.height - 2));
  const auto u = static_cast<float>(fx - i);
  const auto v = static_cast<float>(fy - j);
  const auto at = [&](int column, int row) {
    const int inside = around ? (column % image.width + image.width) % image.width
                              : std::clamp(column, 0, image.width - 1);
    const float* pixel = image.pixel(inside, std::min(row, image.height - 1));
    return glm::vec3(pixel[0], pixel[1], pixel[2]);
  };
  return glm::mix(glm::mix(at(i, j), at(i + 1, j), u), glm::mix(at(i, j + 1), at(i + 1, j + 1), u),
                  v);
}

/// What is seen along a ray and how far it is.
struct Hit {
  glm::vec3 radiance{0.0F};
  double distance_m = std::numeric_limits<double>::infinity();
};

glm::vec3 sky_radiance(const Image& sky, const glm::dvec3& direction) {
  const double azimuth = std::atan2(direction.x, direction.y) / (2.0 * std::numbers::pi);
  const double elevation = std::asin(std::clamp(direction.z, -1.0, 1.0)) / std::numbers::pi;
  return sampled(sky, (azimuth - std::floor(azimuth)) * sky.width, (0.5 - elevation) * sky.height,
                 /*around=*/true);
}

/// Where the ray meets the backdrop; nothing beside it.
std::optional<Hit> backdrop_hit(const landscape::Backdrop& backdrop, const glm::dvec3& eye_m,
                                const glm::dvec3& direction) {
  const glm::dvec3 normal = glm::cross(backdrop.right_m, backdrop.up_m);
  const double along = glm::dot(direction, normal);
  const double distance_m = glm::dot(backdrop.corner_m - eye_m, normal) / along;
  if (along == 0.0 || distance_m <= 0.0) return std::nullopt;
  const glm::dvec3 place = eye_m + distance_m * direction - backdrop.corner_m;
  const double u = glm::dot(place, backdrop.right_m) / glm::dot(backdrop.right_m, backdrop.right_m);
  const double v = glm::dot(place, backdrop.up_m) / glm::dot(backdrop.up_m, backdrop.up_m);
  if (u < 0.0 || u > 1.0 || v < 0.0 || v > 1.0) return std::nullopt;
  const Image& picture = backdrop.picture;
  return Hit{sampled(picture, u * picture.width, (1.0 - v) * picture.height, /*around=*/false),
             distance_m};
}

Hit behind_everything(const Landscape& landscape, const glm::dvec3& eye_m,
                      const glm::dvec3& direction) {
  if (landscape.backdrop)
    if (const auto hit = backdrop_hit(*landscape.backdrop, eye_m, direction)) return *hit;
  return {sky_radiance(landscape.sky, direction)};
}

/// The ground's radiance: of each finer picture inside its square, with soft borders.
glm::vec3 ground_radiance(const Landscape& landscape, const glm::dvec2& at_m) {
  glm::vec3 seen = landscape.ground.sample(at_m.x, at_m.y);
  const ColourMap* coarser = &landscape.ground;
  for (const landscape::GroundDetail& detail : landscape.ground_details) {
    const glm::dvec2 inside = at_m - detail.corner_m;
    const glm::dvec2 from_edge = glm::min(inside, detail.map.size_m() - inside);
    const double share =
        std::min(from_edge.x, from_edge.y) / landscape::soft_border_m(*coarser, detail);
    coarser = &detail.map;
    if (share > 0.0)
      seen = glm::mix(seen, detail.map.sample(inside.x, inside.y),
                      static_cast<float>(std::min(share, 1.0)));
  }
  return seen;
}

/// Rise over run where the terrain is steepest.
double steepest_slope(const Heightfield& terrain) {
  double steepest_m = 0.0;  // over a step
  for (int j = 0; j + 1 < terrain.samples(); ++j)
    for (int i = 0; i + 1 < terrain.samples(); ++i) {
      const float low = terrain.at(i, j), east = terrain.at(i + 1, j), north = terrain.at(i, j + 1),
                  high = terrain.at(i + 1, j + 1);
      const float east_m = std::max(std::abs(east - low), std::abs(high - north));
      const float north_m = std::max(std::abs(north - low), std::abs(high - east));
      steepest_m = std::max(steepest_m, double{std::hypot(east_m, north_m)});
    }
  return steepest_m / terrain.step_m();
}

/// Marches along rays until they are below the terrain.
class March {
 public:
  explicit March(const Heightfield& terrain)
      : terrain_(terrain),
        steepest_(steepest_slope(terrain)),
        low_(terrain.corner_m(),
             *std::min_element(terrain.values().begin(), terrain.values().end())),
        high_(terrain.corner_m() + terrain.size_m(),
              *std::max_element(terrain.values().begin(), terrain.values().end())) {}

  /// Distance to the ground; infinite where the ray meets none. It is known to be above the ground
  /// up to some distance.
  double distance_m(const glm::dvec3& eye_m, const glm::dvec3& direction,
                    double above_to_m = 0.0) const {
    const auto [begin, last] = inside_m(eye_m, direction);
    const double first = std::max(begin, above_to_m);
    const auto place = [&](double at_m) { return Place{at_m, gap_m(eye_m + at_m * direction)}; };
    // How much a gap can shrink along a metre of the ray; ground is taken as 60 degrees steep at
    // most, and what is narrower than the least step can be missed.
    const double closing =
        std::clamp(steepest_ * glm::length(glm::dvec2(direction)) - direction.z, 1e-9, 2.0);
    Place above{first, 0.0};
    for (double at = first; first < last;) {
      const Place here = place(at);
      if (here.gap_m <= 0.0) return at == first ? at : meeting_m(above, here, place);
      if (at >= last) break;
      above = here;
      const double least_m = 0.3 * terrain_.step_m() + 3e-3 * at;
      at = std::min(last, at + std::max(here.gap_m / closing, least_m));
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  /// The part of the ray within the terrain's box.
  std::pair<double, double> inside_m(const glm::dvec3& eye_m, const glm::dvec3& direction) const {
    double first = 0.0;
    double last = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
      const double low = (low_[axis] - 1e-3 - eye_m[axis]) / direction[axis];
      const double high = (high_[axis] + 1e-3 - eye_m[axis]) / direction[axis];
      first = std::max(first, std::min(low, high));
      last = std::min(last, std::max(low, high));
    }
    return {first, last};
  }

  /// A place along a ray and how high it is above the ground.
  struct Place {
    double at_m;
    double gap_m;
  };

  double gap_m(const glm::dvec3& at_m) const { return at_m.z - terrain_.sample(at_m.x, at_m.y); }

  /// Where the ray meets the ground between a place above it and one below, by false position: over
  /// so short a way the ground is almost even.
  template <class PlaceAt>
  static double meeting_m(Place above, Place below, const PlaceAt& place) {
    for (int i = 0; i < 3; ++i) {
      const double share = above.gap_m / (above.gap_m - below.gap_m);
      const Place middle = place(std::lerp(above.at_m, below.at_m, share));
      if (middle.gap_m > 0.0) {
        above = middle;
      } else {
        below = middle;
      }
    }
    return above.gap_m < -below.gap_m ? above.at_m : below.at_m;
  }

  const Heightfield& terrain_;
  double steepest_;
  glm::dvec3 low_;
  glm::dvec3 high_;
};

Hit seen(const Landscape& landscape, const glm::dvec3& eye_m, const glm::dvec3& direction,
         double distance_m) {
  if (!std::isfinite(distance_m)) return behind_everything(landscape, eye_m, direction);
  return {ground_radiance(landscape, glm::dvec2(eye_m + distance_m * direction)), distance_m};
}

/// How far the ground is in each pixel of a canvas; infinite where there is none. Every second
/// pixel of every second row is marched to from the eye; between such that differ little, a march
/// begins shortly before them.
class Distances {
 public:
  Distances(const March& march, const Perspective& perspective, const Image& picture)
      : march_(march),
        perspective_(perspective),
        columns_((picture.width + 1) / 2),
        rows_((picture.height + 1) / 2),
        coarse_m_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    parallel_for(static_cast<std::size_t>(rows_), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < columns_; ++i) coarse_m_[index(i, j)] = marched_m(2 * i, 2 * j, 0.0);
    });
  }

  double at_m(int x, int y) const {
    const int i = x / 2, j = y / 2;
    const int right = std::min(i + x % 2, columns_ - 1), below = std::min(j + y % 2, rows_ - 1);
    if (x % 2 == 0 && y % 2 == 0) return coarse_m_[index(i, j)];
    const auto [near_m, far_m] =
        std::minmax({coarse_m_[index(i, j)], coarse_m_[index(right, j)], coarse_m_[index(i, below)],
                     coarse_m_[index(right, below)]});
    constexpr double most_ratio = 1.1;
    const bool is_even = far_m < most_ratio * near_m;
    return marched_m(x, y, is_even ? near_m / most_ratio : 0.0);
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(i);
  }
  double marched_m(int x, int y, double above_to_m) const {
    return march_.distance_m(perspective_.eye_m(), perspective_.direction({x + 0.5, y + 0.5}),
                             above_to_m);
  }

  const March& march_;
  const Perspective& perspective_;
  int columns_;
  int rows_;
  std::vector<double> coarse_m_;
};

}  // namespace

void paint_ground_and_sky(const Landscape& landscape, const Perspective& perspective,
                          Canvas& canvas) {
  const March march(landscape.terrain);
  const Distances distances(march, perspective, canvas.radiance);
  parallel_for(static_cast<std::size_t>(canvas.radiance.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < canvas.radiance.width; ++x) {
      const glm::dvec3 direction = perspective.direction({x + 0.5, y + 0.5});
      const Hit hit = seen(landscape, perspective.eye_m(), direction, distances.at_m(x, y));
      std::copy_n(&hit.radiance.x, 3, canvas.radiance.pixel(x, y));
      canvas.depth_at(x, y) =
          static_cast<float>(hit.distance_m * perspective.depth_along(direction));
    }
  });
}

}  // namespace wold::preview
