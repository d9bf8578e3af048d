#pragma once

namespace wold::wind {

/// Height above the ground for which winds are given, as weather stations have it.
inline constexpr double reference_m = 10.0;

/// Von Karman's constant.
inline constexpr double von_karman = 0.4;

/// The mean wind over and in a canopy of plants of one height on level ground, neutral air.
///
/// Above it is the logarithmic law over the displacement 2/3 h and the roughness length 0.123 h
/// ([Allen1998]). Within it falls exponentially towards the ground ([Cionco1972]), with the
/// attenuation that joins the law with one slope, 3.0; measured in grass and grain 2.4 to 2.8.
class Profile {
 public:
  /// The canopy's height in metres, 0.01 to 2; what is outside is taken as the nearer end.
  explicit Profile(double canopy_m);

  double canopy_m() const { return canopy_m_; }
  double roughness_m() const { return roughness_m_; }
  /// Mean speed at a height above the ground, metres from 0, over that at reference_m.
  double at(double height_m) const;
  /// Metres over the displacement, where similarity of turbulence counts from; of places within the
  /// canopy those of its top.
  double above_displacement_m(double height_m) const;
  /// The mean speed at the canopy's top, over that at reference_m.
  double at_top() const { return top_; }
  /// Friction velocity over the speed at reference_m.
  double friction() const { return friction_; }
  /// L_s = U / (dU/dz) at the canopy's top, metres ([Raupach1996]).
  double shear_length_m() const { return shear_length_m_; }

 private:
  double canopy_m_, displacement_m_, roughness_m_;
  double friction_, top_, shear_length_m_;
};

}  // namespace wold::wind
