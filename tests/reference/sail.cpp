#include "reference/sail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace wold::test {
namespace {

using std::numbers::pi;

/// A direction against leaves of one inclination and all azimuths.
struct Against {
  double cosines;  ///< product with the leaf's inclination
  double sines;
  double turn;  ///< azimuth from which on the leaf shows its other side
  double swing() const { return turn < pi ? sines : cosines; }
};

Against against(double inclination, double zenith) {
  const double cosines = std::cos(inclination) * std::cos(zenith);
  const double sines = std::sin(inclination) * std::sin(zenith);
  return {cosines, sines, sines > cosines ? std::acos(-cosines / sines) : pi};
}

/// Of a unit of leaf area, what is projected onto the ground along a direction.
double projection(const Against& leaf, double zenith) {
  const double across = (leaf.turn - pi / 2.0) * leaf.cosines + std::sin(leaf.turn) * leaf.sines;
  return 2.0 / pi * across / std::cos(zenith);
}

/// Per leaf area index of a layer: extinction of sun (s) and view (o), and what is scattered of
/// sunlight (s), of diffuse light (d) and to the eye (o), backwards (b) and forwards (f).
struct Coefficients {
  double k_s = 0.0, k_o = 0.0;
  double att = 0.0, ddb = 0.0;
  double sdb = 0.0, sdf = 0.0;
  double dob = 0.0, dof = 0.0;
  double sod = 0.0;  ///< sun to eye in one scattering
};

Coefficients coefficients(const LeafAngles& angles, const Leaf& leaf, const SunAndView& to) {
  double k_s = 0.0, k_o = 0.0, level = 0.0, one_side = 0.0, two_sides = 0.0;
  for (std::size_t i = 0; i < angles.fraction.size(); ++i) {
    const double inclination = angles.inclination[i], share = angles.fraction[i];
    k_s += share * projection(against(inclination, to.sun_zenith), to.sun_zenith);
    k_o += share * projection(against(inclination, to.view_zenith), to.view_zenith);
    level += share * std::cos(inclination) * std::cos(inclination);
    const SeenLit seen = seen_lit(inclination, to);
    one_side += share * seen.one_side;
    two_sides += share * seen.two_sides;
  }
  const auto [r, t] = leaf;
  const auto back = [&](double k) { return 0.5 * ((k + level) * r + (k - level) * t); };
  const auto forth = [&](double k) { return 0.5 * ((k - level) * r + (k + level) * t); };
  return {
      .k_s = k_s,
      .k_o = k_o,
      .att = 1.0 - forth(1.0),
      .ddb = back(1.0),
      .sdb = back(k_s),
      .sdf = forth(k_s),
      .dob = back(k_o),
      .dof = forth(k_o),
      .sod = (one_side * r + two_sides * t) / (std::cos(to.sun_zenith) * std::cos(to.view_zenith))};
}

/// Integral over a layer of depth L of exp(-k x - m (L - x)) and of exp(-k x - m x).
double fading_out(double k, double m, double depth) {
  return std::abs(k - m) * depth < 1e-6 ? depth * std::exp(-0.5 * (k + m) * depth)
                                        : (std::exp(-m * depth) - std::exp(-k * depth)) / (k - m);
}
double fading_back(double k, double m, double depth) {
  return -std::expm1(-(k + m) * depth) / (k + m);
}

/// What a layer, or a stack of them, does with sunlight (s) and diffuse light (d), towards the eye
/// (o) and to all sides; r is sent back, t let through. What goes from sun to eye in one scattering
/// is left out: it depends on gaps that both share.
struct Stack {
  double t_ss = 0.0, t_oo = 0.0;
  double t_sd = 0.0, t_dd = 0.0, t_do = 0.0;
  double r_sd = 0.0, r_do = 0.0, r_sod = 0.0;
  double r_dd_above = 0.0, r_dd_below = 0.0;
};

Stack layer(const Coefficients& c, double depth) {
  const double m = std::sqrt(c.att * c.att - c.ddb * c.ddb);
  const double r = (c.att - m) / c.ddb;  // of an infinitely deep layer
  const double e = std::exp(-m * depth);
  const double all = 1.0 - r * r * e * e;
  const double s_down = (c.sdf + c.sdb * r) * fading_out(c.k_s, m, depth);
  const double s_up = (c.sdf * r + c.sdb) * fading_back(c.k_s, m, depth);
  const double o_down = (c.dof + c.dob * r) * fading_out(c.k_o, m, depth);
  const double o_up = (c.dof * r + c.dob) * fading_back(c.k_o, m, depth);
  Stack s;
  s.t_ss = std::exp(-c.k_s * depth);
  s.t_oo = std::exp(-c.k_o * depth);
  s.t_dd = (1.0 - r * r) * e / all;
  s.r_dd_above = s.r_dd_below = r * (1.0 - e * e) / all;
  s.t_sd = (s_down - r * e * s_up) / all;
  s.r_sd = (s_up - r * e * s_down) / all;
  s.t_do = (o_down - r * e * o_up) / all;
  s.r_do = (o_up - r * e * o_down) / all;
  const double z = fading_back(c.k_s, c.k_o, depth);
  const double g_1 = (z - fading_out(c.k_s, m, depth) * s.t_oo) / (c.k_o + m);
  const double g_2 = (z - fading_out(c.k_o, m, depth) * s.t_ss) / (c.k_s + m);
  s.r_sod =
      ((c.dof * r + c.dob) * (c.sdf + c.sdb * r) * g_1 +
       (c.dof + c.dob * r) * (c.sdf * r + c.sdb) * g_2 - (s.r_do * s_up + s.t_do * s_down) * r) /
      (1.0 - r * r);
  return s;
}

Stack ground(double soil) {
  Stack s;
  s.r_sd = s.r_do = s.r_dd_above = soil;
  return s;
}

/// A stack over another: light goes back and forth between them.
Stack over(const Stack& a, const Stack& b) {
  const double bounces = 1.0 / (1.0 - a.r_dd_below * b.r_dd_above);
  // Diffuse sunlight between both.
  const double down = (a.t_sd + a.t_ss * b.r_sd * a.r_dd_below) * bounces;
  const double up = (a.t_ss * b.r_sd + a.t_sd * b.r_dd_above) * bounces;
  Stack s;
  s.t_ss = a.t_ss * b.t_ss;
  s.t_oo = a.t_oo * b.t_oo;
  s.t_sd = a.t_ss * b.t_sd + down * b.t_dd;
  s.t_dd = a.t_dd * bounces * b.t_dd;
  s.t_do = b.t_do * a.t_oo + b.t_dd * bounces * (a.t_do + a.r_dd_below * b.r_do * a.t_oo);
  s.r_sd = a.r_sd + up * a.t_dd;
  s.r_do = a.r_do + a.t_dd * bounces * (b.r_do * a.t_oo + b.r_dd_above * a.t_do);
  s.r_sod = a.r_sod + a.t_ss * b.r_sod * a.t_oo + down * b.r_do * a.t_oo + up * a.t_do;
  s.r_dd_above = a.r_dd_above + a.t_dd * b.r_dd_above * a.t_dd * bounces;
  s.r_dd_below = b.r_dd_below + b.t_dd * a.r_dd_below * b.t_dd * bounces;
  return s;
}

/// The gaps that sun and sight have in common down to a depth [Kuusk1985], [Verhoef1998].
class SharedGaps {
 public:
  /// `fades` is how fast sun and sight lose each other, over the canopy's whole depth.
  explicit SharedGaps(double fades) : fades_(fades) {}

  /// Passes a layer that fills `share` of the canopy's depth. Returns the integral over its leaf
  /// area of the probability that both come there.
  double pass(const Coefficients& c, double leaf_area_index, double share) {
    constexpr int steps = 200;
    const double from = depth_;
    const auto probability = [&](double x) {
      return std::exp(log_ - (c.k_s + c.k_o) * leaf_area_index * x +
                      std::sqrt(c.k_s * c.k_o) * leaf_area_index *
                          shared_between(from, from + share * x) / share);
    };
    double sum = 0.0;  // Simpson's rule
    for (int i = 0; i <= steps; ++i)
      sum += (i == 0 || i == steps ? 1.0
              : i % 2 == 1         ? 4.0
                                   : 2.0) *
             probability(static_cast<double>(i) / steps);
    log_ = std::log(probability(1.0));
    depth_ += share;
    return leaf_area_index * sum / (3.0 * steps);
  }

  /// The probability that both come as far as this.
  double here() const { return std::exp(log_); }

 private:
  double shared_between(double a, double b) const {
    return fades_ < 1e-9 ? b - a : (std::exp(-fades_ * a) - std::exp(-fades_ * b)) / fades_;
  }

  double fades_;
  double depth_ = 0.0;  ///< 0 on top, 1 on the ground
  double log_ = 0.0;
};

/// Distance of where sun and sight pass a level, over the height above it.
double apart(const SunAndView& to) {
  const double s = std::tan(to.sun_zenith), o = std::tan(to.view_zenith);
  return std::sqrt(std::max(0.0, s * s + o * o - 2.0 * s * o * std::cos(to.azimuth)));
}

}  // namespace

LeafAngles verhoef_leaf_angles(double a, double b) {
  const auto cumulative = [&](double degrees) {
    const double p = 2.0 * degrees * pi / 180.0;
    double x = p, y = 0.0;
    for (int i = 0; i < 200; ++i) {
      y = a * std::sin(x) + 0.5 * b * std::sin(2.0 * x);
      x += 0.5 * (y - x + p);
    }
    return (2.0 * y + p) / pi;
  };
  constexpr std::array ends_deg = {0.0,  10.0, 20.0, 30.0, 40.0, 50.0, 60.0,
                                   70.0, 80.0, 82.0, 84.0, 86.0, 88.0, 90.0};
  LeafAngles angles;
  for (std::size_t i = 1; i < ends_deg.size(); ++i) {
    angles.inclination.push_back(0.5 * (ends_deg[i - 1] + ends_deg[i]) * pi / 180.0);
    angles.fraction.push_back(cumulative(ends_deg[i]) - cumulative(ends_deg[i - 1]));
  }
  return angles;
}

SeenLit seen_lit(double inclination, const SunAndView& to) {
  const Against s = against(inclination, to.sun_zenith);
  const Against o = against(inclination, to.view_zenith);
  std::array b = {std::abs(s.turn - o.turn), pi - std::abs(s.turn + o.turn - pi), to.azimuth};
  std::ranges::sort(b);
  const double always = 2.0 * s.cosines * o.cosines + s.sines * o.sines * std::cos(to.azimuth);
  const double turning = std::sin(b[1]) * (2.0 * s.swing() * o.swing() +
                                           s.sines * o.sines * std::cos(b[0]) * std::cos(b[2]));
  return {std::max(0.0, ((pi - b[1]) * always + turning) / (2.0 * pi)),
          std::max(0.0, (-b[1] * always + turning) / (2.0 * pi))};
}

CanopyReflectance sail(std::span<const LeafLayer> layers, double hot_spot, double soil,
                       const SunAndView& directions) {
  std::vector<Coefficients> all;
  double area = 0.0, k = 0.0;
  for (const LeafLayer& one : layers) {
    all.push_back(coefficients(one.angles, one.leaf, directions));
    area += one.leaf_area_index;
    k += one.leaf_area_index * 0.5 * (all.back().k_s + all.back().k_o);
  }
  constexpr double never = 1e6;
  SharedGaps gaps(hot_spot > 0.0 ? std::min(never, apart(directions) / hot_spot * area / k)
                                 : never);
  double once = 0.0;
  for (std::size_t i = 0; i < layers.size(); ++i)
    once +=
        all[i].sod * gaps.pass(all[i], layers[i].leaf_area_index, layers[i].leaf_area_index / area);
  Stack canopy = ground(soil);
  for (std::size_t i = layers.size(); i-- > 0;)
    canopy = over(layer(all[i], layers[i].leaf_area_index), canopy);
  return {once + gaps.here() * soil + canopy.r_sod, canopy.r_do, canopy.r_sd, canopy.r_dd_above};
}

std::vector<LeafLayer> green_and_brown(const GreenAndBrown& leaves, const LeafAngles& angles,
                                       double leaf_area_index) {
  const double brown = leaves.brown_fraction, green = 1.0 - brown;
  const double mingled = (1.0 - leaves.dissociation) * brown * green;
  const auto mix = [](const Leaf& a, const Leaf& b, double share_of_b) {
    return Leaf{std::lerp(a.reflectance, b.reflectance, share_of_b),
                std::lerp(a.transmittance, b.transmittance, share_of_b)};
  };
  return {{angles, mix(leaves.green, leaves.brown, mingled / green), green * leaf_area_index},
          {angles, mix(leaves.brown, leaves.green, mingled / brown), brown * leaf_area_index}};
}

}  // namespace wold::test
