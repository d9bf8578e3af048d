#pragma once

namespace wold::cloud {

/// Share of light that droplets scatter per steradian at an angle to its way, over all angles 1
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

}  // namespace wold::cloud
