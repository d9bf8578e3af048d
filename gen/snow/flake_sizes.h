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
    float speed_m_s = 0.0F;
  };
  /// Of 64 random bits; those above the lowest 32 are left for others. Speeds of equal flakes
  /// spread by a standard deviation of 12 % (measured at Hokuriku: 12 of 100 cm/s).
  Body body(std::uint64_t bits) const {
    const auto rank = static_cast<std::uint32_t>(bits) & last_rank;
    const Rank& of_rank = ranks_[rank];
    const float choice = ten_bits(bits >> 12) / 1024.0F;
    std::size_t crystal = 0;
    for (std::size_t i = 0; i + 1 < crystal_kinds; ++i)
      crystal += choice >= of_rank.shares_up_to[i] ? 1 : 0;
    constexpr float deviation = 0.12F, half_width = deviation * 1.7320508F;  // evenly spread
    const float spread = 1.0F + half_width * (ten_bits(bits >> 22) * (2.0F / 1023.0F) - 1.0F);
    return {rank, static_cast<Crystal>(crystal), of_rank.speed_m_s[crystal] * spread};
  }

  /// e of a rank: mean 1.
  float deviate(std::uint32_t rank) const { return ranks_[rank].deviate; }

  /// Diameters by rank, at a rate of snowfall with that Lambda, see gunn_marshall().
  std::vector<float> diameters_m(double lambda_per_mm) const;

  static constexpr int rank_bits = 11;
  static constexpr std::uint32_t last_rank = (1U << rank_bits) - 1U;

 private:
  static float ten_bits(std::uint64_t bits) {
    return static_cast<float>(static_cast<int>(bits & 1023U));
  }

  struct Rank {
    std::array<float, crystal_kinds> speed_m_s;
    std::array<float, crystal_kinds - 1> shares_up_to;  ///< running sum of crystal_shares()
    float deviate;                                      ///< e
  };
  std::vector<Rank> ranks_;
};

}  // namespace wold::snow
