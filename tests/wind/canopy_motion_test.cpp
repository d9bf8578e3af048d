#include "wind/canopy_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "line_spectrum.h"
#include "wind/streamlining.h"

namespace wold::wind {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double speed_m_s = 8.0, canopy_m = 0.4;
constexpr Beam blade = {canopy_m, 0.0056, 9e-4, 5.6e-5};
/// Three times as fast: it follows honami, which come by with 2.5 Hz.
constexpr Beam stiff = {canopy_m, 0.0056, 9e-4, 9.0 * 5.6e-5};

std::shared_ptr<const AirFlow> flow_of(double intensity, std::uint64_t seed = 3) {
  return std::make_shared<const AirFlow>(Heightfield(3, 60.0, 2.0F), canopy_m, intensity, seed);
}

Moment east_wind(double time_s) { return {speed_m_s, 90.0, speed_m_s * time_s}; }

/// The wind that a load stands for, over its mean: the load goes with its square.
glm::dvec2 wind_of(const glm::dvec2& load, double steady_load) {
  return load / std::sqrt(steady_load * glm::length(load));
}

/// Where an oscillator is after so long, pushed by force(time), as if it had always been: by
/// Runge's and Kutta's fourth order, from rest, long before.
double oscillated(const std::function<double(double)>& force, double natural_hz, double damping) {
  constexpr double step_s = 2e-3;
  const double omega = two_pi * natural_hz;
  glm::dvec2 state(0.0);  // place and speed
  const auto rate = [&](double t, const glm::dvec2& s) {
    return glm::dvec2(s.y, omega * omega * (force(t) - s.x) - 2.0 * damping * omega * s.y);
  };
  for (int i = -4000; i < 0; ++i) {
    const double t = i * step_s;
    const glm::dvec2 a = rate(t, state);
    const glm::dvec2 b = rate(t + 0.5 * step_s, state + 0.5 * step_s * a);
    const glm::dvec2 c = rate(t + 0.5 * step_s, state + 0.5 * step_s * b);
    const glm::dvec2 d = rate(t + step_s, state + step_s * c);
    state += step_s / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return state.x;
}

// The closed form is where stepping through time ends.
TEST(CanopyMotion, IsWhatAnOscillatorInThatWindDoes) {
  const auto flow = flow_of(0.2);
  const double top_m_s = speed_m_s * flow->profile().at_top();
  const double natural_hz = natural_frequency_hz(blade);
  const double damping = damping_ratio(blade, flow->profile(), top_m_s);
  const CanopyMotion motion(flow, east_wind(0.0), blade, 0.0);
  const auto gusts = flow->gusts().waves(canopy_m, east_wind(0.0));
  const auto honami = flow->honami().waves(east_wind(0.0));
  for (const glm::dvec2& at_m : {glm::dvec2(20.0, 30.0), glm::dvec2(33.3, 11.1)}) {
    const auto along = [&](double t) {
      double sum = 0.0;
      for (const GustWave& wave : gusts)
        sum += wave.height[0] *
               std::cos(two_pi * (glm::dot(wave.per_m, at_m) + wave.phase[0] - wave.per_s * t));
      return sum;
    };
    const auto waving = [&](double t) {
      double sum = 0.0;
      for (const CanopyWave& wave : honami)
        sum += wave.height *
               std::cos(two_pi * (glm::dot(wave.per_m, at_m) + wave.phase - wave.per_s * t));
      return sum;
    };
    const double wanted = (1.0 + oscillated(along, natural_hz, damping)) *
                          (1.0 + oscillated(waving, natural_hz, damping));
    const glm::dvec2 wind =
        wind_of(motion.load(at_m), steady_deflection(blade, flow->profile(), top_m_s));
    EXPECT_NEAR(wind.x, wanted, 2e-3);
  }
}

TEST(CanopyMotion, OfASteadyWindIsSteadyAndAlongIt) {
  const auto flow = flow_of(0.0);
  const CanopyMotion motion(flow, east_wind(4.0), blade, 0.6);
  const double wanted =
      steady_deflection(blade, flow->profile(), speed_m_s * flow->profile().at_top());
  for (int i = 0; i < 20; ++i)
    EXPECT_LT(glm::distance(motion.load({2.0 * i, 40.0 - i}), glm::dvec2(wanted, 0.0)), 1e-9);
  const CanopyMotion none(flow_of(0.2), {0.0, 90.0, 0.0}, blade, 0.6);
  EXPECT_EQ(none.load({3.0, 4.0}), glm::dvec2(0.0));
}

// No steps from cell to cell, whatever the wind.
TEST(CanopyMotion, IsSmoothAndBounded) {
  const CanopyMotion motion(flow_of(0.3), {25.0, 40.0, 1e5}, blade, 0.6);
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 at_m(0.15 * i, 60.0 - 0.1 * i);
    const glm::dvec2 here = leaning_under(glm::dvec2(0.2, 0.1), motion.load(at_m));
    const glm::dvec2 near = leaning_under(glm::dvec2(0.2, 0.1), motion.load(at_m + 0.01));
    EXPECT_LT(glm::distance(here, near), 0.15);
    EXPECT_LT(glm::length(here), 3.5);
  }
}

/// The mean number of waves per metre of honami along a line with the wind, by their power.
double sampled_per_m(const Honami& honami) {
  constexpr std::size_t count = 4096;
  const double step_m = 0.05 * honami.wave_length_m();
  WaveSum sum;
  for (const CanopyWave& wave : honami.waves(east_wind(0.0)))
    sum.add(wave.per_m, wave.phase, wave.height);
  test::Transform values;
  for (std::size_t i = 0; i < count; ++i)
    values.emplace_back(sum.at({static_cast<double>(i) * step_m, 0.0}));
  values = test::windowed(std::move(values));
  double power = 0.0, weighted = 0.0;
  for (std::size_t k = 1; k < count / 2; ++k) {
    power += std::norm(values[k]);
    weighted += std::norm(values[k]) * static_cast<double>(k) / (count * step_m);
  }
  return weighted / power;
}

// Raupach, Finnigan and Brunet 1996: 7 to 10 shear lengths apart.
TEST(Honami, AreAsFarApartAsIsMeasured) {
  const Profile profile(canopy_m);
  double per_m = 0.0;
  constexpr int seeds = 12;
  for (std::uint64_t seed = 0; seed < seeds; ++seed)
    per_m += sampled_per_m(Honami(profile, 0.2, seed)) / seeds;
  const double in_shear_lengths = 1.0 / (per_m * profile.shear_length_m());
  EXPECT_GT(in_shear_lengths, 7.0);
  EXPECT_LT(in_shear_lengths, 10.0);
}

// Finnigan 1979 and Raupach and others 1996: u' at the top is about half of U, and all of it
// together is no more in a wind that is rougher than usual.
TEST(Honami, AreAsHighAsIsMeasured) {
  for (const double intensity : {0.2, 0.3}) {
    double square = 0.0;
    for (const CanopyWave& wave : Honami(Profile(canopy_m), intensity, 1).waves(east_wind(0.0)))
      square += 0.5 * wave.height * wave.height;
    EXPECT_NEAR(std::sqrt(square + intensity * intensity), 0.5, 1e-9);
  }
  EXPECT_EQ(Honami(Profile(canopy_m), 0.0, 1).waves(east_wind(0.0)).front().height, 0.0);
}

/// How a pattern of leaning grass moves: where its picture a little later fits best, m/s.
glm::dvec2 pattern_velocity(const std::function<double(const glm::dvec2&, double)>& value,
                            double later_s, double farthest_m, double step_m) {
  constexpr int samples = 90;
  const auto at = [&](int i, int j) { return glm::dvec2(18.0, 18.0) + glm::dvec2(i, j) * 0.25; };
  std::vector<double> before;
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) before.push_back(value(at(i, j), 0.0));
  double best = -1.0;
  glm::dvec2 found(0.0);
  for (double y = -farthest_m; y <= farthest_m + 1e-9; y += step_m)
    for (double x = -farthest_m; x <= farthest_m + 1e-9; x += step_m) {
      double sum = 0.0, one = 0.0, other = 0.0;
      for (int j = 0; j < samples; j += 2)
        for (int i = 0; i < samples; i += 2) {
          const double a = before[static_cast<std::size_t>(j * samples + i)];
          const double b = value(at(i, j) + glm::dvec2(x, y), later_s);
          sum += a * b;
          one += a * a;
          other += b * b;
        }
      const double correlation = sum / std::sqrt(one * other);
      if (correlation > best) {
        best = correlation;
        found = {x, y};
      }
    }
  return found / later_s;
}

/// Waves of leaning, without their mean, in a wind to the north-east.
glm::dvec2 leaning_waves_travel(const Beam& beam, double intensity, double farthest_m,
                                double step_m) {
  const auto flow = flow_of(intensity, 11);
  constexpr double later_s = 2.0 / 24.0;
  const auto at_time = [&](double t) {
    return CanopyMotion(flow, {speed_m_s, 45.0, speed_m_s * t}, beam, 0.3);
  };
  const CanopyMotion now = at_time(0.0), later = at_time(later_s);
  const double mean =
      steady_deflection(beam, flow->profile(), speed_m_s * flow->profile().at_top());
  return pattern_velocity(
      [&](const glm::dvec2& at_m, double t) {
        return glm::length((t == 0.0 ? now : later).load(at_m)) - mean;
      },
      later_s, farthest_m, step_m);
}

void expect_north_east(const glm::dvec2& velocity) {
  EXPECT_NEAR(std::atan2(velocity.x, velocity.y) * 180.0 / std::numbers::pi, 45.0, 10.0);
}

TEST(CanopyMotion, HonamiTravelAtTheirOwnSpeed) {
  const glm::dvec2 velocity = leaning_waves_travel(stiff, 0.16, 0.3, 0.02);
  expect_north_east(velocity);
  EXPECT_NEAR(glm::length(velocity) / (1.8 * speed_m_s * Profile(canopy_m).at_top()), 1.0, 0.2);
}

// From half of the mean wind on there are no waves of the canopy's own beside them.
TEST(CanopyMotion, GustsTravelWithTheWind) {
  const glm::dvec2 velocity = leaning_waves_travel(blade, 0.5, 0.9, 0.05);
  expect_north_east(velocity);
  EXPECT_NEAR(glm::length(velocity) / speed_m_s, 1.0, 0.2);
}

// In a wind with little waves the load is nearly linear in them: a cell's is the mean over it.
TEST(CanopyMotion, OfACellIsTheMeanOverIt) {
  const auto flow = flow_of(0.02);
  constexpr double cell_m = 1.2;
  const CanopyMotion blades(flow, east_wind(0.0), stiff, 0.0);
  const CanopyMotion cells(flow, east_wind(0.0), stiff, cell_m);
  const double mean =
      steady_deflection(stiff, flow->profile(), speed_m_s * flow->profile().at_top());
  double blade_squares = 0.0, differences = 0.0;
  for (int k = 0; k < 40; ++k) {
    const glm::dvec2 middle_m(5.0 + 1.1 * k, 50.0 - 0.9 * k);
    glm::dvec2 sum(0.0);
    constexpr int steps = 12;
    for (int j = 0; j < steps; ++j)
      for (int i = 0; i < steps; ++i)
        sum += blades.load(middle_m + ((glm::dvec2(i, j) + 0.5) / double{steps} - 0.5) * cell_m) /
               double{steps * steps};
    const double one = blades.load(middle_m).x - mean;
    blade_squares += one * one;
    differences += (sum.x - cells.load(middle_m).x) * (sum.x - cells.load(middle_m).x);
  }
  EXPECT_LT(std::sqrt(differences / blade_squares), 0.1);
}

TEST(AirFlow, HasTheMeanOfItsProfileOverLevelGround) {
  const auto flow = flow_of(0.0);
  for (const double height_m : {0.1, 0.4, 2.0, 10.0}) {
    const glm::dvec3 velocity = flow->velocity_m_s({20.0, 20.0}, height_m, east_wind(1.0));
    EXPECT_LT(glm::distance(velocity, glm::dvec3(speed_m_s * flow->profile().at(height_m), 0, 0)),
              1e-9);
  }
}

TEST(AirFlow, HasTheIntensityThatIsAskedForAtAnyHeight) {
  for (const double height_m : {2.0, 10.0}) {
    double squares = 0.0;
    constexpr int seeds = 60;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const auto flow = flow_of(0.2, seed);
      for (int i = 0; i < 4; ++i) {
        const double mean = speed_m_s * flow->profile().at(height_m);
        const double gust =
            flow->velocity_m_s({20.0, 10.0 * i}, height_m, east_wind(700.0 * i)).x / mean - 1.0;
        squares += gust * gust / (4.0 * seeds);
      }
    }
    EXPECT_NEAR(std::sqrt(squares), 0.2, 0.03) << height_m;
  }
}

}  // namespace
}  // namespace wold::wind
