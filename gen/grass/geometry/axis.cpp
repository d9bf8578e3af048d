#include "grass/geometry/axis.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::grass {
namespace {

constexpr float half_pi = std::numbers::pi_v<float> / 2.0F;
/// Below this droop a blade is straight to float precision.
constexpr float straight = 1e-3F;

AxisPoint straight_axis(float lean, float arc_m) {
  const glm::vec2 direction(math::sin(lean), math::cos(lean));
  return {direction * arc_m, direction};
}

/// Radius of the polar curve at an arc length, and the reverse (axis.h).
float radius_at_arc(float droop, float arc_m) {
  const float cc = droop * droop;
  return 4.0F / cc * math::expm1(2.0F / 3.0F * math::log1p(0.375F * cc * arc_m));
}
float arc_at_radius(float droop, float radius_m) {
  const float cc = droop * droop;
  return 8.0F / (3.0F * cc) * math::expm1(1.5F * math::log1p(0.25F * cc * radius_m));
}

std::variant<PaperAxis, ElasticaAxis, VeinAxis> axis_of(const Blade& blade, const BladePose& pose) {
  if (pose.vein) return VeinAxis(*pose.vein, blade.length_m * pose.length_scale);
  if (pose.rule == DroopRule::elastica)
    return ElasticaAxis(std::max(blade.lean, min_lean), pose.load,
                        blade.length_m * pose.length_scale);
  return PaperAxis(blade.lean, pose.droop);
}

}  // namespace

AxisPoint PaperAxis::at(float arc_m) const {
  if (droop_ < straight) return straight_axis(lean_, arc_m);
  const float radius = radius_at_arc(droop_, arc_m);
  const float angle = lean_ + droop_ * std::sqrt(radius);
  if (angle < half_pi) {
    const float tangent = angle + math::atan(0.5F * droop_ * std::sqrt(radius));
    return {radius * glm::vec2(math::sin(angle), math::cos(angle)),
            {math::sin(tangent), math::cos(tangent)}};
  }
  const float touch = (half_pi - lean_) / droop_;
  const float touch_radius = touch * touch;
  return {{touch_radius + arc_m - arc_at_radius(droop_, touch_radius), 0.0F}, {1.0F, 0.0F}};
}

ElasticaAxis::ElasticaAxis(float lean, float load, float length_m)
    : nodes_(heavy_elastica(double{lean}, double{load})), length_m_(length_m) {
  const auto below = std::find_if(nodes_.begin() + 1, nodes_.end(),
                                  [](const ElasticaNode& node) { return node.place.y < 0.0; });
  if (below == nodes_.end()) return;
  const glm::dvec2 above = (below - 1)->place;
  const double fraction = above.y / (above.y - below->place.y);
  touch_ = (static_cast<double>(below - 1 - nodes_.begin()) + fraction) / elastica_segments;
  touch_place_ = above.x + fraction * (below->place.x - above.x);
}

AxisPoint ElasticaAxis::at(float arc_m) const {
  const double along = double{arc_m / length_m_};
  if (along >= touch_)
    return {{static_cast<float>(touch_place_ + along - touch_) * length_m_, 0.0F}, {1.0F, 0.0F}};
  const auto lower = std::min(static_cast<std::size_t>(along * elastica_segments),
                              std::size_t{elastica_segments} - 1);
  const double fraction = along * elastica_segments - static_cast<double>(lower);
  const ElasticaNode& from = nodes_[lower];
  const ElasticaNode& to = nodes_[lower + 1];
  const double angle = from.angle + (to.angle - from.angle) * fraction;
  return {glm::vec2(glm::mix(from.place, to.place, fraction)) * length_m_,
          {math::sin(angle), math::cos(angle)}};
}

VeinAxis::VeinAxis(const VeinPlaces& places, float length_m)
    : places_m_(places), length_m_(length_m) {
  const auto below = std::find_if(places_m_.begin() + 1, places_m_.end(),
                                  [](const glm::vec2& place) { return place.y < 0.0F; });
  if (below == places_m_.end()) return;
  // The segment that meets the ground stays as long as it is.
  const float segment_m = length_m / vein_segments;
  for (auto place = below; place != places_m_.end(); ++place) {
    const glm::vec2& from = *(place - 1);
    const float drop_m = std::min(from.y, segment_m);
    *place = from + glm::vec2(std::sqrt(segment_m * segment_m - drop_m * drop_m), -drop_m);
  }
}

AxisPoint VeinAxis::at(float arc_m) const {
  const float place = std::clamp(arc_m / length_m_, 0.0F, 1.0F) * vein_segments;
  const auto lower = std::min(static_cast<std::size_t>(place), std::size_t{vein_segments} - 1);
  const float fraction = place - static_cast<float>(lower);
  const auto segment = [&](std::size_t k) { return places_m_[k + 1] - places_m_[k]; };
  const auto at_joint = [&](std::size_t k) {
    if (k == 0) return segment(0);
    if (k == vein_segments) return segment(vein_segments - 1);
    return segment(k - 1) + segment(k);
  };
  const glm::vec2 from = glm::normalize(at_joint(lower)), to = glm::normalize(at_joint(lower + 1));
  return {glm::mix(places_m_[lower], places_m_[lower + 1], fraction),
          glm::normalize(glm::mix(from, to, fraction))};
}

BladeAxis::BladeAxis(const Blade& blade, const BladePose& pose) : axis_(axis_of(blade, pose)) {}

AxisPoint BladeAxis::at(float arc_m) const {
  return std::visit([&](const auto& axis) { return axis.at(arc_m); }, axis_);
}

}  // namespace wold::grass
