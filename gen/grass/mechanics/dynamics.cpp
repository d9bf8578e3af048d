#include "grass/mechanics/dynamics.h"

#include <algorithm>
#include <cmath>

#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/ageing/ageing_curves.h"
#include "grass/mechanics/merging.h"

namespace wold::grass {
namespace {

/// Largest shift of a blade's age, so that age stays monotone in weathering: d/dw (w + 4 o w (1-w))
/// >= 1 - 4 |o| > 0.
constexpr double largest_onset = 0.24;
/// How much older the tip is than the middle, half-way through.
constexpr double tip_lead = 0.16;

/// A bump that is 0 at both ends and 1 in the middle.
double midway(double x) { return 4.0 * x * (1.0 - x); }

/// The blade's horizontal heading and its two cross directions at a tangent of its plane.
struct CrossSection {
  CrossSection(const Blade& blade, const glm::vec2& tangent)
      : along(from_plane(blade, tangent)),
        side(from_plane(blade, {tangent.y, -tangent.x})),
        across(-blade.heading.y, blade.heading.x, 0.0F) {}
  glm::vec3 along, side, across;
};

}  // namespace

/// The two samples around a place on a blade (0 root to 1 tip), and how far it is from the lower.
struct PointDynamics::Between {
  explicit Between(float along) {
    const float place = along * WitheredBlade::steps;
    lower = std::min(static_cast<std::size_t>(place), std::size_t{WitheredBlade::steps} - 1);
    above = place - static_cast<float>(lower);
  }
  template <class T>
  T mix(const T& a, const T& b) const {
    return a + (b - a) * above;
  }
  std::size_t lower;
  float above;
};

AgeingModel::AgeingModel(const scene::Physiology& ageing, double fresh_specular,
                         const scene::Flower& flower)
    : ageing_(ageing),
      fresh_specular_(fresh_specular),
      water_(load_curve(CurveKind::water, ageing.water)),
      heaviest_load_(heaviest_load(ageing, water_)),
      colour_(ageing) {
  if (flower.petals > 0) flower_.emplace(flower);
}

double AgeingModel::blade_age(const Blade& blade, double weathering) {
  const double onset = std::clamp(double{blade.onset}, -largest_onset, largest_onset);
  const double own = std::clamp(weathering + onset * midway(weathering), 0.0, 1.0);
  return blade.head_start + (1.0 - blade.head_start) * own;
}

double AgeingModel::local_age(double age, double along) {
  return std::clamp(age + tip_lead * midway(age) * (2.0 * along - 1.0), 0.0, 1.0);
}

WaterLoss AgeingModel::water_loss(double age) const {
  const double now = 1.0 - water_(age);
  double max = now;
  // Between its points the curve is monotone.
  for (const glm::dvec2& point : water_.points())
    if (point.x < age) max = std::max(max, 1.0 - point.y);
  constexpr double rounding = 1e-9;
  return max - now > rounding ? WaterLoss(now, max) : WaterLoss(now);
}

BladePose AgeingModel::pose(const Blade& blade, double age, double snow) const {
  if (moves_points()) return pose(blade, motion(blade).at(age), age, snow);
  BladePose pose = blade_pose(blade, ageing_, water_loss(age), heaviest_load_(age), snow);
  if (blade.organ != Organ::petal) return pose;
  pose.vein_width *= flower_->petal_width(age);
  pose.mesophyll_width *= flower_->petal_width(age);
  return pose;
}

BladePose AgeingModel::pose(const Blade& blade, const VeinState& state, double age,
                            double snow) const {
  const double water_lost = 1.0 - water_(age);
  BladePose pose = blade_pose(blade, ageing_, water_lost, heaviest_load_(age), snow);
  const double length_m = double{blade.length_m} * double{pose.length_scale};
  pose.vein = std::make_shared<const VeinPlaces>(
      vein_places(blade, ageing_, state, water_lost, length_m, snow));
  return pose;
}

LeafShade AgeingModel::usual_shade(const Blade& blade, double age, double along) const {
  return sits_on_stalk(blade) ? flower_->shade(blade.organ, age) : colour_(local_age(age, along));
}

glm::vec3 AgeingModel::albedo(const Blade& blade, double age, double along) const {
  const glm::vec3 albedo =
      glm::min(usual_shade(blade, age, along).albedo * blade.brightness, 0.99F);
  if (!blade.own_albedo) return albedo;
  const double local = local_age(age, along);
  const glm::vec3 own = *blade.own_albedo - glm::min(colour_(0.0).albedo, 0.99F);
  return glm::clamp(albedo + static_cast<float>(1.0 - local) * own, 0.0F, 0.99F);
}

LeafShade AgeingModel::shade(const Blade& blade, double age, double along) const {
  const glm::vec3 all = albedo(blade, age, along);
  const LeafShade leaf = usual_shade(blade, age, along);
  const glm::vec3 sum = glm::max(leaf.reflectance + leaf.transmittance, glm::vec3(1e-6F));
  const glm::vec3 through = all * leaf.transmittance / sum;
  return {all - through, through, all};
}

float AgeingModel::specular(const Blade& blade, double age) const {
  if (sits_on_stalk(blade)) return 0.0F;
  return static_cast<float>(fresh_specular_ * (0.5 + 0.5 * water_(age)));
}

PointDynamics::PointDynamics(const AgeingModel& model, std::vector<Blade> blades, Points points,
                             double merge_distance_m)
    : model_(model),
      blades_(std::move(blades)),
      points_(std::move(points)),
      merge_distance_m_(static_cast<float>(merge_distance_m)),
      poses_(blades_.size()) {
  if (!model_.moves_points()) return;
  motions_.reserve(blades_.size());
  for (const Blade& blade : blades_) motions_.push_back(model_.motion(blade));
  frames_.resize(points_.size());
  frames_before_.resize(points_.size());
  parallel_for(blades_.size(), [&](std::size_t blade) { rest_frames(blade); });
}

void PointDynamics::advance_to(double weathering) {
  weathering_ = weathering;
  frames_before_.swap(frames_);
  parallel_for(blades_.size(), [&](std::size_t blade) {
    stand(blade, weathering, /*snow=*/0.0);
    merge_points(points_, blade, merge_distance_m_);
    if (!motions_.empty()) keep_frames(blade);
  });
}

void PointDynamics::support_load(double snow) {
  parallel_for(blades_.size(), [&](std::size_t blade) { stand(blade, weathering_, snow); });
}

void PointDynamics::stand(std::size_t blade, double weathering, double snow) {
  const WitheredBlade now = apply_forces(blade, weathering, snow);
  move(blade, now);
  update_frames(blade);
  if (!motions_.empty()) follow_frames(blade);
  update_material(blade, now);
}

PointDynamics::WitheredBlade PointDynamics::apply_forces(std::size_t number, double weathering,
                                                         double snow) {
  const Blade& blade = blades_[number];
  const double age = AgeingModel::blade_age(blade, weathering);
  poses_[number] = pose(number, age, snow);
  const float length_m = blade.length_m * poses_[number].length_scale;
  const BladeAxis axis(blade, poses_[number]);
  WitheredBlade now;
  for (int i = 0; i <= WitheredBlade::steps; ++i) {
    const float along = static_cast<float>(i) / WitheredBlade::steps;
    const auto place = static_cast<std::size_t>(i);
    now.axis[place] = axis.at(length_m * along);
    const LeafShade shade = model_.shade(blade, age, double{along});
    now.albedo[place] = shade.albedo;
    now.transmittance[place] = shade.transmittance;
  }
  now.specular = model_.specular(blade, age);
  return now;
}

BladePose PointDynamics::pose(std::size_t number, double age, double snow) {
  const Blade& blade = blades_[number];
  if (motions_.empty()) return model_.pose(blade, age, snow);
  return model_.pose(blade, motions_[number].at(age), age, snow);
}

void PointDynamics::move(std::size_t number, const WitheredBlade& now) {
  const Blade& blade = blades_[number];
  const BladePose& pose = poses_[number];
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const Between between(points_.arc_m[i] / blade.length_m);
    const AxisPoint axis = {
        between.mix(now.axis[between.lower].position_m, now.axis[between.lower + 1].position_m),
        glm::normalize(
            between.mix(now.axis[between.lower].tangent, now.axis[between.lower + 1].tangent))};
    const CrossSection section(blade, axis.tangent);
    const float width = points_.vein[i] != 0 ? pose.vein_width : pose.mesophyll_width;
    points_.position_m[i] =
        on_patch_m(blade, axis) +
        width * (points_.side_m[i] * section.side + points_.across_m[i] * section.across);
    points_.position_m[i].z = std::max(points_.position_m[i].z, 0.0F);
    points_.tangent[i] = section.along;
    points_.area_m2[i] = points_.rest_area_m2[i] * pose.length_scale * width;
  }
}

void PointDynamics::update_frames(std::size_t number) {
  const Blade& blade = blades_[number];
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const float distance = math::hypot(points_.side_m[i], points_.across_m[i]);
    if (points_.vein[i] != 0 || distance == 0.0F) {
      points_.normal[i] = glm::vec3(0.0F);
      continue;
    }
    const glm::vec3& t = points_.tangent[i];
    const CrossSection section(blade, {glm::dot(glm::vec2(t), blade.heading), t.z});
    points_.normal[i] =
        (points_.side_m[i] * section.side + points_.across_m[i] * section.across) / distance;
  }
}

void PointDynamics::rest_frames(std::size_t number) {
  const Blade& blade = blades_[number];
  const CrossSection section(blade, {math::sin(blade.lean), math::cos(blade.lean)});
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const glm::vec3 off_m = points_.side_m[i] * section.side + points_.across_m[i] * section.across;
    const bool on_vein = points_.vein[i] != 0 || off_m == glm::vec3(0.0F);
    frames_[i] = {foot_m(blade) + points_.arc_m[i] * section.along + off_m, section.along,
                  on_vein ? off_m * 0.0F : glm::normalize(off_m)};
  }
}

void PointDynamics::follow_frames(std::size_t number) {
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const PointFrame moved = moved_frame(frames_before_[i], points_.position_m[i]);
    points_.tangent[i] = moved.tangent;
    points_.normal[i] = moved.normal;
  }
}

void PointDynamics::keep_frames(std::size_t number) {
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i)
    frames_[i] = {points_.position_m[i], points_.tangent[i], points_.normal[i]};
}

void PointDynamics::update_material(std::size_t number, const WitheredBlade& now) {
  const float length_m = blades_[number].length_m;
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const Between between(points_.arc_m[i] / length_m);
    points_.albedo[i] = between.mix(now.albedo[between.lower], now.albedo[between.lower + 1]);
    points_.transmittance[i] =
        between.mix(now.transmittance[between.lower], now.transmittance[between.lower + 1]);
    points_.specular[i] = now.specular;
  }
}

}  // namespace wold::grass
