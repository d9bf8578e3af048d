#include "grass/mechanics/elastica.h"

#include <gtest/gtest.h>

#include "grass/ageing/model_table.h"
#include "small_meadow.h"
#include "support/places.h"

namespace wold::grass {
namespace {

using test::degree;

constexpr double greenhill = 7.8373;

double tip_angle(const Elastica& nodes) { return nodes.back().angle; }

/// From the first three nodes' angles, per length.
double root_curvature(const Elastica& nodes) {
  return 0.5 * elastica_segments * (4.0 * nodes[1].angle - 3.0 * nodes[0].angle - nodes[2].angle);
}

constexpr double loads[] = {0.0, 0.1, 1.0, 3.0, 7.0, 7.8, 7.9, 9.0, 15.0, 40.0, 150.0, 999.0};

TEST(Elastica, AgreesWithAnIndependentIntegration) {
  const ModelTable vectors(wold::test::tests_folder() / "grass/elastica_vectors.toml");
  const std::size_t count = vectors.column("load").size();
  ASSERT_EQ(count, 45U);
  const auto of = [&](const char* name, std::size_t i) { return vectors.column(name, count)[i]; };
  for (std::size_t i = 0; i < count; ++i) {
    const Elastica nodes = heavy_elastica(of("lean_deg", i) * degree, of("load", i));
    SCOPED_TRACE(testing::Message() << "lean " << of("lean_deg", i) << ", load " << of("load", i));
    EXPECT_NEAR(tip_angle(nodes) / degree / of("tip_angle_deg", i), 1.0, 0.003);
    EXPECT_NEAR(nodes.back().place.x, of("tip_along", i), 0.003);
    EXPECT_NEAR(nodes.back().place.y, of("tip_up", i), 0.003);
    EXPECT_NEAR(root_curvature(nodes) / of("root_curvature", i), 1.0, 0.01);
  }
}

TEST(Elastica, SagsFromAHorizontalClampByAnEighthOfTheLoad) {
  for (double load : {0.001, 0.01, 0.1})
    EXPECT_NEAR(heavy_elastica(90.0 * degree, load).back().place.y / (-load / 8.0), 1.0, 0.005);
}

// Greenhill 1881. Beyond his load B' the buckled column rises as sqrt(B - B').
TEST(Elastica, UprightBladesBuckleAtGreenhillsLoad) {
  for (double load : {0.0, 1.0, 5.0, 0.97 * greenhill})
    EXPECT_LT(tip_angle(heavy_elastica(0.0, load)), 0.5 * degree) << load;
  const double just_above = tip_angle(heavy_elastica(0.0, 1.02 * greenhill));
  const double above = tip_angle(heavy_elastica(0.0, 1.08 * greenhill));
  EXPECT_GT(just_above, 15.0 * degree);
  EXPECT_NEAR(above / just_above, 2.0, 0.1);
}

TEST(Elastica, KeepsItsLengthAndBendsOneWay) {
  for (double lean_deg : {0.0, 10.0, 45.0, 80.0})
    for (double load : loads) {
      const Elastica nodes = heavy_elastica(lean_deg * degree, load);
      double length = 0.0;
      for (std::size_t i = 1; i < nodes.size(); ++i) {
        length += glm::distance(nodes[i].place, nodes[i - 1].place);
        ASSERT_GE(nodes[i].angle, nodes[i - 1].angle - 1e-12) << lean_deg << " deg, load " << load;
      }
      EXPECT_NEAR(length, 1.0, 1e-12);
      EXPECT_NEAR(nodes[0].angle, lean_deg * degree, 1e-3 * degree + 1e-4);
      EXPECT_LT(tip_angle(nodes), 180.0 * degree);
    }
}

TEST(Elastica, SinksMonotonelyAndSteadilyWithItsLoad) {
  for (double lean_deg : {0.0, 0.5, 14.0, 80.0}) {
    double last = 0.0;
    for (double load = 0.0; load < 60.0; load += 0.02) {
      const double angle = tip_angle(heavy_elastica(lean_deg * degree, load));
      ASSERT_GE(angle, last - 1e-6) << lean_deg << " deg, load " << load;
      // The upright column's steepest step is at its buckling: sqrt(0.02) times its slope there.
      if (load > 0.0) {
        ASSERT_LT(angle - last, (lean_deg == 0.0 ? 12.0 : 3.0) * degree)
            << lean_deg << ", " << load;
      }
      last = angle;
    }
  }
}

// The hinge chain's balance of moments: what the nodes' curvature bears at the root is the weight
// times its lever, the centre of mass.
TEST(Elastica, TheClampBearsTheWholeWeight) {
  for (double load : {0.5, 5.0, 20.0}) {
    const Elastica nodes = heavy_elastica(30.0 * degree, load);
    double lever = 0.0;
    for (std::size_t i = 1; i < nodes.size(); ++i)
      lever += 0.5 * (nodes[i].place.x + nodes[i - 1].place.x) / elastica_segments;
    EXPECT_NEAR(root_curvature(nodes) / (load * lever), 1.0, 0.005) << load;
  }
}

TEST(Elastica, LargestLoadsStayHairpins) {
  const Elastica nodes = heavy_elastica(14.0 * degree, 1e9);
  double highest = 0.0;
  for (const ElasticaNode& node : nodes) highest = std::max(highest, node.place.y);
  EXPECT_GT(highest, 0.0);
  EXPECT_LT(highest, 0.02);
  EXPECT_GT(tip_angle(nodes), 179.9 * degree);
}

}  // namespace
}  // namespace wold::grass
