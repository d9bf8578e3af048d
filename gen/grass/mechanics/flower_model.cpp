#include "grass/mechanics/flower_model.h"

#include <algorithm>
#include <cmath>

namespace wold::grass {
namespace {

/// Weathering degrees from the first brown edge to a thread, and what a thread is of the petal's
/// width (modelling choices).
constexpr double withers_within = 0.15;
constexpr double thread = 0.15;

}  // namespace

FlowerModel::FlowerModel(const scene::Flower& flower)
    : fades_(flower.fades), colour_(flower.colour) {}

double FlowerModel::withered(double age) const {
  const double t = std::clamp((age - fades_) / withers_within, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

LeafShade FlowerModel::shade(Organ organ, double age) const {
  return organ == Organ::disc ? colour_.disc(withered(age)) : colour_.petal(withered(age));
}

float FlowerModel::petal_width(double age) const {
  return static_cast<float>(std::lerp(1.0, thread, withered(age)));
}

}  // namespace wold::grass
