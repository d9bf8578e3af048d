#include "ground/land_variety.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/between.h"
#include "core/interpolation.h"
#include "core/normal_distribution.h"

namespace wold::ground {
namespace {

/// Of equally many places.
constexpr int ranks = 64;
/// Of the table: deviations known, from -most_known to most_known, and variances shown.
constexpr int known_values = 49, shown_values = 9;
constexpr double most_known = 3.0;

/// The eigenvector of the greatest variance, of length 1: by power iteration. Of the two that fit,
/// the one that brightens. 0 where nothing differs.
glm::dvec3 main_axis(std::span<const glm::vec3> deviations) {
  glm::dmat3 covariance(0.0);
  for (const glm::dvec3 deviation : deviations)
    covariance += glm::outerProduct(deviation, deviation) / static_cast<double>(deviations.size());
  glm::length_t most = 0;
  for (const glm::length_t c : {1, 2})
    if (covariance[c][c] > covariance[most][most]) most = c;
  if (covariance[most][most] < 1e-12) return glm::dvec3(0.0);
  glm::dvec3 axis = covariance[most];
  for (int i = 0; i < 32; ++i) axis = glm::normalize(covariance * axis);
  return axis.r + axis.g + axis.b < 0.0 ? -axis : axis;
}

/// All less their mean.
std::vector<glm::vec3> about_their_mean(std::span<const glm::vec3> deviations) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& each : deviations) sum += glm::dvec3(each);
  const glm::vec3 mean(sum / static_cast<double>(deviations.size()));
  std::vector<glm::vec3> centred;
  for (const glm::vec3& each : deviations) centred.push_back(each - mean);
  return centred;
}

/// Means of equally many places each, in order along their main axis.
std::vector<glm::dvec3> means_of_ranks(std::span<const glm::vec3> deviations) {
  std::vector<glm::vec3> ordered(deviations.begin(), deviations.end());
  const glm::dvec3 axis = main_axis(deviations);
  std::ranges::stable_sort(ordered, {},
                           [&](const glm::vec3& each) { return glm::dot(axis, glm::dvec3(each)); });
  std::vector<glm::dvec3> means(ranks, glm::dvec3(0.0));
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    const std::size_t first = rank * ordered.size() / ranks;
    const std::size_t end = std::max((rank + 1) * ordered.size() / ranks, first + 1);
    for (std::size_t i = first; i < end; ++i)
      means[rank] += glm::dvec3(ordered[i]) / static_cast<double>(end - first);
  }
  return means;
}

/// Probability that a normal variable is of lower rank, where `known` of it is known and the rest
/// has that deviation.
double probability_below(int rank, double known, double unknown_deviation) {
  if (rank == 0) return 0.0;
  if (rank == ranks) return 1.0;
  const double border = normal_quantile(1.0 * rank / ranks);
  return normal_cdf((border - known) / unknown_deviation);
}

double known_of(int value) { return most_known * (2.0 * value / (known_values - 1) - 1.0); }

}  // namespace

LandVariety::LandVariety(std::span<const glm::vec3> deviations)
    : table_(std::size_t{known_values} * shown_values) {
  if (deviations.empty()) return;
  constexpr double least_unknown = 1e-3;
  const std::vector<glm::dvec3> means = means_of_ranks(about_their_mean(deviations));
  for (int shown = 0, k = 0; shown < shown_values; ++shown) {
    const double unknown = std::max(1.0 - 1.0 * shown / (shown_values - 1), least_unknown);
    for (int known = 0; known < known_values; ++known, ++k) {
      glm::dvec3 mean(0.0);
      double below = 0.0;
      for (int rank = 0; rank < ranks; ++rank) {
        const double up_to = probability_below(rank + 1, known_of(known), std::sqrt(unknown));
        mean += (up_to - below) * means[static_cast<std::size_t>(rank)];
        below = up_to;
      }
      table_[static_cast<std::size_t>(k)] = glm::vec3(mean);
    }
  }
}

glm::vec3 LandVariety::at(double known, double shown) const {
  const Between x(0.5 * (known / most_known + 1.0), known_values), y(shown, shown_values);
  const auto value = [&](std::size_t i, std::size_t j) {
    return table_[(y.first + j) * known_values + x.first + i];
  };
  return bilinear(value(0, 0), value(1, 0), value(0, 1), value(1, 1), x.part, y.part);
}

}  // namespace wold::ground
