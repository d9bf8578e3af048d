#include "ground/land_appearance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/between.h"
#include "core/elementary.h"
#include "core/parallel.h"

namespace wold::ground {
namespace {

using std::numbers::pi;

constexpr double steepest_deg = 60.0;

/// Of heights that may look otherwise. What differs within some metres of a small square differs by
/// chance, and would be seen as a line along a contour of all the land around.
constexpr double least_step_m = 50.0;

double slope_deg(const glm::dvec3& up) {
  return math::acos(std::clamp(up.z, -1.0, 1.0)) / radians_per_degree;
}

/// A normal of that slope and aspect.
glm::dvec3 up_of(double slope, double aspect_rad) {
  const double sine = math::sin(radians(slope));
  return {sine * math::sin(aspect_rad), sine * math::cos(aspect_rad), math::cos(radians(slope))};
}

}  // namespace

LandAppearance::LandAppearance(std::span<const LandSample> samples)
    : table_(std::size_t{slopes} * heights * aspects) {
  const auto [lowest, highest] =
      std::ranges::minmax(samples, {}, [](const LandSample& sample) { return sample.height_m; });
  lowest_m_ = lowest.height_m;
  highest_m_ = std::max(highest.height_m, lowest_m_ + 1.0);
  parallel_for(table_.size(), [&](std::size_t i) {
    const int rest = static_cast<int>(i) / aspects;
    table_[i] = regression(samples, rest / heights, rest % heights, static_cast<int>(i) % aspects);
  });
  std::vector<glm::vec3> deviations;
  for (const LandSample& sample : samples) {
    const glm::vec3 mean = glm::max(at(sample.up, sample.height_m), glm::vec3(1e-6F));
    deviations.push_back(glm::min(sample.radiance / mean - 1.0F, glm::vec3(1.0F)));
  }
  variety_ = LandVariety(deviations);
}

/// Nadaraya and Watson 1964, with the widths of one step of the table, and least_step_m at least.
/// What lies nowhere alike has the look of what lies least differently.
glm::vec3 LandAppearance::regression(std::span<const LandSample> samples, int slope, int height,
                                     int aspect) const {
  const double slope_step = steepest_deg / (slopes - 1);
  const glm::dvec3 up = up_of(slope * slope_step, 2.0 * pi * aspect / aspects);
  const double height_step_m = (highest_m_ - lowest_m_) / (heights - 1);
  const double height_m = lowest_m_ + height * height_step_m;
  const double normal_step = radians(slope_step);
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (const LandSample& sample : samples) {
    const double away = glm::length(sample.up - up) / normal_step;
    const double higher = (sample.height_m - height_m) / std::max(height_step_m, least_step_m);
    const double square = away * away + higher * higher;
    const double weight = math::exp(-0.5 * std::min(square, 60.0)) + 1e-9 / (1.0 + square * square);
    sum += weight * glm::dvec3(sample.radiance);
    weights += weight;
  }
  return glm::vec3(sum / weights);
}

glm::vec3 LandAppearance::at(const glm::dvec3& up, double height_m) const {
  const Between slope(slope_deg(up) / steepest_deg, slopes);
  const Between height((height_m - lowest_m_) / (highest_m_ - lowest_m_), heights);
  const double turn = math::atan2(up.x, up.y) / (2.0 * pi);
  const double place = (turn - std::floor(turn)) * aspects;
  const int first = std::min(static_cast<int>(place), aspects - 1);
  const auto part = static_cast<float>(place - first);
  const auto value = [&](std::size_t s, std::size_t h) {
    const std::size_t row = ((slope.first + s) * heights + height.first + h) * aspects;
    return glm::mix(table_[row + static_cast<std::size_t>(first)],
                    table_[row + static_cast<std::size_t>((first + 1) % aspects)], part);
  };
  return glm::mix(glm::mix(value(0, 0), value(0, 1), height.part),
                  glm::mix(value(1, 0), value(1, 1), height.part), slope.part);
}

}  // namespace wold::ground
