#include "terrain/boulder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// Numbers that the bits of a boulder stand for, each used once.
class Draws {
 public:
  explicit Draws(std::uint64_t bits) : bits_(bits) {}

  double between(double low, double high) {
    return std::lerp(low, high, random_uniform({bits_, key_of("boulder"), next_++, 0}));
  }

 private:
  std::uint64_t bits_, next_ = 0;
};

}  // namespace

Boulder::Boulder(const glm::dvec2& middle_m, double width_m, std::uint64_t bits)
    : middle_m_(middle_m), width_m_(width_m) {
  Draws draws(bits);
  const double turn = std::numbers::pi * draws.between(0.0, 1.0);
  along_ = {math::cos(turn), math::sin(turn)};
  const double half_m = 0.5 * width_m;
  // One draw a statement: compilers differ in which argument of a call they work out first.
  const double height = draws.between(0.5, 0.85);
  const double breadth = draws.between(0.62, 0.95);
  half_m_ = half_m * glm::dvec3(1.0, breadth, height);
  raised_m_ = half_m_.z * draws.between(-0.1, 0.3);
  // A face touches the ellipsoid or cuts a little off. In the space where that is a unit sphere a
  // face with the unit normal m, at a distance d, is z = (d - m.x x - m.y y) / m.z.
  struct Range {
    double low, high;
  };
  const auto face = [&](const Range& tilt_deg, const Range& turns, const Range& distances) {
    const double distance = draws.between(distances.low, distances.high);
    const double heading = 2.0 * std::numbers::pi * draws.between(turns.low, turns.high);
    const double tilt = radians(draws.between(tilt_deg.low, tilt_deg.high));
    const double run = math::tan(tilt);
    return Face{raised_m_ + half_m_.z * distance / math::cos(tilt),
                -half_m_.z * run *
                    glm::dvec2(math::cos(heading) / half_m_.x, math::sin(heading) / half_m_.y)};
  };
  auto next = faces_.begin();
  *next++ = face({0.0, 22.0}, {0.0, 1.0}, {0.8, 0.95});
  for (int i = 0; i < faces_above - 1; ++i)
    *next++ = face({38.0, 60.0}, {i / 4.0, (i + 0.9) / 4.0}, {0.84, 1.0});
  for (int i = 0; i < faces_beside; ++i)
    *next++ = face({68.0, 81.0}, {i / 6.0, (i + 0.35) / 6.0}, {0.86, 1.0});
}

glm::dvec2 Boulder::to_own(const glm::dvec2& way) const {
  return {glm::dot(way, along_), glm::dot(way, glm::dvec2(-along_.y, along_.x))};
}

/// Worn edges are a smooth minimum of the faces: -w ln sum exp(-height / w).
Boulder::Top Boulder::top(const glm::dvec2& at_m) const {
  constexpr double worn = 0.022;  // over the width
  const glm::dvec2 way_m = at_m - middle_m_;
  const double reach = reach_m(width_m_);
  if (glm::dot(way_m, way_m) >= reach * reach) return {};
  const glm::dvec2 own_m = to_own(way_m);
  std::array<double, faces_above + faces_beside> heights_m;
  for (std::size_t i = 0; i < faces_.size(); ++i)
    heights_m[i] = faces_[i].height_m + glm::dot(faces_[i].gradient, own_m);
  const double lowest_m = *std::ranges::min_element(heights_m), edge_m = worn * width_m_;
  double sum = 0.0;
  glm::dvec2 gradient(0.0);
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const double weight = math::exp((lowest_m - heights_m[i]) / edge_m);
    sum += weight;
    gradient += weight * faces_[i].gradient;
  }
  gradient /= sum;
  return {lowest_m - edge_m * math::log(sum),
          gradient.x * along_ + gradient.y * glm::dvec2(-along_.y, along_.x)};
}

/// By halving: a boulder is convex, and its middle stands out of the ground.
double Boulder::rim_m(const glm::dvec2& way) const {
  constexpr int halvings = 14;
  double inside_m = 0.0, outside_m = reach_m(width_m_);
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (inside_m + outside_m);
    (top(middle_m_ + middle * way).height_m > 0.0 ? inside_m : outside_m) = middle;
  }
  return 0.5 * (inside_m + outside_m);
}

/// In the space where the ellipsoid is a unit sphere: how near to its middle a ray to the sun
/// comes, and how near the place is.
Boulder::Light Boulder::light_beside(const glm::dvec2& at_m, const glm::dvec3& to_sun,
                                     const glm::dvec2& ascent, double snow_m) const {
  constexpr double core = 0.82, rim = 1.08;            // of the shadow
  constexpr double most_hidden = 0.45, far_out = 1.7;  // of the sky, beside the boulder
  const double stands_out = (raised_m_ + half_m_.z - snow_m) / (raised_m_ + half_m_.z);
  if (stands_out <= 0.0) return {};
  const glm::dvec3 place = glm::dvec3(to_own(at_m - middle_m_), snow_m - raised_m_) / half_m_;
  const double rise = to_sun.z - glm::dot(ascent, glm::dvec2(to_sun));
  const glm::dvec3 way = glm::dvec3(to_own(glm::dvec2(to_sun)), rise) / half_m_;
  Light light;
  const double along = -glm::dot(place, way) / glm::dot(way, way);
  if (along > 0.0) light.sun = glm::smoothstep(core, rim, glm::length(place + along * way));
  light.sky = 1.0 - most_hidden * stands_out *
                        (1.0 - glm::smoothstep(0.9, far_out, glm::length(glm::dvec2(place))));
  return light;
}

}  // namespace wold::terrain
