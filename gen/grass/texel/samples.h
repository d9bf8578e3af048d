#pragma once

#include <span>
#include <vector>

#include "core/curve.h"
#include "grass/mechanics/meadow_model.h"
#include "grass/texel/texel.h"
#include "scene/parts.h"

namespace wold::grass {

/// Ageing rates wd_i = Mg_i(wd) of the samples of a variant of the patch, [TVT] section 4.1, in the
/// order of samples_of(); the identity of one without a rate. Throws what load_curve() throws.
std::vector<Curve> ageing_rates(const scene::MeadowPart& meadow, int variant);

/// The blades of a sample, by its place in samples_of(), of a variant of the scene's patch:
/// scattered, or those of grass.from_texel. Throws what read_any_texel() and sample_texel() throw.
std::vector<Blade> sample_blades(const scene::MeadowPart& meadow, int variant, int sample);

/// One variant of the patch as its samples, K systems of blades that are simulated apart and
/// mingled into one texel. A sample has its species, its own blades (scatter_blades) and points; it
/// is always at its own weathering degree, Mg_i of the meadow's.
class Samples {
 public:
  /// Scatters the blades and samples their points; `shape` is that of the texel. `model` has to
  /// outlive it. Throws what sample_blades() throws.
  Samples(const scene::MeadowPart& meadow, const TexelShape& shape, int variant,
          const MeadowModel& model);

  /// One step of Algorithm 1 for every sample; `weathering` of the meadow in [0, 1], not before
  /// the last one.
  void advance_to(double weathering);

  /// Puts snow on all blades, the fraction `snow` in [0, 1] of what they can carry, until the next
  /// step.
  void support_load(double snow);

  /// The samples' texels and that of the snow on them, mingled.
  Texel texel() const;

  std::span<const PointDynamics> all() const { return samples_; }
  /// Points of all samples.
  std::size_t points() const;

 private:
  TexelShape shape_;
  std::vector<Curve> rates_;
  std::vector<PointDynamics> samples_;
  double snow_ = 0.0;
};

}  // namespace wold::grass
