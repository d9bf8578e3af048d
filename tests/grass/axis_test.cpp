#include "grass/geometry/axis.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "small_meadow.h"

namespace wold::grass {
namespace {

using test::degree;

BladePose drooping(float droop) {
  BladePose pose;
  pose.droop = droop;
  return pose;
}

Blade leaning(double lean_deg) {
  Blade blade = test::straight_blade();
  blade.lean = static_cast<float>(lean_deg * degree);
  blade.length_m = 0.3F;
  return blade;
}

BladePose loaded(float load) {
  BladePose pose;
  pose.rule = DroopRule::elastica;
  pose.load = load;
  return pose;
}

double polyline_m(const Blade& blade, const BladePose& pose) {
  const BladeAxis axis(blade, pose);
  constexpr int pieces = 1000;
  double length = 0.0;
  glm::dvec2 from(0.0);
  for (int i = 1; i <= pieces; ++i) {
    const float arc = blade.length_m * static_cast<float>(i) / pieces;
    const glm::dvec2 to(axis.at(arc).position_m);
    length += glm::distance(from, to);
    from = to;
  }
  return length;
}

// Paper 1, section 3.1: v = omega sqrt(h) l, so on a straight blade v ~ h^1.5.
TEST(PaperAxis, DroopStartsWithThePapersSpeeds) {
  const Blade blade = leaning(0.0);
  const float droop = 0.02F;
  const auto speed = [&](float arc) {
    const glm::dvec2 moved = BladeAxis(blade, drooping(droop)).at(arc).position_m -
                             BladeAxis(blade, drooping(0.0F)).at(arc).position_m;
    return glm::length(moved) / double{droop};
  };
  EXPECT_NEAR(speed(0.1F), std::pow(0.1, 1.5), 1e-3 * std::pow(0.1, 1.5));
  EXPECT_NEAR(speed(0.2F) / speed(0.1F), std::pow(2.0, 1.5), 5e-3);
}

TEST(BladeAxis, KeepsItsLengthHoweverFarItDroops) {
  for (double lean_deg : {0.0, 14.0, 70.0})
    for (float droop : {0.0F, 0.01F, 0.5F, 1.0F, 3.0F, 8.0F}) {
      const Blade blade = leaning(lean_deg);
      EXPECT_NEAR(polyline_m(blade, drooping(droop)) / double{blade.length_m}, 1.0, 1e-3)
          << "lean " << lean_deg << ", droop " << droop;
    }
}

TEST(PaperAxis, TipTurnsMoreThanBaseAndNothingSinksIntoTheGround) {
  const Blade blade = leaning(10.0);
  for (float droop : {0.3F, 2.0F, 6.0F}) {
    double angle = double{blade.lean};
    for (int i = 1; i <= 50; ++i) {
      const AxisPoint at =
          BladeAxis(blade, drooping(droop)).at(blade.length_m * static_cast<float>(i) / 50.0F);
      const double now = std::atan2(double{at.position_m.x}, double{at.position_m.y});
      EXPECT_GE(at.position_m.y, 0.0F);
      EXPECT_LE(now, 90.0 * degree + 1e-6);
      if (at.position_m.y > 0.0F) {
        EXPECT_GT(now, angle);
      }
      EXPECT_NEAR(glm::length(at.tangent), 1.0F, 1e-6);
      angle = now;
    }
  }
}

TEST(BladeAxis, TangentIsTheDirectionOfTheAxis) {
  const Blade blade = leaning(14.0);
  for (float arc : {0.05F, 0.15F, 0.25F}) {
    constexpr float step = 1e-3F;
    for (const BladePose& pose : {drooping(1.5F), loaded(6.0F)}) {
      const BladeAxis axis(blade, pose);
      const glm::vec2 along =
          glm::normalize(axis.at(arc + step).position_m - axis.at(arc - step).position_m);
      EXPECT_GT(glm::dot(along, axis.at(arc).tangent), 1.0F - 1e-4F);
    }
  }
}

TEST(ElasticaAxis, KeepsItsLengthAndLiesOnTheGroundWhereItMeetsIt) {
  for (double lean_deg : {0.0, 14.0, 80.0})
    for (float load : {0.0F, 1.0F, 6.0F, 25.0F, 200.0F}) {
      const Blade blade = leaning(lean_deg);
      SCOPED_TRACE(testing::Message() << lean_deg << " deg, load " << load);
      EXPECT_NEAR(polyline_m(blade, loaded(load)) / double{blade.length_m}, 1.0, 1e-3);
      const BladeAxis axis(blade, loaded(load));
      bool down = false;
      for (int i = 1; i <= 500; ++i) {
        const AxisPoint at = axis.at(blade.length_m * static_cast<float>(i) / 500.0F);
        ASSERT_GE(at.position_m.y, 0.0F);
        ASSERT_TRUE(!down || at.position_m.y == 0.0F) << "stands up again at " << i;
        down = at.position_m.y == 0.0F;
        ASSERT_NEAR(glm::length(at.tangent), 1.0F, 1e-5F);
      }
      EXPECT_EQ(down, load >= 25.0F || (lean_deg == 80.0 && load >= 6.0F));
    }
}

/// The paper's rule beside the elastica, for blades of length 1.
class PaperAgainstTheory {
 public:
  PaperAgainstTheory(double lean_deg, double load)
      : lean_(lean_deg * degree), theory_(heavy_elastica(lean_, load)) {}

  /// How far the tip has moved from that of the straight blade, by the elastica and by the paper.
  double way() const { return glm::distance(theory_.back().place, straight(1.0)); }
  double way(double droop) const { return glm::distance(paper(droop, 1.0), straight(1.0)); }
  /// The droop for which both are the same.
  double fitted_droop() const {
    double low = 0.0, high = 3.0;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (way(middle) < way() ? low : high) = middle;
    }
    return high;
  }
  /// The largest distance between points at the same arc length.
  double departure(double droop) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < theory_.size(); ++i)
      largest = std::max(largest,
                         glm::distance(theory_[i].place,
                                       paper(droop, static_cast<double>(i) / elastica_segments)));
    return largest;
  }
  /// The turn of the paper's tip over that of the elastica.
  double turns(double droop) const {
    const glm::vec2 tip = axis(droop).at(1.0F).tangent;
    return (std::atan2(double{tip.x}, double{tip.y}) - lean_) / (theory_.back().angle - lean_);
  }

 private:
  PaperAxis axis(double droop) const {
    return {static_cast<float>(lean_), static_cast<float>(droop)};
  }
  glm::dvec2 paper(double droop, double arc) const {
    return axis(droop).at(static_cast<float>(arc)).position_m;
  }
  glm::dvec2 straight(double arc) const {
    return arc * glm::dvec2(std::sin(lean_), std::cos(lean_));
  }

  double lean_;
  Elastica theory_;
};

// The numbers that axis.h states.
TEST(PaperAxis, TipsOfStiffBladesFollowTheElastica) {
  const auto droop_of = [](double lean_deg, double load) {
    const double lean = lean_deg * degree;
    return load * std::sin(lean) / 8.0 / (1.0 - load * std::cos(lean) / 7.8373);
  };
  int compared = 0;
  for (double lean_deg : {5.0, 10.0, 20.0, 45.0, 70.0})
    for (double load : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0}) {
      const PaperAgainstTheory pair(lean_deg, load);
      if (pair.way() > 0.16) continue;
      ++compared;
      EXPECT_NEAR(pair.way(droop_of(lean_deg, load)) / pair.way(), 1.0, 0.02)
          << lean_deg << " deg, load " << load;
    }
  EXPECT_GE(compared, 18);
  // Beyond, the formula leaves the elastica.
  const PaperAgainstTheory limp(20.0, 5.0);
  EXPECT_GT(limp.way(droop_of(20.0, 5.0)) / limp.way(), 1.15);
}

TEST(PaperAxis, ShapesDepartFromTheElasticaAsBladesTurn) {
  for (double lean_deg : {10.0, 20.0}) {
    SCOPED_TRACE(lean_deg);
    const auto departure = [&](double load) {
      const PaperAgainstTheory pair(lean_deg, load);
      const double droop = pair.fitted_droop();
      EXPECT_NEAR(pair.way(droop), pair.way(), 1e-3 * pair.way());
      return pair.departure(droop) / pair.way();
    };
    EXPECT_NEAR(departure(0.5), 0.020, 0.001);
    EXPECT_NEAR(departure(5.0), 0.0275, 0.0015);
    EXPECT_NEAR(departure(10.0), 0.034, 0.002);
    const PaperAgainstTheory stiff(lean_deg, 0.5);
    EXPECT_NEAR(stiff.turns(stiff.fitted_droop()), 9.0 / 8.0, 0.005);
  }
}

// A blade of twice the length turns its tip sqrt(2) times as far by the paper's rule, 8 times by
// theory.
TEST(PaperAxis, LongBladesDroopLessThanInTheory) {
  const double lean = 14.0 * degree;
  const auto turn = [&](float length_m) {
    const glm::vec2 tip = PaperAxis(static_cast<float>(lean), 0.01F).at(length_m).position_m;
    return std::atan2(double{tip.x}, double{tip.y}) - lean;
  };
  EXPECT_NEAR(turn(0.4F) / turn(0.2F), std::sqrt(2.0), 0.01);
  const auto theory = [&](double load) { return heavy_elastica(lean, load).back().angle - lean; };
  EXPECT_NEAR(theory(0.08) / theory(0.01), 8.0, 0.1);
}

}  // namespace
}  // namespace wold::grass
