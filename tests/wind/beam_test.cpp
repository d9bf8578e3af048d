#include "wind/beam.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "wind/streamlining.h"

namespace wold::wind {
namespace {

constexpr Beam blade = {0.32, 0.0056, 9e-4, 5.6e-5};

/// The deflection of a clamped beam, of length and E I 1, under a load per length at the middles of
/// `load.size()` pieces: by influence, x^2 (3 a - x) / 6 for a force at a beyond x.
std::vector<double> deflection(const std::vector<double>& load) {
  const auto count = static_cast<double>(load.size());
  std::vector<double> result(load.size(), 0.0);
  for (std::size_t i = 0; i < load.size(); ++i)
    for (std::size_t j = 0; j < load.size(); ++j) {
      const double x = (static_cast<double>(std::min(i, j)) + 0.5) / count;
      const double a = (static_cast<double>(std::max(i, j)) + 0.5) / count;
      result[i] += load[j] / count * x * x * (3.0 * a - x) / 6.0;
    }
  return result;
}

// The slowest vibration of the beam, by power iteration on influences: no mode shape is put in.
TEST(Beam, VibratesAsBeamTheoryHasIt) {
  std::vector<double> shape(200, 1.0);
  double square = 0.0;
  for (int step = 0; step < 30; ++step) {
    shape = deflection(shape);
    square = 1.0 / shape.back();
    for (double& value : shape) value *= square;
  }
  const double wanted = std::sqrt(square) / (2.0 * std::numbers::pi) *
                        std::sqrt(blade.stiffness_n_m2 / (blade.mass_kg_m * std::pow(0.32, 4.0)));
  EXPECT_NEAR(natural_frequency_hz(blade) / wanted, 1.0, 0.02);
  EXPECT_NEAR(natural_frequency_hz(blade), 3.516 / (2.0 * std::numbers::pi) * 2.436, 0.02);
  for (std::size_t i = 0; i < shape.size(); i += 20)
    EXPECT_NEAR(first_mode((static_cast<double>(i) + 0.5) / 200.0), shape[i], 0.01);
}

TEST(Beam, BendsUnderASteadyWindAsUnderItsDrag) {
  const Profile profile(blade.length_m);
  constexpr double top_m_s = 1.3;
  std::vector<double> load;
  for (int i = 0; i < 200; ++i) {
    const double u = profile.at((i + 0.5) / 200.0 * blade.length_m) / profile.at_top() * top_m_s;
    load.push_back(0.5 * 1.2 * blade.width_m * u * u);
  }
  const double wanted =
      deflection(load).back() * std::pow(blade.length_m, 3.0) / blade.stiffness_n_m2;
  EXPECT_NEAR(steady_deflection(blade, profile, top_m_s) / wanted, 1.0, 0.05);
}

TEST(Beam, HeavierOnesAreSlowerAndAirDampsThem) {
  const Profile profile(blade.length_m);
  Beam snowy = blade;
  snowy.mass_kg_m *= 4.0;
  EXPECT_NEAR(natural_frequency_hz(snowy), 0.5 * natural_frequency_hz(blade), 1e-9);
  EXPECT_NEAR(damping_ratio(blade, profile, 0.0), 0.1, 1e-12);
  EXPECT_GT(damping_ratio(blade, profile, 1.0), 0.2);
  EXPECT_NEAR(steady_deflection(snowy, profile, 1.0), steady_deflection(blade, profile, 1.0),
              1e-12);
}

TEST(Answer, IsThatOfADampedOscillator) {
  EXPECT_NEAR(std::abs(answer(0.0, 2.0, 0.1)), 1.0, 1e-12);
  EXPECT_NEAR(std::abs(answer(2.0, 2.0, 0.1)), 5.0, 1e-9);
  EXPECT_NEAR(std::arg(answer(2.0, 2.0, 0.1)), -0.5 * std::numbers::pi, 1e-9);
  EXPECT_NEAR(std::abs(answer(20.0, 2.0, 0.1)), 1.0 / 99.0, 1e-4);
}

TEST(Streamlining, IsItsOwnInverseAndNeverLiesFlat) {
  for (const double load : {0.0, 1e-3, 0.3, 1.0, 5.0, 100.0}) {
    const double leaning = leaning_rad(load);
    EXPECT_NEAR(leaning, load * std::cos(leaning) * std::cos(leaning), 1e-6 * (1.0 + load));
    EXPECT_LT(leaning, 0.5 * std::numbers::pi);
    EXPECT_NEAR(load_of(leaning), load, 1e-5 * (1.0 + load));
  }
}

TEST(Streamlining, LoadsAddUpAndNoneChangesNothing) {
  const glm::dvec2 lean(0.21, -0.34);
  EXPECT_LT(glm::distance(leaning_under(lean, glm::dvec2(0.0)), lean), 1e-9);
  EXPECT_EQ(leaning_under(glm::dvec2(0.0), glm::dvec2(0.0)), glm::dvec2(0.0));
  const glm::dvec2 once = leaning_under(glm::dvec2(0.0), {0.3, 0.1});
  const glm::dvec2 twice = leaning_under(once, {0.2, 0.5});
  EXPECT_LT(glm::distance(twice, leaning_under(glm::dvec2(0.0), {0.5, 0.6})), 1e-6);
}

}  // namespace
}  // namespace wold::wind
