#include "grass/mechanics/turning.h"

#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::grass {
namespace {

using Places = VeinPoints::OfPoints<glm::dvec2>;

/// Turned towards the heading, from the upward axis.
glm::dvec2 turned(const glm::dvec2& place, double angle) {
  const double sine = math::sin(angle), cosine = math::cos(angle);
  return {cosine * place.x + sine * place.y, cosine * place.y - sine * place.x};
}

/// Slides points along the line through them to where they have their own distance along it.
Places drawn_together(const Places& stretched, double segment_m) {
  Places drawn = stretched;
  std::size_t piece = 1;
  double begin_m = 0.0;
  double piece_m = glm::distance(stretched[0], stretched[1]);
  for (std::size_t i = 1; i < stretched.size(); ++i) {
    const double wanted_m = static_cast<double>(i) * segment_m;
    while (begin_m + piece_m < wanted_m && piece + 1 < stretched.size()) {
      begin_m += piece_m;
      piece_m = glm::distance(stretched[piece], stretched[piece + 1]);
      ++piece;
    }
    const double fraction = piece_m > 0.0 ? (wanted_m - begin_m) / piece_m : 0.0;
    drawn[i] = glm::mix(stretched[piece - 1], stretched[piece], fraction);
  }
  return drawn;
}

}  // namespace

void turn_vein(VeinPoints& points, double length_m, double droop, double seconds) {
  const double segment_m = length_m / vein_segments;
  Places places_now = points.position_m;
  for (glm::dvec2& place : places_now) {
    place = turned(place, droop * std::sqrt(glm::length(place)));
    if (place.y < 0.0) place = {math::hypot(place.x, place.y), 0.0};
  }
  places_now = drawn_together(places_now, segment_m);
  for (std::size_t k = 0; k < points.angle.size(); ++k) {
    const glm::dvec2 way = places_now[k + 1] - places_now[k];
    points.angle[k] = math::atan2(way.x, way.y);
  }
  const Places moved = places_m(points.angle, length_m);
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const glm::dvec2 velocity_m_s = (moved[i] - points.position_m[i]) / seconds;
    points.force_n[i] = points.mass_kg[i] * (velocity_m_s - points.velocity_m_s[i]) / seconds;
    points.velocity_m_s[i] = velocity_m_s;
  }
  points.position_m = moved;
}

}  // namespace wold::grass
