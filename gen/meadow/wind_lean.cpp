#include "meadow/wind_lean.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/random.h"
#include "wind/streamlining.h"

namespace wold::meadow {
namespace {

/// Crests are longer than the way from one to the next.
constexpr double crest_length = 2.2;

/// Deviation of the direction from the wind's, degrees: gusts do not all come the same way.
constexpr double turning_deg = 18.0;

/// Unit, where the wind blows to; x is east.
glm::dvec2 direction(double heading_deg) {
  const double heading = heading_deg * radians_per_degree;
  return {math::sin(heading), math::cos(heading)};
}

Fbm field(std::uint64_t seed, const char* purpose, int octaves) {
  return Fbm(random_bits({seed, key_of("combing"), 0, key_of(purpose)}), octaves, 0.9);
}

/// A field's value with the tails cut, so that no blade is pressed flat.
double tame(double value) { return std::clamp(value, -2.0, 2.0); }

/// No wind of a season presses grass down farther.
constexpr double max_deg = 40.0;

}  // namespace

WindLean::WindLean(const scene::Wind& wind, const phenology::WindChange& change, std::uint64_t seed,
                   std::shared_ptr<const wind::CanopyMotion> motion)
    : wind_(wind),
      change_(change),
      waves_(field(seed, "waves", 2)),
      turns_(field(seed, "turns", 2)),
      motion_(std::move(motion)) {}

glm::dvec2 WindLean::lean(const glm::dvec2& at_m) const {
  return motion_ ? wind::leaning_under(combed(at_m), motion_->load(at_m)) : combed(at_m);
}

glm::dvec2 WindLean::combed(const glm::dvec2& at_m) const {
  const glm::dvec2 along = direction(wind_.heading_deg);
  const glm::dvec2 across(along.y, -along.x);
  const glm::dvec2 place =
      glm::dvec2(glm::dot(at_m, along), glm::dot(at_m, across) / crest_length) /
      wind_.wave_length_m;
  const double usual_deg = wind_.lean_deg + wind_.waves_deg * tame(waves_.at(place));
  const double lean_deg = std::min(usual_deg * change_.speed_factor, std::max(usual_deg, max_deg));
  const double turned_deg = turning_deg * tame(turns_.at(place / 2.0));
  return math::tan(lean_deg * radians_per_degree) *
         direction(wind_.heading_deg + turned_deg + change_.turned_rad / radians_per_degree);
}

}  // namespace wold::meadow
