#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/noise.h"
#include "place/view.h"
#include "scene/scene.h"
#include "terrain/lighting.h"

namespace wold::meadow {

/// The uneven top of a wide meadow: tussocks and hollows from 6 m down to 20 cm. Each size has the
/// same variance. So most of it is finer than 2 m, as on grazed swards [Hutchings1991]. Some
/// places are rough and others smooth, as herds graze patches. Heights are about the grass's, with
/// grass.unevenness as their standard deviation over it on the mean of all places.
///
/// Flanks that face the sun are bright and others dark, and hollows lie in the shade of what stands
/// around them. Light that passes through the grass evens out half of what opaque flanks would
/// show. That half, and how dark hollows are, are modelling choices.
class Sward {
 public:
  /// As a map with steps of `step_m` shows it: finer tussocks are evened out.
  Sward(const scene::Scene& scene, double step_m);

  /// Where a place, in world space, is shown with larger steps than the map has.
  using StepAt = std::function<double(const glm::dvec3& place_m)>;

  /// Of the top at a place.
  struct Top {
    double height = 0.0;     ///< over the mean, as a fraction of it
    glm::dvec2 ascent{0.0};  ///< steepest, in metres per metre, of a top that is as rough around it
  };
  /// `step_m`: as a map with such steps shows it, where they are larger.
  Top at(const glm::dvec2& at_m, double step_m = 0.0) const;

  /// Light on the grass with that top over the light on a level one, from 0.35 to 1.7; 1 on the
  /// mean but for what is cut off. `up`: unit normal of the ground; `to_sun`: unit vector;
  /// `by_sun`: the fraction of that light which is the sun's.
  static double light(const Top& top, const glm::dvec3& up, const glm::dvec3& to_sun,
                      double by_sun);

 private:
  struct Octave {
    double feature_m, height;
    glm::dvec2 shift;
    std::uint64_t key;
  };

  double height_m_, step_m_;
  ScaleFreeNoise rough_places_;
  std::vector<Octave> octaves_;
};

/// The factor on the light on a frame's grass where it is in view, on the grid of `light`, which
/// falls on the ground under a clear sky. `step_at`: if there is one, says how finely each place is
/// shown.
FactorMap sward_light_map(const Sward& sward, const terrain::GroundLight& light,
                          const glm::dvec3& to_sun, const Heightfield& terrain,
                          const place::View& view, const Sward::StepAt& step_at = {});

}  // namespace wold::meadow
