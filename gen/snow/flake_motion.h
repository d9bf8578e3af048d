#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/random.h"
#include "snow/flake_sizes.h"
#include "snow/simd_lanes.h"
#include "snow/weather.h"
#include "snow/wind_field.h"

namespace wold::snow {

/// A cube whose content repeats itself throughout the world.
struct PeriodicCube {
  glm::dvec3 centre_m{0.0};  ///< of the repetition that one looks at
  double side_m = 1.0;
};

/// Keyed flakes of such a cube. They are dealt to 4^k upright columns, each of which has a run of
/// them, at least 64: who sees little of a cube need not look at most of its flakes.
class Population {
 public:
  /// `max_bits`: k is no greater.
  Population(std::uint64_t key, std::uint64_t flakes, int max_bits = 4);

  std::uint64_t key() const { return key_; }
  std::uint64_t flakes() const { return flakes_; }
  int bits() const { return bits_; }  ///< k

  /// Column x + 2^k y of a flake.
  std::uint32_t column_of(std::uint64_t flake) const {
    return static_cast<std::uint32_t>((flake * columns_per_flake_) >> 32);
  }
  /// The flakes of columns up to that one.
  std::uint64_t flakes_before(std::uint64_t column) const {
    return std::min(flakes_, ((column << 32) + columns_per_flake_ - 1) / columns_per_flake_);
  }

 private:
  std::uint64_t key_;
  std::uint64_t flakes_;
  int bits_ = 0;
  std::uint64_t columns_per_flake_;  ///< in units of 2^-32
};

/// Where keyed flakes are at any time: a closed form, no frame needs another. A flake's place is
/// its keyed start in the cube, less its fall, plus the way of the wind, its own gusts and its
/// sway. All of these but the own ones are kept as turns of the cube, whole numbers of 2^-32 that
/// overflow as places wrap round; only in the cube do they become floats, so that a flake is placed
/// to a ten-millionth of the cube's side however long it has fallen.
class FlakeMotion {
 public:
  /// `rate_mm_h`: see FlakeSizes. Drops do not sway. `air`: see WindField.
  FlakeMotion(const scene::PrecipitationPart& part, const Weather& weather, double rate_mm_h,
              Falling what = Falling::snow, std::shared_ptr<const wind::AirFlow> air = nullptr);

  /// A turning whose rate is one of 2^bits equally spaced ones, at a moment: rate k has turned by
  /// `slowest` + k `step`, both off whole turns.
  struct Turning {
    float slowest;
    float step;
  };

  /// What all flakes share at a time.
  struct Moment {
    double time_s = 0.0;                  ///< since the first frame
    std::vector<float> diameters_m = {};  ///< see FlakeSizes
    Motion common = {};
    WindField::Moment gusts = {};
    Turning sway = {}, spin = {}, tilt = {};
    float thinning_per_m = 0.0F;  ///< see FlakeSizes
  };
  /// rate_mm_h > 0: what falls there and then, seen from a place on the ground.
  Moment moment(double time_s, double rate_mm_h, const glm::dvec2& eye_m = glm::dvec2(0.0)) const;

  /// A cube's flakes at a moment, seen from the eye.
  struct Air {
    Population population;
    glm::uvec3 way{0};       ///< common to all, turns of 2^-32 cubes
    std::uint64_t fall = 0;  ///< at FlakeSizes::speed_unit_m_s, turns of 2^-64 cubes
    glm::vec3 centre_from_eye_m{0.0F};
    float side_m = 1.0F;
  };
  static Air air(const Population& population, const PeriodicCube& cube, const Moment& moment,
                 const glm::dvec3& eye_m);

  /// Flakes before their own gusts and sway, which are costly and take them less than
  /// farthest_own_way_m() away.
  struct Drifting {
    VectorLanes from_eye;  ///< in the cube
    Lanes<std::uint64_t> key;
    Lanes<std::int32_t> speed;  ///< in units of FlakeSizes::speed_unit_m_s

    /// Takes over another's flake.
    void set(std::size_t lane, const Drifting& other, std::size_t others_lane);
  };
  /// Flakes first, first + 1, ... of the population.
  void drift(const Air& air, std::uint64_t first, Drifting& flakes) const;
  void fly(const Drifting& drifting, const Moment& moment, FlakeLanes& flakes) const;

  /// No flake's own gusts and sway take it farther.
  double farthest_own_way_m() const;
  /// Nor those of a flake of that key.
  float farthest_own_way_m(std::uint64_t key, const Moment& moment) const {
    if (what_ == Falling::rain) return farthest_gust_m_;
    return farthest_gust_m_ + farthest_sway_m(moment.diameters_m[FlakeSizes::rank(key)]);
  }

  /// Whether a flake of that key and diameter is in the air at all: all flakes are, see
  /// FlakeSizes::thinning_per_m().
  bool is_there(std::uint64_t key, float diameter_m, const Moment& moment) const {
    return moment.thinning_per_m <= 0.0F ||
           deviate(mixed(key ^ key_of("is there"))) > moment.thinning_per_m * diameter_m;
  }

  /// A number of a flake's own, exponentially distributed with mean 1.
  float deviate(std::uint64_t key) const { return sizes_.deviate(FlakeSizes::rank(key >> 32)); }

 private:
  /// Aggregates of a centimetre sway by 3 to 20 cm (Li 2024), smaller flakes by less.
  static constexpr float widest_sway_m = 0.2F, full_sway_m = 0.01F;
  static float widest_sway_of_m(float diameter_m) {
    return widest_sway_m * lesser(1.0F, diameter_m * (1.0F / full_sway_m));
  }
  /// Along two axes.
  static float farthest_sway_m(float diameter_m) {
    return 1.4142136F * widest_sway_of_m(diameter_m);
  }
  static void add_sway(const Moment& moment, FlakeLanes& flakes);

  Falling what_;
  WindField wind_;
  FlakeSizes sizes_;
  float farthest_gust_m_;
};

}  // namespace wold::snow
