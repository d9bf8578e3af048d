#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/double_double.h"
#include "core/elementary.h"
#include "core/exponential.h"

namespace wold::math {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// x = 2^exponent m with m near 1, log(m) = log(m inverse) - log(inverse) with `inverse` of 9 bits,
// so that its products are exact: Tang, "Table-driven implementation of the logarithm function in
// IEEE floating-point arithmetic" (1990).
constexpr int parts = 256;  // inverses are whole multiples of 1 / parts
constexpr int min_inverse = 180;
constexpr int greatest_inverse = 364;

/// log((n + 1) / n) by the series of the inverse hyperbolic tangent.
constexpr DoubleDouble log_of_step(int n) {
  const DoubleDouble z = DoubleDouble{1.0, 0.0} / DoubleDouble{2.0 * n + 1.0, 0.0};
  const DoubleDouble square = z * z;
  DoubleDouble sum{};
  for (int k = 15; k > 0; k -= 2)
    sum = DoubleDouble{1.0, 0.0} / DoubleDouble{1.0 * k, 0.0} + sum * square;
  return sum * z * 2.0;
}

/// -log(n / parts) for n from min_inverse on.
constexpr auto minus_log_of_parts = [] {
  std::array<DoubleDouble, greatest_inverse - min_inverse + 1> all{};
  constexpr std::size_t one = parts - min_inverse;
  for (std::size_t i = one; i > 0; --i)
    all[i - 1] = all[i] + log_of_step(min_inverse + static_cast<int>(i) - 1);
  for (std::size_t i = one; i + 1 < all.size(); ++i)
    all[i + 1] = all[i] + -log_of_step(min_inverse + static_cast<int>(i));
  return all;
}();

struct Entry {
  double inverse = 0.0;
  DoubleDouble minus_log;
};

constexpr int first_entry = 90;  // of 128 sqrt(1 / 2)
constexpr int last_entry = 182;  // of 128 sqrt(2)

/// For m within 1 / 256 of i / 128.
constexpr auto entries = [] {
  std::array<Entry, last_entry - first_entry + 1> all{};
  for (int i = first_entry; i <= last_entry; ++i) {
    const int inverse = (2 * parts * 128 / i + 1) / 2;
    all[static_cast<std::size_t>(i - first_entry)] = {
        1.0 * inverse / parts, minus_log_of_parts[static_cast<std::size_t>(inverse - min_inverse)]};
  }
  return all;
}();

/// log(1 + r) - r + r^2 / 2 for |r| < 0.009.
double log1p_from_third_power(double r) {
  const double r2 = r * r;
  const double r4 = r2 * r2;
  return r * r2 *
         (((1.0 / 3) - r * (1.0 / 4) + r2 * ((1.0 / 5) - r * (1.0 / 6))) +
          r4 * ((1.0 / 7) - r * (1.0 / 8) + r2 * ((1.0 / 9) - r * (1.0 / 10))));
}

/// What is left of the logarithm of a normal x > 0 when those of a power of two and of `inverse`
/// are taken off: log(x) = exponent ln 2 + minus_log + log(1 + r).
struct Remainder {
  double exponent = 0.0;
  const DoubleDouble& minus_log;
  DoubleDouble r;
};

constexpr std::uint64_t low_half = (1ULL << 27) - 1;

/// x without its last 27 bits.
double front_of(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~low_half);
}

Remainder remainder_of(double x) {
  constexpr std::uint64_t root_of_half = 0x3fe6a09e667f3bcdULL;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto exponent = static_cast<std::int64_t>(bits - root_of_half) >> 52;
  const auto m = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(exponent) << 52));
  const int i = static_cast<int>(m * 128.0 + 0.5);
  const Entry& entry = entries[static_cast<std::size_t>(i - first_entry)];
  const double front = front_of(m);
  return {static_cast<double>(exponent), entry.minus_log,
          exact_sum(front * entry.inverse - 1.0, (m - front) * entry.inverse)};
}

// ln 2 in two parts, the first one of 33 bits.
constexpr double ln_2_front = 0x1.62e42fef00000p-1;
constexpr double ln_2_back = 0x1.473de6af278edp-34;

/// log(x) for normal x > 0, with an error of 2^-66 of it, and `more` added.
DoubleDouble log_of_normal(double x, double more = 0.0) {
  const auto [exponent, minus_log, r] = remainder_of(x);
  const DoubleDouble whole = exact_sum(exponent * ln_2_front, minus_log.high);
  const DoubleDouble first = exact_sum(whole.high, r.high);
  const double front = front_of(r.high);  // its square is exact
  const DoubleDouble second = exact_sum(first.high, -0.5 * front * front);
  const double low = whole.low + first.low + second.low -
                     0.5 * (r.high - front) * (r.high + front) + minus_log.low +
                     exponent * ln_2_back + (r.low - r.high * r.low) +
                     log1p_from_third_power(r.high) + more;
  return ordered_sum(second.high, low);
}

/// The same rounded, with an error below 0.6 in the last place.
double rounded_log_of_normal(double x) {
  const auto [exponent, minus_log, r] = remainder_of(x);
  const DoubleDouble whole = exact_sum(exponent * ln_2_front, minus_log.high);
  const DoubleDouble first = exact_sum(whole.high, r.high);
  return first.high + (first.low + (whole.low + exponent * ln_2_back + minus_log.low + r.low) +
                       (log1p_from_third_power(r.high) - 0.5 * r.high * r.high));
}

/// The same to 2^-40.
double short_log_of_normal(double x) {
  const auto [exponent, minus_log, remainder] = remainder_of(x);
  const double r = remainder.high;
  const double r2 = r * r;
  return (exponent * ln_2.high + minus_log.high + r) -
         r2 * (0.5 - r * (1.0 / 3) + r2 * ((1.0 / 4) - r * (1.0 / 5)));
}

/// log(x) for x > 0.
DoubleDouble log_of_positive(double x) {
  if (x >= std::numeric_limits<double>::min()) return log_of_normal(x);
  return log_of_normal(x * 0x1p64) + ln_2 * -64.0;
}

bool is_positive(double x) { return x > 0.0 && x < infinity; }

/// Of what is not positive and finite.
double special_log(double x) {
  if (x == 0.0) return -infinity;
  return x < 0.0 ? not_a_number : x;
}

bool is_whole(double x) { return std::floor(x) == x; }
bool is_odd(double x) { return is_whole(x) && std::abs(x) < 0x1p53 && !is_whole(0.5 * x); }

/// base^exponent for base > 0 and finite.
double positive_power(double base, double exponent) {
  const DoubleDouble log_of_base = log_of_positive(base);
  const double nearly = log_of_base.high * exponent;
  if (!(std::abs(nearly) < 1000.0)) return nearly > 0.0 ? infinity : 0.0;
  if (std::abs(nearly) < 1e-18) return 1.0;
  const DoubleDouble product = exact_product(log_of_base.high, exponent);
  return rounded(scaled_exp({product.high, product.low + log_of_base.low * exponent}));
}

/// |base|^exponent for a base of 0 or infinity.
double power_of_end(double base, double exponent) {
  return (std::abs(base) > 1.0) == (exponent > 0.0) ? infinity : 0.0;
}

}  // namespace

double log(double x) {
  if (x >= std::numeric_limits<double>::min() && x < infinity) return rounded_log_of_normal(x);
  return is_positive(x) ? log_of_positive(x).high : special_log(x);
}

double log2(double x) {
  constexpr DoubleDouble per_log{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
  return is_positive(x) ? (log_of_positive(x) * per_log).high : special_log(x);
}

double log10(double x) {
  constexpr DoubleDouble per_log{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
  return is_positive(x) ? (log_of_positive(x) * per_log).high : special_log(x);
}

double log1p(double x) {
  if (std::abs(x) < 1e-17) return x;
  if (!(x > -1.0 && x < infinity)) return special_log(x + 1.0);
  const DoubleDouble sum = exact_sum(1.0, x);
  return log_of_normal(sum.high, sum.low / sum.high).high;
}

double asinh(double x) {
  const double size = std::abs(x);
  if (!(size < 1e18)) return std::copysign(1.0, x) * (log(size) + ln_2.high);
  const double square = size * size;
  return std::copysign(log1p(size + square / (1.0 + std::sqrt(1.0 + square))), x);
}

double pow(double base, double exponent) {
  if (exponent == 0.0 || base == 1.0) return 1.0;
  if (std::isnan(base) || std::isnan(exponent)) return base + exponent;
  const double size = std::abs(base);
  if (std::isinf(exponent))
    return size == 1.0 ? 1.0 : ((size > 1.0) == (exponent > 0.0) ? infinity : 0.0);
  if (base < 0.0 && size < infinity && !is_whole(exponent)) return not_a_number;
  const double power =
      is_positive(size) ? positive_power(size, exponent) : power_of_end(base, exponent);
  return std::signbit(base) && is_odd(exponent) ? -power : power;
}

float pow(float base, float exponent) {
  if (base > 0.0F && base < std::numeric_limits<float>::infinity() && std::abs(exponent) < 1e30F)
    return static_cast<float>(exp(short_log_of_normal(base) * exponent));
  return static_cast<float>(pow(double{base}, double{exponent}));
}

}  // namespace wold::math
