#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

#include "snow/fall_speed.h"

/// Flakes are worked on many at a time, one quantity after the other: the compiler makes loops over
/// lanes do four at once or more, with the same results as one by one, and what they leave for each
/// other stays in the nearest cache.
namespace wold::snow {

inline constexpr std::size_t lanes = 64;

template <class T>
using Lanes = std::array<T, lanes>;

/// Functions whose loops run over lanes: on processors that can, eight lanes at once, in the same
/// single operations and so with the same results. Not in sanitized builds: which clone is run gets
/// chosen before the sanitizers' runtime is there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WOLD_LANES_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WOLD_LANES_WIDE
#endif

/// By value: the compiler takes std::min and std::max for branches where they stand in loops.
constexpr float lesser(float a, float b) { return a < b ? a : b; }
constexpr float greater(float a, float b) { return a > b ? a : b; }

struct VectorLanes {
  Lanes<float> x, y, z;

  glm::vec3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
  void set(std::size_t lane, const glm::vec3& vector) {
    x[lane] = vector.x;
    y[lane] = vector.y;
    z[lane] = vector.z;
  }
};

/// Some of the lanes, in their order.
struct Chosen {
  Lanes<std::uint8_t> lane;
  std::size_t count = 0;

  /// Those below `end` for which test(lane) is true; it should have no branches.
  template <class Test>
  static Chosen by(const Test& test, std::size_t end = lanes) {
    Lanes<std::uint8_t> passed;
    for (std::size_t i = 0; i < lanes; ++i) passed[i] = test(i) ? 1 : 0;
    Chosen chosen;
    for (std::size_t i = 0; i < end; ++i) {
      chosen.lane[chosen.count] = static_cast<std::uint8_t>(i);
      chosen.count += passed[i];
    }
    return chosen;
  }
};

/// A flake in the air.
struct Flake {
  glm::dvec3 centre_m{0.0};
  glm::dvec3 velocity_m_s{0.0};
  double diameter_m = 0.0;  ///< see flake_diameter_mm()
  Crystal crystal = Crystal::aggregate;
  std::uint64_t bits = 0;   ///< random ones of its own; the highest two are made use of
  float opacity = 1.0F;     ///< multiplies its picture's
  float spin_turns = 0.0F;  ///< about the way to the eye
  float tilt_turns = 0.0F;  ///< where it is in its tumbling to either side of facing the eye
};

/// Flakes in the air, as Flake; their centres relative to the eye.
struct FlakeLanes {
  VectorLanes from_eye, velocity;
  Lanes<float> diameter, opacity, spin_turns, tilt_turns;
  Lanes<std::uint64_t> bits;
  Lanes<Crystal> crystal;

  void set(std::size_t lane, const Flake& flake, const glm::dvec3& eye_m) {
    from_eye.set(lane, glm::vec3(flake.centre_m - eye_m));
    velocity.set(lane, glm::vec3(flake.velocity_m_s));
    diameter[lane] = static_cast<float>(flake.diameter_m);
    opacity[lane] = flake.opacity;
    spin_turns[lane] = flake.spin_turns;
    tilt_turns[lane] = flake.tilt_turns;
    bits[lane] = flake.bits;
    crystal[lane] = flake.crystal;
  }
};

}  // namespace wold::snow
