#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace wold::test {

/// What an eye sees of the canopy of canopy_scene.h. Radiance is times pi, over the irradiance of
/// level ground.
struct CanopyView {
  double sun_deg, weathering;
  std::string plane;  ///< "principal" or "across"
  double view_deg;    ///< off the vertical; in the principal plane negative with the sun behind
  glm::dvec3 radiance;

  /// Unit: from the north for positive angles in the principal plane, from the east across it.
  glm::dvec3 towards_eye() const;
};

/// A table of canopy.py, its rows by height of the sun and weathering degree. Throws FileError.
using CanopyTable = std::map<std::pair<double, double>, std::vector<CanopyView>>;
CanopyTable read_canopy_table(const std::filesystem::path& path);

/// The value that a fraction in [0, 1] of the values does not exceed.
double quantile(std::vector<double> values, double fraction);

}  // namespace wold::test
