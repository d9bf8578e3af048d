#include "compare/flip_colours.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compare/filter.h"
#include "compare/pixels.h"
#include "core/colour.h"
#include "core/elementary.h"

namespace wold::compare {
namespace {

/// One bell of the eye's point spread: height * sqrt(pi / width) * exp(-pi^2 d^2 / width) at a
/// distance of d degrees.
struct Bell {
  double height, width;
};

/// Table 1: the eye's contrast sensitivity for brightness, red-green and blue-yellow.
const std::array<std::vector<Bell>, 3> sensitivity = {
    {{{1.0, 0.0047}}, {{1.0, 0.0053}}, {{34.1, 0.04}, {13.5, 0.025}}}};
constexpr double widest = 0.04;

/// Sections 4.1.2 and 4.1.3: exponent of the difference, and the fraction of the largest difference
/// that is stretched over [0, knee].
constexpr double exponent = 0.7;
constexpr double knee_fraction = 0.4;
constexpr double knee = 0.95;

double sigma_px(const Bell& bell, double pixels_per_degree) {
  return std::sqrt(bell.width / 2.0) / std::numbers::pi * pixels_per_degree;
}

/// The volume under a bell, sampled at the pixels: its top over its weight there.
double volume(const Bell& bell, const Weights& sampled) {
  const double middle = sampled[sampled.size() / 2];
  return bell.height * std::sqrt(std::numbers::pi / bell.width) / (middle * middle);
}

/// A channel blurred by the sum of its bells, scaled so that a constant stays as it is.
Image as_seen(const Image& channel, const std::vector<Bell>& bells, double pixels_per_degree) {
  const auto radius = static_cast<int>(std::ceil(3.0 * sigma_px({1.0, widest}, pixels_per_degree)));
  Image sum(channel.width, channel.height, 1);
  double whole = 0.0;
  for (const Bell& bell : bells) {
    const Weights sampled = gaussian(sigma_px(bell, pixels_per_degree), radius);
    const Image part = filtered(channel, sampled, sampled);
    const double weight = volume(bell, sampled);
    for (std::size_t i = 0; i < sum.values.size(); ++i)
      sum.values[i] += static_cast<float>(weight) * part.values[i];
    whole += weight;
  }
  for (float& value : sum.values) value /= static_cast<float>(whole);
  return sum;
}

/// One channel of a picture by itself.
Image channel_of(const Image& image, int channel) {
  return pixelwise(
      1, [&](float* out, const float* pixel) { *out = pixel[channel]; }, image);
}

glm::dvec3 colour(const float* pixel) { return {pixel[0], pixel[1], pixel[2]}; }

/// The inverse of opponent_colours(), as linear light.
glm::dvec3 linear_srgb(const glm::dvec3& opponent) {
  const double y = (opponent.x + 16.0) / 116.0;
  const glm::dvec3 relative(y + opponent.y / 500.0, y, y - opponent.z / 200.0);
  return srgb_from_xyz(relative * xyz_from_srgb(glm::dvec3(1.0)));
}

/// L*a*b* whose colours fade with brightness (Hunt's effect).
glm::dvec3 hunt_lab(const glm::dvec3& linear_rgb) {
  const glm::dvec3 lab = lab_from_xyz(xyz_from_srgb(linear_rgb));
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

/// Abasi, Amani Tehran and Fairchild 2020 (Color Research and Application 45:1): the distance for
/// large differences.
double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + math::hypot(a.y - b.y, a.z - b.z);
}

double perceived(const glm::dvec3& a, const glm::dvec3& b) {
  return math::pow(hyab(a, b), exponent);
}

/// The difference as a fraction from 0 to 1: `knee_fraction` of the largest takes up nearly all of
/// it.
double redistributed(double difference, double largest) {
  const double bend = knee_fraction * largest;
  if (difference < bend) return knee * difference / bend;
  return knee + (1.0 - knee) * (difference - bend) / (largest - bend);
}

/// What is left of a picture at some distance, in the space its colours are compared in.
Image seen_colours(const Image& opponent, double pixels_per_degree) {
  std::array<Image, 3> channels;
  for (std::size_t c = 0; c < 3; ++c)
    channels[c] =
        as_seen(channel_of(opponent, static_cast<int>(c)), sensitivity[c], pixels_per_degree);
  const auto to_lab = [](float* out, const float* y, const float* cx, const float* cz) {
    const glm::dvec3 lab = hunt_lab(glm::clamp(linear_srgb({*y, *cx, *cz}), 0.0, 1.0));
    for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(lab[c]);
  };
  return pixelwise(3, to_lab, channels[0], channels[1], channels[2]);
}

}  // namespace

Image opponent_colours(const Image& image) {
  const glm::dvec3 white_xyz = xyz_from_srgb(glm::dvec3(1.0));
  const auto convert = [&](float* out, const float* pixel) {
    const glm::dvec3 linear(srgb_decoded(pixel[0]), srgb_decoded(pixel[1]), srgb_decoded(pixel[2]));
    const glm::dvec3 relative = xyz_from_srgb(linear) / white_xyz;
    out[0] = static_cast<float>(116.0 * relative.y - 16.0);
    out[1] = static_cast<float>(500.0 * (relative.x - relative.y));
    out[2] = static_cast<float>(200.0 * (relative.y - relative.z));
  };
  return pixelwise(3, convert, shown_rgb(image));
}

Image colour_differences(const Image& got, const Image& want, double pixels_per_degree) {
  // No two colours of a screen are further apart.
  const double largest = perceived(hunt_lab({0.0, 1.0, 0.0}), hunt_lab({0.0, 0.0, 1.0}));
  const auto compare = [&](float* out, const float* a, const float* b) {
    *out = static_cast<float>(redistributed(perceived(colour(a), colour(b)), largest));
  };
  return pixelwise(1, compare, seen_colours(got, pixels_per_degree),
                   seen_colours(want, pixels_per_degree));
}

}  // namespace wold::compare
