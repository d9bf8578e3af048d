#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "snow/fall_speed.h"

namespace wold::snow {

/// Sizes, crystals and fall speeds of keyed flakes. Each has a rank among them for good: when the
/// rate changes, all grow or shrink, but each remains the crystal it is and falls as it did.
///
/// Melted diameters are 0.5 mm + e / Lambda, e = -log(1 - u) for a uniform u: Gunn and Marshall's
/// above 0.5 mm. Speeds are Locatelli and Hobbs's times one factor for all, which makes the water
/// that falls be the rate: their speeds and Gunn and Marshall's numbers were measured in different
/// snow, and the water in the air times the speeds is off from the rate by up to a fifth.
class FlakeSizes {
 public:
  /// `rate_mm_h` is the one at which the water that falls is exactly that; > 0. `crystal` as in
  /// crystal_shares().
  FlakeSizes(double rate_mm_h, const std::string& crystal);

  /// What a flake is and how fast it falls.
  struct Body {
    std::uint32_t rank = 0;  ///< below 2^rank_bits
    Crystal crystal = Crystal::aggregate;
    std::uint32_t speed = 0;  ///< in units of speed_unit_m_s

    float speed_m_s() const { return static_cast<float>(speed) * speed_unit_m_s; }
  };
  /// Of 64 random bits; those above the lowest 32 are left for others. Speeds of equal flakes
  /// spread by a standard deviation of 12 % (measured at Hokuriku: 12 of 100 cm/s).
  Body body(std::uint64_t bits) const {
    const auto rank = static_cast<std::uint32_t>(bits) & last_rank;
    const Rank& of_rank = ranks_[rank];
    const std::uint32_t choice = ten_bits(bits >> 12);
    std::size_t crystal = 0;
    for (const std::uint16_t share_up_to : of_rank.shares_up_to)
      crystal += choice >= share_up_to ? 1U : 0U;
    constexpr double deviation = 0.12, half_width = deviation * 1.7320508;  // evenly spread
    constexpr double one = 1U << 20;
    constexpr auto slowest = static_cast<std::uint64_t>(one * (1.0 - half_width));
    constexpr auto step = static_cast<std::uint64_t>(one * 2.0 * half_width / 1023.0 + 0.5);
    const std::uint64_t spread = slowest + step * ten_bits(bits >> 22);
    return {rank, static_cast<Crystal>(crystal),
            static_cast<std::uint32_t>(of_rank.speed[crystal] * spread >> (20 - finer_bits))};
  }
  static constexpr float speed_unit_m_s = 0x1p-16F;

  /// e of a rank: mean 1.
  float deviate(std::uint32_t rank) const { return deviates_[rank]; }

  /// Diameters by rank, at a rate of snowfall with that Lambda, see gunn_marshall().
  std::vector<float> diameters_m(double lambda_per_mm) const;

  static constexpr int rank_bits = 11;
  static constexpr std::uint32_t last_rank = (1U << rank_bits) - 1U;

 private:
  static std::uint32_t ten_bits(std::uint64_t bits) {
    return static_cast<std::uint32_t>(bits) & 1023U;
  }

  static constexpr int finer_bits = 4;  ///< speed_unit_m_s is so much finer than a rank's
  /// Small, so that all of them stay in the nearest cache.
  struct Rank {
    std::array<std::uint16_t, crystal_kinds> speed;  ///< in units of 2^-12 m/s
    /// Running sum of crystal_shares(), of 1024.
    std::array<std::uint16_t, crystal_kinds - 1> shares_up_to;
  };
  std::vector<Rank> ranks_;
  std::vector<float> deviates_;
};

}  // namespace wold::snow
