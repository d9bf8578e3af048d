#include "grass/mechanics/blade_motion.h"

#include <algorithm>
#include <cmath>

#include "grass/geometry/axis.h"
#include "grass/mechanics/mechanics.h"
#include "grass/mechanics/turning.h"
#include "grass/mechanics/vein_step.h"

namespace wold::grass {
namespace {

/// A step of the weathering degree is hours: long beside a blade's swing.
constexpr double step_s = 10.0;
/// Steps in which [TVT]'s law lets a straight blade droop at once.
constexpr int turning_steps = 32;

bool by_forces(const scene::Physiology& ageing) {
  return ageing.droop_rule == scene::DroopRule::elastica;
}

double clamp_angle(const Blade& blade, const scene::Physiology& ageing) {
  return double{by_forces(ageing) ? std::max(blade.lean, min_lean) : blade.lean};
}

double length_m(const Blade& blade, const scene::Physiology& ageing, double water_lost) {
  return double{blade.length_m} * double{blade_pose(blade, ageing, water_lost, 1.0).length_scale};
}

/// Droop by [TVT]'s rule of a blade that lacks `water_lost` and has lacked `max_lost`.
double paper_droop(const Blade& blade, const scene::Physiology& ageing, double water_lost,
                   double max_lost) {
  return double{blade.fresh_droop} +
         double{blade.droop_rate} * (relieved_loss(max_lost, ageing.stiffening) -
                                     recovered_loss(ageing, water_lost, max_lost));
}

VeinLoad load_of(const Blade& blade, const scene::Physiology& ageing, const Wall& wall,
                 double water_lost, double length_now_m) {
  const double fresh = fresh_stiffness_n_m2(blade);
  VeinLoad load;
  load.length_m = length_now_m;
  load.clamp = clamp_angle(blade, ageing);
  load.wall_n_m2 = fresh * wall_stiffness(ageing, wall.max_lost);
  load.turgor_n_m2 = fresh * turgor_stiffness(ageing, water_lost);
  load.set = wall.set;
  return load;
}

void weigh(VeinPoints& points, const Blade& blade, double relative) {
  set_mass(points, relative * fresh_mass_kg_m(blade) * double{blade.length_m});
}

void droop_at_once(VeinPoints& points, double length, double droop) {
  for (int i = 0; i < turning_steps; ++i) turn_vein(points, length, droop / turning_steps, step_s);
}

VeinState mixed(const VeinState& a, const VeinState& b, double fraction) {
  VeinState state;
  const auto mix = [&](double from, double to) { return from + (to - from) * fraction; };
  for (std::size_t k = 0; k < state.angle.size(); ++k) {
    state.angle[k] = mix(a.angle[k], b.angle[k]);
    state.wall.set[k] = mix(a.wall.set[k], b.wall.set[k]);
  }
  state.wall.max_lost = mix(a.wall.max_lost, b.wall.max_lost);
  state.droop = mix(a.droop, b.droop);
  return state;
}

}  // namespace

BladeMotion::BladeMotion(const Blade& blade, const scene::Physiology& ageing, const Curve& water,
                         int steps)
    : blade_(blade), ageing_(&ageing), water_(&water), steps_(steps) {
  const double lost = 1.0 - water(0.0);
  const double length = length_m(blade, ageing, lost);
  points_ = straight_vein(clamp_angle(blade, ageing), length);
  weigh(points_, blade, relative_weight(lost));
  last_.wall.max_lost = lost;
  last_.droop = paper_droop(blade, ageing, lost, lost);
  if (by_forces(ageing))
    settle_vein(points_, load_of(blade, ageing, last_.wall, lost, length));
  else
    droop_at_once(points_, length, last_.droop);
  last_.angle = points_.angle;
  before_ = last_;
}

void BladeMotion::step() {
  before_ = last_;
  ++done_;
  const double lost = 1.0 - (*water_)(static_cast<double>(done_) / steps_);
  const double length = length_m(blade_, *ageing_, lost);
  weigh(points_, blade_, relative_weight(lost));
  if (by_forces(*ageing_)) {
    dry(last_.wall, turns(points_, clamp_angle(blade_, *ageing_)), lost, ageing_->stiffening);
    step_vein(points_, load_of(blade_, *ageing_, last_.wall, lost, length), step_s);
  } else {
    last_.wall.max_lost = std::max(last_.wall.max_lost, lost);
    last_.droop = paper_droop(blade_, *ageing_, lost, last_.wall.max_lost);
    turn_vein(points_, length, last_.droop - before_.droop, step_s);
  }
  last_.angle = points_.angle;
}

const VeinState& BladeMotion::at(double age) {
  const double place = std::clamp(age, 0.0, 1.0) * steps_;
  while (done_ < place) step();
  now_ = done_ == 0 ? last_ : mixed(before_, last_, place - (done_ - 1));
  return now_;
}

BladeHistory::BladeHistory(const Blade& blade, const scene::Physiology& ageing,
                           const Curve& water) {
  BladeMotion motion(blade, ageing, water);
  for (int i = 0; i <= BladeMotion::usual_steps; ++i)
    states_.push_back(motion.at(static_cast<double>(i) / BladeMotion::usual_steps));
}

VeinState BladeHistory::at(double age) const {
  const double place = std::clamp(age, 0.0, 1.0) * BladeMotion::usual_steps;
  const auto upper = static_cast<std::size_t>(std::ceil(place));
  if (upper == 0) return states_.front();
  return mixed(states_[upper - 1], states_[upper], place - static_cast<double>(upper - 1));
}

VeinPlaces vein_places(const Blade& blade, const scene::Physiology& ageing, const VeinState& state,
                       double water_lost, double length, double snow) {
  VeinPoints points;
  points.angle = state.angle;
  points.position_m = places_m(points.angle, length);
  if (snow > 0.0 && by_forces(ageing)) {
    weigh(points, blade, relative_weight(water_lost) + snow * relative_snow_weight());
    settle_vein(points, load_of(blade, ageing, state.wall, water_lost, length));
  } else if (snow > 0.0) {
    const auto droop = static_cast<float>(state.droop);
    droop_at_once(points, length, double{snowed_droop(blade, droop, snow) - droop});
  }
  VeinPlaces places;
  std::copy(points.position_m.begin(), points.position_m.end(), places.begin());
  return places;
}

}  // namespace wold::grass
