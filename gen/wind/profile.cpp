#include "wind/profile.h"

#include <algorithm>

#include "core/elementary.h"

namespace wold::wind {
namespace {

constexpr double displacement_over_height = 2.0 / 3.0;
constexpr double roughness_over_height = 0.123;
constexpr double min_canopy_m = 0.01, max_canopy_m = 2.0;

}  // namespace

Profile::Profile(double canopy_m)
    : canopy_m_(std::clamp(canopy_m, min_canopy_m, max_canopy_m)),
      displacement_m_(displacement_over_height * canopy_m_),
      roughness_m_(roughness_over_height * canopy_m_),
      friction_(von_karman / math::log((reference_m - displacement_m_) / roughness_m_)) {
  const double above_m = canopy_m_ - displacement_m_;
  const double logarithm = math::log(above_m / roughness_m_);
  top_ = friction_ / von_karman * logarithm;
  shear_length_m_ = above_m * logarithm;
}

double Profile::above_displacement_m(double height_m) const {
  return std::max(height_m, canopy_m_) - displacement_m_;
}

double Profile::at(double height_m) const {
  if (height_m < canopy_m_) return top_ * math::exp((height_m - canopy_m_) / shear_length_m_);
  return friction_ / von_karman * math::log((height_m - displacement_m_) / roughness_m_);
}

}  // namespace wold::wind
