#include "grass/optics/leaf_optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "grass/ageing/model_table.h"
#include "grass/optics/pigments.h"
#include "support/places.h"

namespace wold::grass {
namespace {

std::size_t index_of(const std::vector<double>& values, double value) {
  const auto found = std::find(values.begin(), values.end(), value);
  EXPECT_NE(found, values.end());
  return static_cast<std::size_t>(found - values.begin());
}

/// The leaves, colours and spectra of prospect_vectors.toml.
class Prospect : public testing::Test {
 protected:
  LeafContent leaf(std::size_t i) const {
    const auto of = [&](const char* name) { return vectors_.column(name)[i]; };
    return {of("structure"), of("chlorophyll_ug_cm2"), of("carotenoid_ug_cm2"),
            of("brown"),     of("water_cm"),           of("dry_g_cm2")};
  }
  std::size_t leaves() const { return vectors_.column("structure").size(); }
  glm::dvec3 rgb(const char* name, std::size_t i) const {
    const std::vector<double>& values = vectors_.column(name, 3 * leaves());
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  }

  const ModelTable vectors_{wold::test::tests_folder() / "grass/prospect_vectors.toml"};
  const LeafOptics optics_{load_leaf_spectra()};
};

TEST(LeafOptics, ExponentialIntegralIsTheTabulatedOne) {
  // Abramowitz and Stegun 1964, table 5.1.
  EXPECT_NEAR(exponential_integral(0.5), 0.559773594776, 1e-12);
  EXPECT_NEAR(exponential_integral(1.0), 0.219383934396, 1e-12);
  EXPECT_NEAR(exponential_integral(2.0), 0.048900510708, 1e-12);
}

TEST(LeafOptics, SurfaceTransmittanceAgreesWithFresnel) {
  EXPECT_NEAR(surface_transmittance(40.0, 1.5), 0.958424036, 1e-9);
  EXPECT_NEAR(surface_transmittance(90.0, 1.5), 0.908222041, 1e-9);
  // A narrow cone meets the surface head on: 1 - ((n - 1) / (n + 1))^2.
  EXPECT_NEAR(surface_transmittance(1.0, 1.5), 0.96, 1e-5);
}

TEST_F(Prospect, AgreesWithAnIndependentImplementation) {
  const std::vector<double>& wavelengths = vectors_.column("wavelength_nm");
  const std::size_t count = leaves() * wavelengths.size();
  ASSERT_EQ(count, 96U);
  const std::vector<double>& reflectance = vectors_.column("reflectance", count);
  const std::vector<double>& transmittance = vectors_.column("transmittance", count);
  for (std::size_t i = 0; i < count; ++i) {
    const LeafSpectrum got = optics_(leaf(i / wavelengths.size()));
    const std::size_t at =
        index_of(optics_.spectra().wavelength_nm, wavelengths[i % wavelengths.size()]);
    EXPECT_NEAR(got.reflectance[at], reflectance[i], 1e-6) << "row " << i;
    EXPECT_NEAR(got.transmittance[at], transmittance[i], 1e-6) << "row " << i;
  }
}

TEST_F(Prospect, GivesTheColoursOfTheSpectra) {
  const Observer observer = load_observer(400.0, 780.0);
  for (std::size_t i = 0; i < leaves(); ++i) {
    const LeafSpectrum got = optics_(leaf(i));
    const glm::dvec3 reflected = observer.linear_srgb(got.reflectance);
    const glm::dvec3 albedo = reflected + observer.linear_srgb(got.transmittance);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(reflected[k], rgb("reflectance_rgb", i)[k], 2e-3) << "leaf " << i;
      EXPECT_NEAR(albedo[k], rgb("albedo_rgb", i)[k], 2e-3) << "leaf " << i;
    }
  }
}

TEST_F(Prospect, NeverGivesMoreLightThanCame) {
  for (const double structure : {1.0, 1.5, 3.0})
    for (const double chlorophyll : {0.0, 1.0, 40.0, 100.0}) {
      const LeafSpectrum got =
          optics_({structure, chlorophyll, 0.2 * chlorophyll, 0.0, 0.01, 1e-3});
      for (std::size_t i = 0; i < got.reflectance.size(); ++i) {
        EXPECT_GT(got.reflectance[i], 0.0);
        EXPECT_GT(got.transmittance[i], 0.0);
        EXPECT_LE(got.reflectance[i] + got.transmittance[i], 1.0);
      }
    }
}

TEST_F(Prospect, AClearLeafLosesNothing) {
  const LeafSpectrum got = optics_({2.5, 0.0, 0.0, 0.0, 0.0, 0.0});
  for (std::size_t i = 0; i < got.reflectance.size(); ++i)
    EXPECT_NEAR(got.reflectance[i] + got.transmittance[i], 1.0, 1e-12);
}

TEST_F(Prospect, ChlorophyllDarkensTheGreenPeak) {
  const std::size_t green = index_of(optics_.spectra().wavelength_nm, 550.0);
  double before = 1.0;
  for (double chlorophyll = 0.0; chlorophyll <= 100.0; chlorophyll += 5.0) {
    const double now = optics_({1.5, chlorophyll, 5.0, 0.0, 0.012, 0.005}).reflectance[green];
    EXPECT_LT(now, before);
    before = now;
  }
}

}  // namespace
}  // namespace wold::grass
