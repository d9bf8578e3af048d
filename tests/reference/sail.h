#pragma once

#include <span>
#include <vector>

namespace wold::test {

// 4SAIL and 4SAIL2, four-stream models of light in leaves that hang at random in level layers
// [Verhoef2007], [Bach2007], written from their equations. A second witness beside traced
// paths. Angles are radians, reflectances fractions of the incident light.

/// How steep leaves stand: shares of the leaf area, which sum to 1, by the angle between leaf and
/// ground. They turn to all azimuths alike.
struct LeafAngles {
  std::vector<double> inclination;
  std::vector<double> fraction;
};

/// Verhoef's distribution by `a`, the mean slope, and `b`, bimodality, |a| + |b| <= 1; in his 13
/// classes.
LeafAngles verhoef_leaf_angles(double a, double b);

/// Where light comes from and goes to, off the vertical; `azimuth` between both: 0 looks down the
/// sun's rays.
struct SunAndView {
  double sun_zenith = 0.0;
  double view_zenith = 0.0;
  double azimuth = 0.0;
};

/// Mean over all azimuths of a leaf of |n s| |n o|, n its normal, s and o the unit directions to
/// sun and eye: of leaves that are lit and seen on one side, and of leaves that are lit on one and
/// seen on the other [Verhoef1998].
struct SeenLit {
  double one_side = 0.0;
  double two_sides = 0.0;
};
SeenLit seen_lit(double inclination, const SunAndView& directions);

/// A Lambertian leaf.
struct Leaf {
  double reflectance = 0.0;
  double transmittance = 0.0;
};

/// A layer of leaves of one kind; the leaf area index is one-sided.
struct LeafLayer {
  LeafAngles angles;
  Leaf leaf;
  double leaf_area_index = 0.0;
};

/// What a canopy and the soil below send back of sunlight and of light from all of the sky alike,
/// to an eye (times pi, over irradiance) and to all sides. In brackets PROSAIL's names.
struct CanopyReflectance {
  double sun_to_eye = 0.0;  ///< [rsot]
  double sky_to_eye = 0.0;  ///< [rdot]
  double sun_to_all = 0.0;  ///< [rsdt]
  double sky_to_all = 0.0;  ///< [rddt]
};

/// Reflectance of layers, the uppermost first, over Lambertian soil. `hot_spot` >= 0 is the size of
/// leaves over the canopy's height [Kuusk1985]: sun and sight share their gaps where they are
/// close. One layer is 4SAIL; the two of green_and_brown() are 4SAIL2.
CanopyReflectance sail(std::span<const LeafLayer> layers, double hot_spot, double soil,
                       const SunAndView& directions);

/// Leaves of two kinds in a canopy.
struct GreenAndBrown {
  Leaf green, brown;
  double brown_fraction = 0.0;  ///< of the leaf area, in (0, 1)
  /// 0: both kinds are mingled; 1: all green leaves are above all brown ones.
  double dissociation = 0.0;
};

/// 4SAIL2's layers: the upper holds as much leaf area as is green, the lower as much as is brown.
std::vector<LeafLayer> green_and_brown(const GreenAndBrown& leaves, const LeafAngles& angles,
                                       double leaf_area_index);

}  // namespace wold::test
