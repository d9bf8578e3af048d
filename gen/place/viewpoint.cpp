#include "place/viewpoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/elementary.h"
#include "core/mesh_height.h"
#include "core/parallel.h"
#include "core/pinhole.h"
#include "light/daylight.h"
#include "terrain/relief.h"

namespace wold::place {
namespace {

using std::numbers::pi;

constexpr int eyes_per_side = 24, azimuths = 72;
/// Ground at the feet, near, middle and far land, by fractions of the terrain's side.
constexpr std::array<double, 3> far_beyond = {0.012, 0.05, 0.2};
constexpr std::size_t bands = far_beyond.size() + 1;

/// Rise over distance of what is seen: from the first to the second, of one band.
struct Span {
  double low, high;
  std::size_t band;
};

/// What is seen along one azimuth, upwards.
struct Profile {
  std::vector<Span> spans;
  double skyline = 0.0;
  double reach_m = 0.0;  ///< to the terrain's border
};

double azimuth_of(int azimuth) { return 2.0 * pi * azimuth / azimuths; }

std::size_t band_of(double distance_m, double size_m) {
  return static_cast<std::size_t>(std::ranges::upper_bound(far_beyond, distance_m / size_m) -
                                  far_beyond.begin());
}

/// Adds a span, or makes the last one of the same band taller.
void add_span(std::vector<Span>& spans, const Span& span) {
  if (!spans.empty() && spans.back().band == span.band && spans.back().high == span.low)
    spans.back().high = span.high;
  else
    spans.push_back(span);
}

Profile profile(const Heightfield& terrain, const glm::dvec3& eye_m, double azimuth_rad) {
  constexpr double nearest = 0.002, nearest_m = 1.0, growth = 0.04;
  const glm::dvec2 towards(light::direction_of(azimuth_rad, 0.0));
  Profile seen;
  seen.skyline = -std::numeric_limits<double>::infinity();
  for (double distance_m = std::min(nearest_m, nearest * terrain.size_m());;
       distance_m *= 1.0 + growth) {
    const glm::dvec2 at_m = glm::dvec2(eye_m) + distance_m * towards;
    if (!terrain.square().contains(at_m)) return seen;
    seen.reach_m = distance_m;
    const double rise = (double{mesh_height_m(terrain, at_m)} - eye_m.z) / distance_m;
    if (rise <= seen.skyline) continue;
    if (std::isfinite(seen.skyline))
      add_span(seen.spans, {seen.skyline, rise, band_of(distance_m, terrain.size_m())});
    seen.skyline = rise;
  }
}

/// What a picture from a place in one direction shows.
struct Composition {
  std::array<double, bands + 1> parts{};  ///< of its height: the bands, and the sky
  double aim = 0.0;                       ///< rise over distance of its middle
  double skyline_deviation = 0.0;         ///< of the skyline's rise
};

double overlap(const Span& span, double low, double high) {
  return std::max(0.0, std::min(span.high, high) - std::max(span.low, low));
}

/// `half`: of the picture's height at a distance of 1.
Composition composed(const std::vector<const Profile*>& profiles, double half) {
  constexpr double skyline_over_middle = 0.3;  // of half the height
  const double count = static_cast<double>(profiles.size());
  double sum = 0.0, squares = 0.0;
  for (const Profile* seen : profiles) {
    sum += seen->skyline;
    squares += seen->skyline * seen->skyline;
  }
  Composition picture;
  picture.aim = sum / count - skyline_over_middle * half;
  picture.skyline_deviation = std::sqrt(std::max(0.0, squares / count - sum * sum / count / count));
  const double low = picture.aim - half, high = picture.aim + half;
  const double part = 1.0 / (count * 2.0 * half);
  for (const Profile* seen : profiles) {
    for (const Span& span : seen->spans)
      picture.parts[span.band] += part * overlap(span, low, high);
    picture.parts.back() += part * std::max(0.0, high - std::max(seen->skyline, low));
  }
  return picture;
}

/// Of parts that are 1 together, over the largest there can be.
double evenness(const std::array<double, bands + 1>& parts) {
  double entropy = 0.0;
  for (const double part : parts)
    if (part > 0.0) entropy -= part * math::log(part);
  return entropy / math::log(static_cast<double>(parts.size()));
}

/// From 0 to 1: whether no part is missing.
double completeness(const std::array<double, bands + 1>& parts) {
  constexpr double enough = 0.08;
  double sum = 0.0;
  for (const double part : parts) sum += std::min(1.0, part / enough);
  return sum / static_cast<double>(parts.size());
}

/// `merit`, or less where a quality from 0 to 1 is missing.
double weighed(double merit, double quality, double weight) {
  return merit * std::lerp(1.0, quality, weight);
}

/// From 0 to 1: how well it serves as a picture. `depth`: how far the terrain goes on in that
/// direction, over its side; the land beyond is smoother.
double merit(const Composition& picture, double half, double sun_aside, double depth) {
  constexpr double lively = 0.25, deep = 0.7;
  double merit = evenness(picture.parts) * completeness(picture.parts) *
                 (1.0 - glm::smoothstep(0.5, 1.5, std::abs(picture.aim) / half));
  merit = weighed(merit, std::min(1.0, picture.skyline_deviation / (lively * half)), 0.3);
  merit = weighed(merit, sun_aside, 0.15);
  return weighed(merit, std::min(1.0, depth / deep), 0.3);
}

struct Candidate {
  double merit = -1.0;
  glm::dvec3 eye_m{0.0};
  double azimuth_rad = 0.0, aim = 0.0;
};

/// The best direction from a place.
Candidate best_from(const Heightfield& terrain, const glm::dvec3& eye_m, const ViewSearch& search) {
  std::array<Profile, azimuths> all;
  for (int i = 0; i < azimuths; ++i)
    all[static_cast<std::size_t>(i)] = profile(terrain, eye_m, azimuth_of(i));
  const double half = half_width(search.field_of_view_deg) * search.height_over_width;
  const int aside =
      std::max(1, static_cast<int>(0.5 * search.field_of_view_deg / 360.0 * azimuths));
  Candidate best;
  for (int middle = 0; middle < azimuths; ++middle) {
    std::vector<const Profile*> profiles;
    for (int i = middle - aside; i <= middle + aside; ++i)
      profiles.push_back(&all[static_cast<std::size_t>((i + azimuths) % azimuths)]);
    const Composition picture = composed(profiles, half);
    const glm::dvec2 towards(light::direction_of(azimuth_of(middle), 0.0));
    const double to_sun = glm::dot(towards, glm::dvec2(search.to_sun));
    const double depth = all[static_cast<std::size_t>(middle)].reach_m / terrain.size_m();
    const double merit_here = merit(picture, half, 1.0 - to_sun * to_sun, depth);
    if (merit_here > best.merit) best = {merit_here, eye_m, azimuth_of(middle), picture.aim};
  }
  return best;
}

/// How well one stands there: 1 on gentle ground, little on steep ground.
double footing(const Heightfield& terrain, const glm::dvec2& at_m) {
  constexpr double gentle_deg = 12.0, steep_deg = 28.0, least = 0.05;
  const double slope_deg = terrain::slope_deg(terrain, at_m.x, at_m.y);
  return std::max(least, 1.0 - glm::smoothstep(gentle_deg, steep_deg, slope_deg));
}

/// A point on the line of sight through the picture's middle, on the ground or over it.
Viewpoint looking(const Heightfield& terrain, const Candidate& from) {
  constexpr double near = 0.02, ahead = 0.08, growth = 0.02;
  const glm::dvec2 towards(light::direction_of(from.azimuth_rad, 0.0));
  const glm::dvec2 eye_m(from.eye_m);
  const double size_m = terrain.size_m();
  double distance_m = near * size_m;
  for (double next_m = distance_m; next_m < ahead * size_m; next_m *= 1.0 + growth) {
    const glm::dvec2 at_m = eye_m + next_m * towards;
    distance_m = next_m;
    if (double{mesh_height_m(terrain, at_m)} >= from.eye_m.z + from.aim * next_m) break;
  }
  const glm::dvec2 target_m = eye_m + distance_m * towards;
  const double over_m =
      from.eye_m.z + from.aim * distance_m - double{mesh_height_m(terrain, target_m)};
  return {eye_m, target_m, std::max(0.0, over_m)};
}

}  // namespace

Viewpoint find_viewpoint(const Heightfield& terrain, const ViewSearch& search) {
  constexpr double margin = 0.12;  // of the side, from the border
  std::array<Candidate, static_cast<std::size_t>(eyes_per_side * eyes_per_side)> candidates;
  parallel_for(candidates.size(), [&](std::size_t k) {
    const glm::dvec2 place(static_cast<double>(k % eyes_per_side) + 0.5,
                           static_cast<double>(k / eyes_per_side) + 0.5);
    const glm::dvec2 at_m =
        terrain.square().corner_m +
        terrain.size_m() * (margin + (1.0 - 2.0 * margin) / eyes_per_side * place);
    Candidate best = best_from(
        terrain, glm::dvec3(at_m, mesh_height_m(terrain, at_m) + search.eye_height_m), search);
    best.merit *= footing(terrain, at_m);
    candidates[k] = best;
  });
  return looking(terrain, *std::ranges::max_element(candidates, {}, &Candidate::merit));
}

}  // namespace wold::place
