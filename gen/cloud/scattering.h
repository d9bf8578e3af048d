#pragma once

#include <vector>

namespace wold::cloud {

/// Fraction of light that droplets scatter per steradian at an angle to its way, over all angles 1
/// (Henyey and Greenstein 1941). asymmetry in (-1, 1).
double henyey_greenstein(double asymmetry, double cosine);

/// Fluxes of diffuse light inside a cloud, of the light that falls on its lit side.
struct TwoStream {
  double onward = 0.0;  ///< away from the lit side
  double back = 0.0;
};

/// Two-stream diffusion without absorption (Bohren 1987, Multiple scattering of light and some of
/// its observable consequences): with c = 3/4 (1 - g), depth_before from the lit side and
/// depth_behind to the other, onward = (1 + c behind) / (1 + c all), back = c behind / (1 + c all).
/// Their difference, the net flux, is 1 / (1 + c all) everywhere: no light is lost.
TwoStream two_stream(double asymmetry, double depth_before, double depth_behind);

/// The same in a cloud that loses light to its sides: both streams fall by e over an optical depth
/// of 1 / `decay` in the middle of a deep one. Without decay it is two_stream() of three numbers.
/// No stream is negative.
TwoStream two_stream(double asymmetry, double depth_before, double depth_behind, double decay);

/// The decay, per unit of optical depth, of diffuse light that goes along a slab of an optical
/// depth across, by the slowest mode of its diffusion: pi over the depth that counts for diffusion,
/// (1 - g) across + 4/3 with what lies beyond its faces (Ishimaru 1978, Wave Propagation and
/// Scattering in Random Media, chapter 9), per unit of which (1 - g) pass.
double decay_along_slab(double asymmetry, double depth_across);

/// Radiance of what travels at an angle of that cosine to the onward stream's way: each stream
/// fills its side evenly, and one passes into the other in between.
double radiance_of(const TwoStream& streams, double cosine);

/// Fraction of sunlight that after `depth` still is in the forward peak, which two-stream diffusion
/// counts among the onward stream: asymmetry^2 of it stays there each time (Joseph, Wiscombe and
/// Weinman 1976, The delta-Eddington approximation for radiative flux transfer).
double in_forward_peak(double asymmetry, double depth);

/// Radiance, per unit of the sun's irradiance, that sunlight has in and near the forward peak
/// behind a cloud that is `depth` thick along the light, without what was not scattered at all.
///
/// Of light that was scattered n times, Poisson's fraction of the depth, the angles follow Henyey
/// and Greenstein's law with asymmetry^n, its convolution with itself (Goudsmit and Saunderson
/// 1940, taking all paths for as long as the straight one); from the second time on only what is
/// more than even light counts. With two_stream() less in_forward_peak() spread evenly it is within
/// 6 % of what photons followed one by one give, up to 50 degrees, for depths to 8 (asymmetry
/// 0.866).
double forward_through(double asymmetry, double depth, double cosine);

/// The source of that, per unit of optical depth, at a `depth` from the lit side: its integral over
/// exp(-(depth - t)) dt is forward_through().
double forward_source(double asymmetry, double depth, double cosine);

/// What of forward_source() the first two moments of its angles, mean and flux, do not tell, plus
/// those of the light that left the forward peak for the first time, asymmetry^2 of it staying
/// there each time (Joseph, Wiscombe and Weinman 1976). With the mean and flux of all light that
/// left the peak, as diffuse_light.h has them, it makes up the source. Below 0 at some angles.
double peak_source(double asymmetry, double depth, double cosine);

/// One of these laws for droplets of one asymmetry, in [0, 1), tabulated: within 1 % of its highest
/// value at that depth.
class ForwardTable {
 public:
  using Law = double (*)(double asymmetry, double depth, double cosine);
  ForwardTable(Law law, double asymmetry);

  /// depth >= 0, cosine in [-1, 1].
  double at(double depth, double cosine) const;

 private:
  std::vector<float> values_;  ///< angles of one depth after the other
};

}  // namespace wold::cloud
