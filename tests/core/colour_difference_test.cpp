#include "core/colour_difference.h"

#include <gtest/gtest.h>

namespace wold {
namespace {

TEST(ColourDifference, AgreesWithThePublishedPairs) {
  struct Pair {
    glm::dvec3 one, other;
    double difference;
  };
  // Sharma, Wu and Dalal 2005, table 1.
  for (const Pair& pair : {Pair{{50.0, 2.6772, -79.7751}, {50.0, 0.0, -82.7485}, 2.0425},
                           Pair{{50.0, 2.8361, -74.0200}, {50.0, 0.0, -82.7485}, 3.4412},
                           Pair{{50.0, -1.3802, -84.2814}, {50.0, 0.0, -82.7485}, 1.0000},
                           Pair{{50.0, 0.0, 0.0}, {50.0, -1.0, 2.0}, 2.3669},
                           Pair{{50.0, 2.4900, -0.0010}, {50.0, -2.4900, 0.0009}, 7.1792},
                           Pair{{50.0, 2.4900, -0.0010}, {50.0, -2.4900, 0.0011}, 7.2195},
                           Pair{{50.0, 2.5, 0.0}, {73.0, 25.0, -18.0}, 27.1492},
                           Pair{{50.0, 2.5, 0.0}, {61.0, -5.0, 29.0}, 22.8977},
                           Pair{{50.0, 2.5, 0.0}, {56.0, -27.0, -3.0}, 31.9030},
                           Pair{{50.0, 2.5, 0.0}, {58.0, 24.0, 15.0}, 19.4535},
                           Pair{{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                           Pair{{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
                           Pair{{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                           Pair{{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}}) {
    EXPECT_NEAR(colour_difference(pair.one, pair.other), pair.difference, 5e-5);
    EXPECT_NEAR(colour_difference(pair.other, pair.one), pair.difference, 5e-5);
  }
}

}  // namespace
}  // namespace wold
