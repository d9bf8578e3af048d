#pragma once

namespace wold::sky {

/// Share in [0, 1] of the light of a cloud that reaches an eye below it: haze thins with height, by
/// e over 1.2 km (Elterman 1968, the aerosol of the lowest kilometres). `rise_m` > 0: of the cloud
/// over the eye; distance_m along the line of sight.
double clear_fraction(double distance_m, double rise_m, double visual_range_m);

}  // namespace wold::sky
