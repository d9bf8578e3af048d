#include "wind/gusts.h"

#include <gtest/gtest.h>

#include "line_spectrum.h"
#include "wind/wave_sum.h"

namespace wold::wind {
namespace {

constexpr double intensity = 0.2;

WaveSum sum_of(const std::vector<GustWave>& waves, Component component) {
  const auto i = static_cast<std::size_t>(component);
  WaveSum sum;
  for (const GustWave& wave : waves) sum.add(wave.per_m, wave.phase[i], wave.height[i]);
  return sum;
}

/// The gusts along a line that runs with an east wind, `aside_m` south of the zero.
test::Transform line_of(const WaveSum& gusts, std::size_t count, double step_m,
                        double aside_m = 0.0) {
  test::Transform values;
  for (std::size_t i = 0; i < count; ++i)
    values.emplace_back(gusts.at({static_cast<double>(i) * step_m, -aside_m}));
  return test::windowed(std::move(values));
}

Moment east_wind(double speed_m_s, double run_m = 0.0) { return {speed_m_s, 90.0, run_m}; }

/// n S(n) / u_*^2 of Kaimal and others 1972, as Kaimal and Finnigan 1994 print it.
double kaimal(Component component, double f) {
  switch (component) {
    case Component::along:
      return 102.0 * f / std::pow(1.0 + 33.0 * f, 5.0 / 3.0);
    case Component::across:
      return 17.0 * f / std::pow(1.0 + 9.5 * f, 5.0 / 3.0);
    default:
      return 2.1 * f / (1.0 + 5.3 * std::pow(f, 5.0 / 3.0));
  }
}

/// Its integral over n between two frequencies, the friction velocity being 1.
double kaimal_between(Component component, double low_f, double high_f) {
  constexpr int steps = 400;
  const double step = std::log(high_f / low_f) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += kaimal(component, low_f * std::exp((i + 0.5) * step));
  return sum * step;
}

class KaimalsSpectrum : public testing::TestWithParam<Component> {};

// Taylor's hypothesis: along the wind a wave of k turns per metre has the frequency k U.
TEST_P(KaimalsSpectrum, IsWhatSampledGustsHaveAtTwoHeights) {
  const Profile profile(0.3);
  constexpr int seeds = 40;
  constexpr std::size_t count = 16384;
  for (const double height_m : {10.0, 2.0}) {
    const double step_m = 0.05 * height_m;
    std::vector<test::Transform> lines;
    for (std::uint64_t seed = 0; seed < seeds; ++seed)
      lines.push_back(line_of(
          sum_of(Gusts(profile, intensity, seed).waves(height_m, east_wind(6.0)), GetParam()),
          count, step_m));
    // From waves per metre to f: heights are over the displacement, 2/3 of 0.3 m.
    const double f_m = (height_m - 0.2) / profile.at(height_m);
    for (double low = 0.02 / height_m; low < 1.0 / height_m; low *= 2.0) {
      double sampled = 0.0;
      for (const test::Transform& line : lines)
        sampled += test::variance_between(line, step_m, low, 2.0 * low) / seeds;
      const double wanted = kaimal_between(GetParam(), low * f_m, 2.0 * low * f_m) * intensity *
                            intensity / 4.636;  // sigma_u = 2.153 u_*
      EXPECT_NEAR(sampled / wanted, 1.0, 0.1) << height_m << " m, from " << 1.0 / low << " m down";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Gusts, KaimalsSpectrum,
                         testing::Values(Component::along, Component::across, Component::up));

/// Root coherence of waves from low_per_m to high_per_m at two places, and the mean of
/// exp(-10 n d / U) over them.
struct Coherence {
  double sampled = 0.0;
  double davenports = 0.0;
};

Coherence coherence_of(double aside_m, double up_m, double low_per_m, double high_per_m) {
  const Profile profile(0.3);
  constexpr int seeds = 150;
  constexpr std::size_t count = 2048;
  const double step_m = 0.05 / high_per_m, apart_m = std::hypot(aside_m, up_m);
  double common = 0.0, one = 0.0, other = 0.0, wanted = 0.0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Gusts gusts(profile, intensity, seed);
    const WaveSum here = sum_of(gusts.waves(10.0, east_wind(6.0)), Component::along);
    const WaveSum there = sum_of(gusts.waves(10.0 + up_m, east_wind(6.0)), Component::along);
    const test::Transform a = line_of(here, count, step_m);
    const test::Transform b = line_of(there, count, step_m, aside_m);
    for (std::size_t k = 1; k < count / 2; ++k) {
      const double per_m = static_cast<double>(k) / (count * step_m);
      if (per_m < low_per_m || per_m >= high_per_m) continue;
      common += (a[k] * std::conj(b[k])).real();
      one += std::norm(a[k]);
      other += std::norm(b[k]);
      wanted += std::norm(a[k]) * std::exp(-10.0 * per_m * apart_m);
    }
  }
  return {common / std::sqrt(one * other), wanted / one};
}

TEST(Gusts, HaveDavenportsCoherenceAcrossTheWind) {
  for (const double wave_m : {20.0, 60.0})
    for (const double apart_m : {0.02 * wave_m, 0.05 * wave_m, 0.1 * wave_m}) {
      const Coherence found = coherence_of(apart_m, 0.0, 1.0 / (1.3 * wave_m), 1.0 / wave_m);
      EXPECT_NEAR(found.sampled / found.davenports, 1.0, 0.1) << wave_m << " " << apart_m;
    }
}

TEST(Gusts, HaveDavenportsCoherenceUpwards) {
  const Coherence found = coherence_of(0.0, 3.0, 1.0 / 78.0, 1.0 / 60.0);
  EXPECT_NEAR(found.sampled / found.davenports, 1.0, 0.1);
}

TEST(Gusts, TravelWithTheWindUnchanged) {
  const Gusts gusts(Profile(0.3), intensity, 5);
  const double speed_m_s = 7.0, later_s = 3.0;
  const auto before = gusts.waves(2.0, east_wind(speed_m_s, 100.0));
  const auto after = gusts.waves(2.0, east_wind(speed_m_s, 100.0 + speed_m_s * later_s));
  for (int i = 0; i < 20; ++i) {
    const glm::dvec2 at_m(1.3 * i, 20.0 - 0.7 * i);
    const glm::dvec2 upwind_m = at_m - glm::dvec2(speed_m_s * later_s, 0.0);
    EXPECT_LT(glm::distance(gust_at(after, at_m), gust_at(before, upwind_m)), 1e-9);
  }
}

// A frequency is what comes by at one place.
TEST(Gusts, HaveTheFrequencyOfWhatComesBy) {
  const Gusts gusts(Profile(0.3), intensity, 5);
  constexpr double step_s = 0.01, speed_m_s = 7.0;
  const auto before = gusts.waves(2.0, east_wind(speed_m_s, 0.0));
  const auto after = gusts.waves(2.0, east_wind(speed_m_s, speed_m_s * step_s));
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_NEAR(before[i].phase[0] - after[i].phase[0], before[i].per_s * step_s, 1e-9);
}

TEST(WaveSum, IsTheSumOfItsWaves) {
  const Gusts gusts(Profile(0.3), intensity, 9);
  const auto waves = gusts.waves(10.0, east_wind(6.0, 12345.0));
  const WaveSum along = sum_of(waves, Component::along);
  for (int i = 0; i < 50; ++i) {
    const glm::dvec2 at_m(17.0 * i, 3000.0 - 5.0 * i);
    EXPECT_NEAR(along.at(at_m), gust_at(waves, at_m).x, 1e-5);
  }
}

}  // namespace
}  // namespace wold::wind
