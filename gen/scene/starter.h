#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace wold::scene {

/// What starter scenes there are: "hillside" first, "mountain", "clouds", "snow", "season".
const std::vector<std::string>& starter_kinds();

/// A real place, in place of a kind's own hill.
struct StarterPlace {
  std::string elevation;      ///< terrain.elevation
  std::string system;         ///< terrain.system
  double size_m = 0.0;        ///< terrain.size
  int samples = 0;            ///< terrain.samples
  double visual_range_m = 0;  ///< sky.visual_range
  std::array<double, 2> eye_m{}, target_m{};
  double eye_height_m = 0.0, target_height_m = 0.0;
  /// Where on earth; none where nobody knows.
  std::optional<std::array<double, 2>> longitude_latitude_deg = {};
};

/// The scene of a kind, without a name. At another place on earth its sun stands there as late in
/// the day, and south of the equator a season is half a year later. Throws InputError when `kind`
/// is none of starter_kinds().
Scene scene_of_kind(const std::string& kind,
                    const std::optional<std::array<double, 2>>& longitude_latitude_deg = {});

/// A short commented scene with the keys one changes first. Throws InputError when `name` does
/// not serve as a scene's name or `kind` is none of starter_kinds().
std::string starter_scene(const std::string& name, const std::string& kind,
                          const std::optional<StarterPlace>& place = {});

}  // namespace wold::scene
