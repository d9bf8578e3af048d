#include "grass/dynamics.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "grass/ageing_curves.h"

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
      : along(blade.heading * tangent.x, tangent.y),
        side(blade.heading * tangent.y, -tangent.x),
        across(-blade.heading.y, blade.heading.x, 0.0F) {}
  glm::vec3 along, side, across;
};

/// Which points of one blade go into which: kept[i] for every point, merged into the last kept.
void merge_blade(Points& points, std::uint32_t begin, std::uint32_t end, float distance_m,
                 std::vector<std::uint8_t>& kept) {
  for (std::uint32_t i = begin; i < end; ++i) {
    if (kept[i] == 0) continue;
    for (std::uint32_t j = i + 1; j < end && points.arc_m[j] - points.arc_m[i] < distance_m; ++j) {
      if (kept[j] == 0 || points.vein[i] != points.vein[j]) continue;
      const glm::vec3 apart = points.position_m[i] - points.position_m[j];
      if (glm::dot(apart, apart) >= distance_m * distance_m) continue;
      const float total = points.area_m2[i] + points.area_m2[j];
      const float share = total > 0.0F ? points.area_m2[j] / total : 0.0F;
      const auto mean = [&](auto& values) { values[i] += (values[j] - values[i]) * share; };
      mean(points.side_m);
      mean(points.across_m);
      mean(points.position_m);
      mean(points.albedo);
      mean(points.specular);
      points.rest_area_m2[i] += points.rest_area_m2[j];
      points.area_m2[i] = total;
      kept[j] = 0;
    }
  }
}

template <class T>
void keep(std::vector<T>& values, const std::vector<std::uint8_t>& kept) {
  std::size_t to = 0;
  for (std::size_t from = 0; from < values.size(); ++from)
    if (kept[from] != 0) values[to++] = values[from];
  values.resize(to);
}

void keep_points(Points& points, const std::vector<std::uint8_t>& kept) {
  std::uint32_t count = 0;
  std::size_t blade = 0;
  for (std::uint32_t i = 0; i <= kept.size(); ++i) {
    while (blade < points.blade_begin.size() && points.blade_begin[blade] == i)
      points.blade_begin[blade++] = count;
    if (i < kept.size()) count += kept[i];
  }
  keep(points.arc_m, kept);
  keep(points.side_m, kept);
  keep(points.across_m, kept);
  keep(points.rest_area_m2, kept);
  keep(points.vein, kept);
  keep(points.position_m, kept);
  keep(points.tangent, kept);
  keep(points.normal, kept);
  keep(points.albedo, kept);
  keep(points.specular, kept);
  keep(points.area_m2, kept);
}

}  // namespace

AgeingModel::AgeingModel(const scene::Ageing& ageing, double fresh_specular)
    : ageing_(ageing),
      fresh_specular_(fresh_specular),
      water_(load_curve(CurveKind::water, ageing.water)),
      colour_(ageing) {}

double AgeingModel::blade_age(const Blade& blade, double weathering) {
  const double onset = std::clamp(double{blade.onset}, -largest_onset, largest_onset);
  const double own = std::clamp(weathering + onset * midway(weathering), 0.0, 1.0);
  return blade.head_start + (1.0 - blade.head_start) * own;
}

double AgeingModel::local_age(double age, double along) {
  return std::clamp(age + tip_lead * midway(age) * (2.0 * along - 1.0), 0.0, 1.0);
}

BladePose AgeingModel::pose(const Blade& blade, double age) const {
  return blade_pose(blade, ageing_, 1.0 - water_(age));
}

float AgeingModel::specular(double age) const {
  return static_cast<float>(fresh_specular_ * (0.5 + 0.5 * water_(age)));
}

PointDynamics::PointDynamics(const AgeingModel& model, std::vector<Blade> blades, Points points,
                             double merge_distance_m)
    : model_(model),
      blades_(std::move(blades)),
      points_(std::move(points)),
      merge_distance_m_(static_cast<float>(merge_distance_m)),
      ages_(blades_.size()),
      poses_(blades_.size()) {}

void PointDynamics::advance_to(double weathering) {
  parallel_for(blades_.size(), [&](std::size_t blade) {
    apply_forces(blade, weathering);
    move(blade);
    update_frames(blade);
    update_material(blade);
  });
  merge();
}

void PointDynamics::apply_forces(std::size_t blade, double weathering) {
  ages_[blade] = AgeingModel::blade_age(blades_[blade], weathering);
  poses_[blade] = model_.pose(blades_[blade], ages_[blade]);
}

void PointDynamics::move(std::size_t number) {
  const Blade& blade = blades_[number];
  const BladePose& pose = poses_[number];
  const glm::vec3 root(blade.root_m, 0.0F);
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const AxisPoint axis = axis_point(blade, pose, points_.arc_m[i] * pose.length_scale);
    const CrossSection section(blade, axis.tangent);
    const float width = points_.vein[i] != 0 ? pose.vein_width : pose.mesophyll_width;
    const glm::vec3 on_axis(blade.heading * axis.position_m.x, axis.position_m.y);
    points_.position_m[i] =
        root + on_axis +
        width * (points_.side_m[i] * section.side + points_.across_m[i] * section.across);
    points_.position_m[i].z = std::max(points_.position_m[i].z, 0.0F);
    points_.tangent[i] = section.along;
    points_.area_m2[i] = points_.rest_area_m2[i] * pose.length_scale * width;
  }
}

void PointDynamics::update_frames(std::size_t number) {
  const Blade& blade = blades_[number];
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const float distance = std::hypot(points_.side_m[i], points_.across_m[i]);
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

void PointDynamics::update_material(std::size_t number) {
  const Blade& blade = blades_[number];
  const double age = ages_[number];
  const float specular = model_.specular(age);
  for (std::uint32_t i = points_.blade_begin[number]; i < points_.blade_begin[number + 1]; ++i) {
    const double along = double{points_.arc_m[i]} / double{blade.length_m};
    points_.albedo[i] =
        glm::min(model_.albedo(AgeingModel::local_age(age, along)) * blade.brightness, 0.99F);
    points_.specular[i] = specular;
  }
}

void PointDynamics::merge() {
  std::vector<std::uint8_t> kept(points_.size(), 1);
  parallel_for(blades_.size(), [&](std::size_t blade) {
    merge_blade(points_, points_.blade_begin[blade], points_.blade_begin[blade + 1],
                merge_distance_m_, kept);
  });
  if (std::find(kept.begin(), kept.end(), 0) != kept.end()) keep_points(points_, kept);
}

}  // namespace wold::grass
