#include "terrain/broken_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/ground_map.h"
#include "core/normal_distribution.h"
#include "core/random.h"

namespace wold::terrain {
namespace {

/// Three numbers in [0, 1).
glm::dvec3 three_of(std::uint64_t bits) {
  constexpr std::uint64_t part_bits = 21, mask = (1ULL << part_bits) - 1;
  return glm::dvec3(bits & mask, bits >> part_bits & mask, bits >> 2 * part_bits & mask) /
         static_cast<double>(mask + 1);
}

template <int dims>
using Step = glm::vec<dims, int>;

/// Along how many axes a step leads.
template <int dims>
int axes_of(const Step<dims>& step) {
  int axes = 0;
  for (int axis = 0; axis < dims; ++axis) axes += step[axis] != 0;
  return axes;
}

/// From a cell to itself and to all that touch it, those across a face before those across edges
/// and corners.
template <int dims>
auto steps_outwards() {
  constexpr int count = dims == 3 ? 27 : 9;
  std::array<Step<dims>, count> steps;
  for (int i = 0; i < count; ++i)
    for (int axis = 0, rest = i; axis < dims; ++axis, rest /= 3)
      steps[static_cast<std::size_t>(i)][axis] = rest % 3 - 1;
  std::ranges::stable_sort(steps, {}, axes_of<dims>);
  return steps;
}

/// The cell that a place is in, and those about it.
template <int dims>
class CellsNear {
 public:
  using Way = glm::vec<dims, double>;

  CellsNear(const Way& at, std::uint64_t key)
      : cell_(glm::floor(at)), within_(at - glm::floor(at)) {
    for (int step = -1; step <= 1; ++step)
      column_[static_cast<std::size_t>(step + 1)] = mixed(mixed(key) ^ as_bits(cell_.x + step));
  }

  /// The low corner of one.
  Way corner(const Step<dims>& step) const { return Way(cell_ + step); }

  /// Squared distance from the place to the nearest place in one.
  double apart2(const Step<dims>& step) const {
    double apart2 = 0.0;
    for (int axis = 0; axis < dims; ++axis) {
      const double apart = step[axis] > 0 ? 1.0 - within_[axis] : within_[axis];
      if (step[axis] != 0) apart2 += apart * apart;
    }
    return apart2;
  }

  /// random_bits() of {key, x, y, z}, z of the plane being 0.
  std::uint64_t bits(const Step<dims>& step) const {
    const Step<dims> cell = cell_ + step;
    const int z = dims == 3 ? cell[dims - 1] : 0;
    return mixed(mixed(column_[static_cast<std::size_t>(step.x + 1)] ^ as_bits(cell.y)) ^
                 as_bits(z));
  }

 private:
  static std::uint64_t as_bits(int number) { return static_cast<std::uint64_t>(number); }

  Step<dims> cell_;
  Way within_;
  std::array<std::uint64_t, 3> column_{};  ///< what the random bits of a column have in common
};

/// How much of a joint a place is at that distance from one, in blocks: 0 to 1; and the mean over
/// all places.
double joint_at(double joint) { return 1.0 - glm::smoothstep(0.0, 0.08, joint); }
template <int dims>
constexpr double mean_joint = dims == 3 ? 0.207 : 0.149;

/// The mean of max(0, x) of normally distributed x.
double mean_above_zero(double mean, double deviation) {
  if (std::abs(mean) >= 4.0 * deviation) return std::max(0.0, mean);
  const double at = mean / deviation;
  return mean * normal_cdf(at) +
         deviation * math::exp(-0.5 * at * at) / std::sqrt(2.0 * std::numbers::pi);
}

/// What meets a face: `sun` times its cosine to the sun, where that is positive, and `sky`.
struct Light {
  double sun, cosine, sky;
};

Light light_of(const glm::dvec3& up, const glm::dvec3& to_sun) {
  constexpr double low_sine = 0.1;
  const double sunlight = 0.8 * std::clamp(to_sun.z / low_sine, 0.0, 1.0);
  return {sunlight, glm::dot(up, to_sun), (1.0 - sunlight) * (0.5 + 0.5 * up.z)};
}

/// The mean of max(0, light - least), `least` not being negative, over faces whose cosines to the
/// sun are normally distributed about that of `light` with the deviation `tilt`.
double mean_over(double least, const Light& light, double tilt) {
  if (least <= light.sky)
    return light.sun * mean_above_zero(light.cosine, tilt) + light.sky - least;
  if (light.sun <= 0.0) return 0.0;
  return light.sun * mean_above_zero(light.cosine - (least - light.sky) / light.sun, tilt);
}

glm::dvec3 level(const glm::dvec2& way) { return {way, 0.0}; }
glm::dvec3 level(const glm::dvec3& way) { return way; }

}  // namespace

template <int dims>
Block<dims> block_at(const glm::vec<dims, double>& at, std::uint64_t key) {
  using Way = glm::vec<dims, double>;
  static const auto steps = steps_outwards<dims>();
  const CellsNear<dims> cells(at, key);
  double nearest2 = 1e9, next2 = 1e9;
  Way next{};
  Block<dims> block;
  for (const Step<dims>& step : steps) {
    if (cells.apart2(step) >= next2) continue;
    const std::uint64_t bits = cells.bits(step);
    const Way away = cells.corner(step) + Way(three_of(bits)) - at;
    const double away2 = glm::dot(away, away);
    if (away2 < nearest2) {
      next2 = nearest2, next = block.middle_away;
      nearest2 = away2, block.middle_away = away, block.bits = bits;
    } else if (away2 < next2) {
      next2 = away2, next = away;
    }
  }
  block.joint = 0.5 * (next2 - nearest2) / std::max(glm::distance(next, block.middle_away), 1e-9);
  return block;
}

double light_on(const glm::dvec3& up, const glm::dvec3& to_sun) {
  return mean_over(0.0, light_of(up, to_sun), /*tilt=*/0.0);
}

double slope_step_m(const glm::dvec3& up, double step_m) {
  constexpr double least = 0.2;
  return step_m / std::max(up.z, least);
}

template <int dims>
BrokenSurface<dims>::BrokenSurface(std::span<const BlockSize> sizes, std::uint64_t key,
                                   double step_m)
    : sizes_(sizes), key_(key), step_m_(step_m) {}

template <int dims>
bool BrokenSurface<dims>::is_shown() const {
  return shown_fraction(sizes_.front().block_m, step_m_) > 0.0;
}

template <int dims>
double BrokenSurface<dims>::hidden_tilt(const glm::dvec3& up) const {
  const double step_m = slope_step_m(up, step_m_);
  double hidden2 = 0.0;
  for (const BlockSize& size : sizes_) {
    const double shown = shown_fraction(size.block_m, step_m);
    hidden2 += (1.0 - shown * shown) * size.tilt * size.tilt / 3.0;
  }
  return std::sqrt(hidden2);
}

template <int dims>
typename BrokenSurface<dims>::Broken BrokenSurface<dims>::broken(
    const glm::vec<dims, double>& place_m, const glm::dvec3& up) const {
  Broken broken{up, 1.0, 0.0};
  double variance = 0.0;
  const double step_m = slope_step_m(up, step_m_);
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    const BlockSize& size = sizes_[i];
    const double shown = shown_fraction(size.block_m, step_m);
    if (shown <= 0.0) break;
    const Block<dims> block = block_at<dims>(place_m / size.block_m, key_ + i);
    broken.face += shown * size.tilt * (2.0 * three_of(mixed(block.bits)) - 1.0);
    variance += shown * shown * size.tilt * size.tilt / 3.0;
    broken.face -= shown * size.dome * level(block.middle_away);
    broken.open *= 1.0 + shown * size.dark * (mean_joint<dims> - joint_at(block.joint));
    broken.open *= 1.0 + shown * size.own_shade * (2.0 * three_of(mixed(block.bits + 1)).x - 1.0);
  }
  broken.tilt = std::sqrt(variance);
  return broken;
}

template <int dims>
glm::dvec3 BrokenSurface<dims>::face(const glm::vec<dims, double>& place_m,
                                     const glm::dvec3& up) const {
  return broken(place_m, up).face;
}

template <int dims>
double BrokenSurface<dims>::shade(const glm::vec<dims, double>& place_m, const glm::dvec3& up,
                                  const glm::dvec3& to_sun) const {
  const auto [face, open, tilt] = broken(place_m, up);
  const Light light = light_of(up, to_sun);
  const double mean = mean_over(0.0, light, tilt);
  const double least = 0.3 * mean, most = 1.8 * mean;
  const double mean_cut = least + mean_over(least, light, tilt) - mean_over(most, light, tilt);
  return open * std::clamp(light_on(face, to_sun), least, most) / mean_cut;
}

template Block<2> block_at<2>(const glm::dvec2&, std::uint64_t);
template Block<3> block_at<3>(const glm::dvec3&, std::uint64_t);
template class BrokenSurface<2>;
template class BrokenSurface<3>;

}  // namespace wold::terrain
