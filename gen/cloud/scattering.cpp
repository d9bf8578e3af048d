#include "cloud/scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::cloud {
namespace {

using std::numbers::pi;

/// What light that is scattered for the `time`th time, from 1, sends out at the angle.
double forward_order(double asymmetry, int time, double cosine) {
  const double phase = henyey_greenstein(math::pow(asymmetry, time), cosine);
  return time == 1 ? phase : std::max(0.0, phase - 0.25 / pi);
}

/// Sum over times from 1 of poisson(times - 1 + first) forward_order(times).
double forward_sum(double asymmetry, double depth, double cosine, int first) {
  constexpr int times = 40;  // after these all light of droplets is even
  double poisson = math::exp(-depth) * (first == 0 ? 1.0 : depth);
  double sum = 0.0;
  for (int time = 1; time <= times; ++time) {
    sum += poisson * forward_order(asymmetry, time, cosine);
    poisson *= depth / (time + first);
    if (time > depth && poisson < 1e-9) break;
  }
  return sum;
}

// The table's steps: even ones of the root of depth / (depth + middle), and of the root of the sine
// of half the angle, fine in the peak.
constexpr int depths = 128;
constexpr int angles = 128;
constexpr double middle_depth = 8.0;

double depth_of(int step) {
  const double root = static_cast<double>(step) / depths;  // below 1: depths have no end
  const double fraction = root * root;
  return middle_depth * fraction / (1.0 - fraction);
}

double cosine_of(int step) {
  const double root = static_cast<double>(step) / (angles - 1);
  return 1.0 - 2.0 * math::pow(root, 4);
}

/// What of each of two streams turns back per unit of optical depth (Bohren 1987).
double turned_back(double asymmetry) { return 0.75 * (1.0 - asymmetry); }

}  // namespace

double henyey_greenstein(double asymmetry, double cosine) {
  const double g = asymmetry;
  const double base = 1.0 + g * g - 2.0 * g * cosine;
  return (1.0 - g * g) / (4.0 * pi * base * std::sqrt(base));
}

TwoStream two_stream(double asymmetry, double depth_before, double depth_behind) {
  const double c = turned_back(asymmetry);
  const double all = 1.0 + c * (depth_before + depth_behind);
  return {(1.0 + c * depth_behind) / all, c * depth_behind / all};
}

/// Of dF+/dt = -(c + loss) F+ + c F- and -dF-/dt = -(c + loss) F- + c F+, whose solutions fall and
/// rise by exp(decay t), with F+ = 1 on the lit side and F- = 0 on the other. Numbers are those
/// over exp(decay all), so that none is too large.
TwoStream two_stream(double asymmetry, double depth_before, double depth_behind, double decay) {
  if (decay <= 0.0) return two_stream(asymmetry, depth_before, depth_behind);
  const double c = turned_back(asymmetry);
  const double turned_or_lost = std::sqrt(c * c + decay * decay);  // loss = this - c
  const double all = depth_before + depth_behind;
  const auto sinh_over_decay = [&](double depth) {
    return 0.5 * (math::exp(decay * (depth - all)) - math::exp(-decay * (depth + all))) / decay;
  };
  const auto cosh = [&](double depth) {
    return 0.5 * (math::exp(decay * (depth - all)) + math::exp(-decay * (depth + all)));
  };
  const auto onward = [&](double depth) {
    return cosh(depth) + turned_or_lost * sinh_over_decay(depth);
  };
  return {onward(depth_behind) / onward(all), c * sinh_over_decay(depth_behind) / onward(all)};
}

double decay_along_slab(double asymmetry, double depth_across) {
  const double turns = 1.0 - asymmetry;
  return turns * pi / (turns * depth_across + 4.0 / 3.0);
}

double radiance_of(const TwoStream& streams, double cosine) {
  return ((1.0 + cosine) * streams.onward + (1.0 - cosine) * streams.back) / (2.0 * pi);
}

double in_forward_peak(double asymmetry, double depth) {
  return math::exp(-(1.0 - asymmetry * asymmetry) * depth);
}

double forward_through(double asymmetry, double depth, double cosine) {
  return forward_sum(asymmetry, depth, cosine, 1);
}

double forward_source(double asymmetry, double depth, double cosine) {
  return forward_sum(asymmetry, depth, cosine, 0);
}

double peak_source(double asymmetry, double depth, double cosine) {
  constexpr int times = 60;
  double poisson = math::exp(-depth), left_of_flux = asymmetry, sum = 0.0;
  for (int time = 1; time <= times; ++time) {
    const double even = (1.0 + 3.0 * left_of_flux * cosine) / (4.0 * pi);
    sum += poisson * (henyey_greenstein(left_of_flux, cosine) - even);
    left_of_flux *= asymmetry;
    poisson *= depth / time;
    if (time > depth && poisson < 1e-9) break;
  }
  return sum + in_forward_peak(asymmetry, depth) * (1.0 + 3.0 * asymmetry * cosine) / (4.0 * pi);
}

ForwardTable::ForwardTable(Law law, double asymmetry) {
  values_.reserve(static_cast<std::size_t>(depths) * angles);
  for (int d = 0; d < depths; ++d)
    for (int a = 0; a < angles; ++a)
      values_.push_back(static_cast<float>(law(asymmetry, depth_of(d), cosine_of(a))));
}

double ForwardTable::at(double depth, double cosine) const {
  const double d = std::min(depths * std::sqrt(depth / (depth + middle_depth)), depths - 1.0);
  const double a = (angles - 1) * std::sqrt(std::sqrt(std::clamp(0.5 - 0.5 * cosine, 0.0, 1.0)));
  const int low_d = std::min(static_cast<int>(d), depths - 2);
  const int low_a = std::min(static_cast<int>(a), angles - 2);
  const float* low = values_.data() + static_cast<std::ptrdiff_t>(low_d) * angles + low_a;
  const auto along = [&](const float* row) {
    return std::lerp(double{row[0]}, double{row[1]}, a - low_a);
  };
  const double above = (depth - depth_of(low_d)) / (depth_of(low_d + 1) - depth_of(low_d));
  return std::lerp(along(low), along(low + angles), std::min(above, 1.0));
}

}  // namespace wold::cloud
