#include "core/elementary.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/random.h"

namespace wold {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance of a result from the true value, in units of its last place.
double error_ulp(double got, long double want) {
  const auto rounded = static_cast<double>(want);
  if (got == rounded || (std::isnan(got) && std::isnan(want))) return 0.0;
  const int exponent = std::max(std::ilogb(rounded) - 52, -1074);
  return static_cast<double>(std::abs(static_cast<long double>(got) - want) /
                             std::ldexp(1.0L, exponent));
}

struct Interval {
  double low;
  double high;
};

using Function = double (*)(double);
/// The C library's, of more digits than a double has.
using Reference = long double (*)(long double);

struct Case {
  std::string name;
  Function function;
  Reference reference;
  std::vector<Interval> intervals;
  double limit_ulp = 1.0;
};

std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }

class Elementary : public testing::TestWithParam<Case> {};

TEST_P(Elementary, IsWithinItsLastPlace) {
  const Case& one = GetParam();
  for (const Interval& interval : one.intervals)
    for (std::uint64_t i = 0; i < 20000; ++i) {
      const double fraction = random_uniform({1, key_of(one.name), i, key_of("argument")});
      const double x = interval.low + fraction * (interval.high - interval.low);
      ASSERT_LT(error_ulp(one.function(x), one.reference(x)), one.limit_ulp)
          << one.name << "(" << x << ")";
    }
}

/// As C99, Annex F, has them: signs of zeros, infinities, what is not a number.
TEST_P(Elementary, HasTheSpecialValuesOfTheStandard) {
  const Case& one = GetParam();
  for (const double x : {0.0, -0.0, 1.0, -1.0, infinity, -infinity, 1e308, -1e308, 5e-324, -5e-324,
                         std::numeric_limits<double>::quiet_NaN()}) {
    const auto want = static_cast<double>(one.reference(x));
    const double got = one.function(x);
    if (std::isnan(want)) {
      EXPECT_TRUE(std::isnan(got)) << one.name << "(" << x << ")";
    } else if (want == 0.0 || std::isinf(want)) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(got), std::bit_cast<std::uint64_t>(want))
          << one.name << "(" << x << "): " << got;
    } else {
      EXPECT_LT(error_ulp(got, one.reference(x)), one.limit_ulp) << one.name << "(" << x << ")";
    }
  }
}

#define WOLD_CASE(name, ...)                                                   \
  Case {                                                                       \
#name, math::name, [](long double x) { return std::name(x); }, __VA_ARGS__ \
  }

INSTANTIATE_TEST_SUITE_P(
    All, Elementary,
    testing::Values(WOLD_CASE(exp, {{-1, 1}, {-700, 709}}),
                    WOLD_CASE(exp2, {{-1, 1}, {-1020, 1023}}),
                    WOLD_CASE(expm1, {{-0.02, 0.02}, {-1, 1}, {-45, 700}}),
                    WOLD_CASE(tanh, {{-0.02, 0.02}, {-3, 3}, {-30, 30}}),
                    WOLD_CASE(log, {{0.9, 1.1}, {0, 10}, {0, 1e300}, {0, 1e-300}}),
                    WOLD_CASE(log2, {{0.9, 1.1}, {0, 10}, {0, 1e300}}),
                    WOLD_CASE(log10, {{0.9, 1.1}, {0, 10}, {0, 1e300}}),
                    WOLD_CASE(log1p, {{-0.01, 0.01}, {-0.999, 10}, {0, 1e300}}),
                    WOLD_CASE(asinh, {{-2, 2}, {-1e5, 1e5}, {-1e300, 1e300}}, 2.0),
                    WOLD_CASE(sin, {{-0.8, 0.8}, {-10, 10}, {-1e5, 1e5}, {-1e9, 1e9}, {0, 1e300}}),
                    WOLD_CASE(cos, {{-0.8, 0.8}, {-10, 10}, {-1e5, 1e5}, {-1e9, 1e9}, {0, 1e300}}),
                    WOLD_CASE(tan, {{-0.8, 0.8}, {-10, 10}, {-1e5, 1e5}, {-1e9, 1e9}, {0, 1e300}}),
                    WOLD_CASE(asin, {{-1, 1}, {0.99, 1}, {-1e-8, 1e-8}}),
                    WOLD_CASE(acos, {{-1, 1}, {0.999, 1}, {-1, -0.999}}),
                    WOLD_CASE(atan, {{-0.1, 0.1}, {-1, 1}, {-20, 20}, {0, 1e20}}),
                    WOLD_CASE(cbrt, {{-10, 10}, {0, 1e300}, {0, 1e-300}}),
                    WOLD_CASE(erfc, {{-8, -0.5}, {-0.5, 0.5}, {0.5, 3}, {3, 26}}, 8.0)),
    [](const auto& of) { return of.param.name; });

#undef WOLD_CASE

/// Uniform from -1 to 1.
double spread(const char* what, std::uint64_t i) {
  return 2.0 * random_uniform({2, key_of(what), i, key_of("argument")}) - 1.0;
}

TEST(ElementaryOfTwo, AreWithinTheirLastPlace) {
  for (std::uint64_t i = 0; i < 50000; ++i) {
    const double base = std::exp(20.0 * spread("base", i));
    const double exponent = 30.0 * spread("exponent", i);
    ASSERT_LT(error_ulp(math::pow(base, exponent), std::pow(static_cast<long double>(base),
                                                            static_cast<long double>(exponent))),
              1.0)
        << base << " " << exponent;
    const double x = spread("x", i) * std::exp(10.0 * spread("scale", i));
    const double y = spread("y", i);
    ASSERT_LT(error_ulp(math::atan2(y, x),
                        std::atan2(static_cast<long double>(y), static_cast<long double>(x))),
              1.0)
        << y << " " << x;
    ASSERT_LT(error_ulp(math::hypot(x, y),
                        std::hypot(static_cast<long double>(x), static_cast<long double>(y))),
              1.0)
        << x << " " << y;
  }
}

TEST(ElementaryOfTwo, HaveTheSpecialValuesOfTheStandard) {
  const auto same = [](double got, double want) {
    return std::isnan(want) ? std::isnan(got)
                            : std::signbit(got) == std::signbit(want) && error_ulp(got, want) < 2.0;
  };
  const std::vector<double> values = {
      0.0,    -0.0,     1.0,       -1.0,
      2.0,    -2.0,     0.5,       3.0,
      -3.0,   infinity, -infinity, 1e308,
      -1e308, 1e-310,   5e-324,    std::numeric_limits<double>::quiet_NaN()};
  for (const double a : values)
    for (const double b : values) {
      EXPECT_TRUE(same(math::pow(a, b), std::pow(a, b))) << a << "^" << b << " " << math::pow(a, b);
      EXPECT_TRUE(same(math::atan2(a, b), std::atan2(a, b))) << "atan2 " << a << " " << b;
      EXPECT_TRUE(same(math::hypot(a, b), std::hypot(a, b))) << "hypot " << a << " " << b;
    }
}

TEST(ElementaryOfFloats, AreThoseOfDoublesRounded) {
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const auto x = static_cast<float>(1000.0 * spread("float", i));
    ASSERT_LT(std::abs(math::sin(x) - std::sin(double{x})), 0.501 * 0x1p-24) << x;
    ASSERT_LT(std::abs(math::cos(x) - std::cos(double{x})), 0.501 * 0x1p-24) << x;
    const float base = std::abs(x);
    ASSERT_LT(std::abs(math::pow(base, 0.41666F) / std::pow(double{base}, double{0.41666F}) - 1.0),
              0x1.01p-24)
        << base;
  }
}

/// Results of the compilers and systems that this was tried on: the same bits everywhere.
TEST(ElementaryFunctions, HaveTheSameBitsEverywhere) {
  std::uint64_t bits = 0;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double x = 8.0 * spread("bits", i);
    const double size = std::abs(x);
    for (const double value : {math::exp(x),
                               math::exp2(x),
                               math::expm1(x),
                               math::tanh(x),
                               math::log(size),
                               math::log2(size),
                               math::log10(size),
                               math::log1p(size),
                               math::asinh(x),
                               math::sin(x),
                               math::cos(x),
                               math::tan(x),
                               math::asin(x / 8.0),
                               math::acos(x / 8.0),
                               math::atan(x),
                               math::cbrt(x),
                               math::erfc(x),
                               math::pow(size, 1.7),
                               math::atan2(x, 1.7),
                               math::hypot(x, 1.7),
                               double{math::sin(static_cast<float>(x))},
                               double{math::cos(static_cast<float>(x))},
                               double{math::pow(static_cast<float>(size), 1.7F)}})
      bits = mixed(bits ^ std::bit_cast<std::uint64_t>(value));
  }
  EXPECT_EQ(bits, 9808404718443509007ULL);
}

}  // namespace
}  // namespace wold
