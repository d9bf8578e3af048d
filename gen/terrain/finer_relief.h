#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "core/ground_map.h"
#include "core/row_parts.h"
#include "terrain/roughness.h"

namespace wold::terrain {

/// Depth of snow at a place, metres.
using SnowDepth = std::function<double(const glm::dvec2& at_m)>;

/// The ground below the cells of a map of heights, as its roughness says: smooth
/// where that map is smooth, rough where it is rough. Octaves of gradient
/// noise, each carried along the fall line of the ground and of the octaves above it, so that small
/// channels run down slopes and join larger ones. A keyed function of the place, the same for
/// whatever step and distance it is asked; octaves end at waves that creeping soil has levelled.
class FinerRelief {
 public:
  /// `heights_m`: two steps a cell. `hurst`: the exponent that the ground settles at; what the
  /// roughness's is more at the cells' size halves from octave to octave.
  FinerRelief(const GroundMap<double>& heights_m, Roughness roughness, double hurst,
              std::uint64_t seed);

  /// Side of the cells that it is the relief below, metres.
  static double cell_m(const GroundMap<double>& heights_m) { return 2.0 * heights_m.step_m(); }

  /// How much of each octave something shows, 0 to 1.
  using Weights = std::vector<double>;

  /// A map with this step, metres.
  Weights shown_at(double step_m) const;
  /// A map with step `step_m`, less what one with `coarse_step_m` shows; and soil has crept.
  Weights shown_below(double coarse_step_m, double step_m) const;

  struct Bump {
    double height_m = 0.0;
    glm::dvec2 gradient{0.0};  ///< steepest ascent, as if roughness and fall line stayed the same
    double deviation_m = 0.0;  ///< of such heights here
  };
  Bump at(const glm::dvec2& at_m, const Weights& weights) const;

  /// The same at the places of a grid that count, others have none: large octaves are evaluated at
  /// fewer places and interpolated between them, true to some 7 % of the least of them.
  GroundMap<Bump> on_grid(const GroundGrid& grid, const Weights& weights,
                          const RowParts& parts) const;
  /// Of the same, the gradient of what snow on it hides: the more of a wave, the shorter it is and
  /// the deeper the snow.
  GroundMap<glm::vec2> hidden_by(const SnowDepth& snow_m, const GroundGrid& grid,
                                 const Weights& weights, const RowParts& parts) const;

 private:
  /// Of a place, after some octaves.
  struct State {
    Bump shown;  ///< with the variance in place of the deviation
    glm::dvec2 ascent;
    double deviation_m;  ///< of the next octave
    double excess;       ///< of its exponent, over hurst_
  };
  /// On a grid, interpolated.
  struct States {
    GroundMap<glm::vec4> slopes;   ///< gradient and ascent
    GroundMap<glm::vec4> heights;  ///< height, variance, deviation, excess
    State at(const glm::dvec2& at_m) const;
  };

  State first_state(const glm::dvec2& at_m) const;
  void add_octave(State& state, const glm::dvec2& at_m, std::size_t k, double weight) const;
  /// Octaves from the first to before the last.
  struct Octaves {
    std::size_t first, last;
  };
  /// With `snow_m` what snow hides of them, without all of them.
  void add_octaves(State& state, const glm::dvec2& at_m, const Octaves& octaves,
                   const Weights& weights, const SnowDepth& snow_m) const;
  /// After the first `count` octaves.
  States states(const GroundGrid& grid, const Weights& weights, std::size_t count,
                const SnowDepth& snow_m) const;
  /// visit(i, j, state after `count` octaves), in parallel, of the places that count.
  template <class Visit>
  void visit_states(const GroundGrid& grid, const Weights& weights, std::size_t count,
                    const RowParts& parts, const SnowDepth& snow_m, const Visit& visit) const;

  struct Octave {
    double feature_m;
    std::uint64_t key;
    glm::dvec2 shift;
  };

  std::vector<Octave> octaves_;
  double hurst_;
  Roughness roughness_;
  GroundMap<glm::vec2> gradient_;
};

}  // namespace wold::terrain
