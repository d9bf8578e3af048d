#include "wind/canopy_motion.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "core/elementary.h"

namespace wold::wind {
namespace {

/// The mean of a wave over a length, over its height.
double mean_over(double turns) {
  const double x = std::numbers::pi * turns;
  return std::abs(x) < 1e-6 ? 1.0 : math::sin(x) / x;
}

/// A wave as the grass of a cell answers it.
class CellAnswer {
 public:
  CellAnswer(const Beam& beam, double damping, double cell_m)
      : natural_hz_(natural_frequency_hz(beam)), damping_(damping), cell_m_(cell_m) {}

  void add(const glm::dvec2& per_m, double per_s, double phase, double height, WaveSum& sum) const {
    const std::complex<double> by = answer(per_s, natural_hz_, damping_);
    const double lead = math::atan2(by.imag(), by.real()) / (2.0 * std::numbers::pi);
    const double gain = math::hypot(by.real(), by.imag()) * mean_over(per_m.x * cell_m_) *
                        mean_over(per_m.y * cell_m_);
    // At one place a wave's phase falls as time goes on: what lags has a greater one.
    sum.add(per_m, phase - lead, gain * height);
  }

 private:
  double natural_hz_, damping_, cell_m_;
};

}  // namespace

CanopyMotion::CanopyMotion(std::shared_ptr<const AirFlow> flow, const Moment& now, const Beam& beam,
                           double cell_m)
    : flow_(std::move(flow)), heading_(Axes(now.heading_deg).along) {
  const Profile& profile = flow_->profile();
  const double top_m_s = now.speed_m_s * profile.at_top();
  steady_load_ = steady_deflection(beam, profile, top_m_s);
  const CellAnswer cell(beam, damping_ratio(beam, profile, top_m_s), cell_m);
  constexpr auto along = static_cast<std::size_t>(Component::along);
  constexpr auto across = static_cast<std::size_t>(Component::across);
  for (const GustWave& wave : flow_->gusts().waves(profile.canopy_m(), now)) {
    cell.add(wave.per_m, wave.per_s, wave.phase[along], wave.height[along], gusts_along_);
    cell.add(wave.per_m, wave.per_s, wave.phase[across], wave.height[across], gusts_across_);
  }
  for (const CanopyWave& wave : flow_->honami().waves(now))
    cell.add(wave.per_m, wave.per_s, wave.phase, wave.height, honami_);
}

glm::dvec2 CanopyMotion::load(const glm::dvec2& place_m) const {
  const glm::dvec2 mean = flow_->speed_up().mean(place_m, heading_);
  const glm::dvec2 wind = (1.0 + gusts_along_.at(place_m)) * (1.0 + honami_.at(place_m)) * mean +
                          gusts_across_.at(place_m) * glm::dvec2(mean.y, -mean.x);
  return steady_load_ * glm::length(wind) * wind;
}

}  // namespace wold::wind
