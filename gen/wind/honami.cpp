#include "wind/honami.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "core/random.h"
#include "wind/spectrum.h"

namespace wold::wind {
namespace {

constexpr double spacing_in_shear_lengths = 8.1;
constexpr double travel_over_top = 1.8;
constexpr double deviation_at_top = 0.5;  ///< of the wind over its mean
constexpr int modes = 16;
constexpr double length_spread = 0.2;
constexpr double aside_spread = 0.2;
constexpr double shortest = 0.5;  ///< of the scattered wave numbers, over the mean

}  // namespace

Honami::Honami(const Profile& profile, double intensity, std::uint64_t seed)
    : profile_(profile),
      wave_length_m_(spacing_in_shear_lengths * profile.shear_length_m()),
      travel_(travel_over_top * profile.at_top()) {
  const double neutral = deviation_over_friction() * profile.friction();
  const double rest =
      std::sqrt(std::max(deviation_at_top * deviation_at_top - intensity * intensity, 0.0));
  height_ = rest * std::min(intensity / neutral, 1.0) * std::sqrt(2.0 / modes);
  for (int i = 0; i < modes; ++i) {
    const auto key = [&](const char* purpose) {
      return RandomKey{seed, key_of("honami"), static_cast<std::uint64_t>(i), key_of(purpose)};
    };
    const double number =
        std::max(1.0 + length_spread * random_normal(key("wave length")), shortest);
    modes_.push_back({number / wave_length_m_,
                      aside_spread * random_normal(key("aside")) / wave_length_m_,
                      random_uniform(key("phase"))});
  }
}

std::vector<CanopyWave> Honami::waves(const Moment& now) const {
  const Axes axes(now.heading_deg);
  std::vector<CanopyWave> waves;
  for (const Mode& mode : modes_)
    waves.push_back({axes.on_ground({mode.along_per_m, mode.right_per_m}),
                     mode.along_per_m * travel_ * now.speed_m_s,
                     mode.phase - mode.along_per_m * travel_ * now.run_m, height_});
  return waves;
}

double Honami::left_at(double height_m) const {
  const double away_m = std::abs(height_m - profile_.canopy_m());
  return math::exp(-2.0 * std::numbers::pi * away_m / wave_length_m_);
}

}  // namespace wold::wind
