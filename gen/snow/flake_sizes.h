#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "snow/fall_speed.h"

namespace wold::snow {

/// What falls.
enum class Falling : std::uint8_t { snow, rain };

/// Sizes, crystals and fall speeds of keyed flakes. Each has a rank among them for good: when the
/// rate changes, all grow or shrink, but each remains the crystal it is and falls as it did.
///
/// Melted diameters are 0.5 mm + e / Lambda, e = -log(1 - u) for the rank's u: Gunn and Marshall's
/// above 0.5 mm. Crystals are dealt to the ranks in turn, so that of neighbours the shares are
/// crystal_fractions(). Speeds are Locatelli and Hobbs's times one factor for all, which makes the
/// water that falls be the rate: their speeds and Gunn and Marshall's numbers were measured in
/// different snow, and the water in the air times the speeds is off from the rate by up to a fifth.
///
/// Drops of rain are Marshall and Palmer's above min_drop_mm, at their terminal speeds. A drop
/// falls as its size has it, so that none changes: when it rains less, fewer are there.
class FlakeSizes {
 public:
  /// `rate_mm_h` is the one at which the water that falls is exactly that; > 0. `crystal` as in
  /// crystal_fractions().
  FlakeSizes(double rate_mm_h, scene::CrystalChoice crystal);

  /// Drops of the heaviest rain; > 0.
  static FlakeSizes raindrops(double heaviest_mm_h);

  static constexpr int rank_bits = 12;

  /// Below 2^rank_bits; the lowest of 64 random bits.
  static std::uint32_t rank(std::uint64_t bits) {
    return static_cast<std::uint32_t>(bits) & ((1U << rank_bits) - 1U);
  }
  Crystal crystal(std::uint32_t rank) const { return crystals_[rank]; }
  /// e of a rank: mean 1.
  float deviate(std::uint32_t rank) const { return deviates_[rank]; }

  /// How fast a flake of those random bits falls, in units of speed_unit_m_s; bits above the lowest
  /// 32 are left for others. Speeds of equal flakes spread by a standard deviation of 12 %
  /// (measured at Hokuriku: 12 of 100 cm/s), those of drops do not.
  std::uint32_t speed(std::uint64_t bits) const {
    const std::uint64_t spread = slowest_ + step_ * (bits >> rank_bits & 1023U);
    return static_cast<std::uint32_t>(speeds_[rank(bits)] * spread >> (20 - finer_bits));
  }
  static constexpr float speed_unit_m_s = 0x1p-16F;

  /// Diameters by rank: of flakes at that rate, of drops at any.
  std::vector<float> diameters_m(double rate_mm_h) const;

  /// A drop of diameter d of the heaviest rain is there in a rain of that rate by the chance
  /// exp(-d times this), 1/m: so Marshall and Palmer's numbers become each other. 0 of flakes.
  double thinning_per_m(double rate_mm_h) const;

 private:
  FlakeSizes() : speeds_(1U << rank_bits), crystals_(speeds_.size()), deviates_(speeds_.size()) {}
  void set_speed(std::size_t rank, double speed_m_s);

  static constexpr double one_ = 1U << 20;
  static constexpr double half_width_ = 0.12 * 1.7320508;  ///< evenly spread
  static constexpr int finer_bits = 4;  ///< speed_unit_m_s is so much finer than a rank's
  std::vector<std::uint16_t> speeds_;   ///< in units of 2^-12 m/s, so that they stay near at hand
  std::vector<Crystal> crystals_;
  std::vector<float> deviates_;
  std::uint64_t slowest_ = static_cast<std::uint64_t>(one_ * (1.0 - half_width_));
  std::uint64_t step_ = static_cast<std::uint64_t>(one_ * 2.0 * half_width_ / 1023.0);
  double heaviest_mm_h_ = 0.0;  ///< of drops; 0: they are flakes
};

}  // namespace wold::snow
