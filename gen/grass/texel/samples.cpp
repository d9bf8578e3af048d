#include "grass/texel/samples.h"

#include "core/random.h"
#include "grass/ageing/ageing_curves.h"
#include "grass/geometry/flower.h"
#include "grass/geometry/meadow_samples.h"
#include "grass/texel/foreign_texel.h"
#include "grass/texel/mingle.h"
#include "grass/texel/rasterise.h"
#include "grass/texel/snow_points.h"
#include "grass/texel/texel_points.h"
#include "scene/species.h"

namespace wold::grass {
namespace {

std::uint64_t point_seed(std::uint64_t seed, int variant, int sample) {
  return random_bits({seed, key_of("points"), static_cast<std::uint64_t>(variant),
                      static_cast<std::uint64_t>(sample)});
}

SampledTexel from_texel(const scene::MeadowPart& meadow, int variant, int sample) {
  const Texel texel = fitted_to_patch(read_any_texel(meadow.grass.from_texel, "grass.from_texel"),
                                      meadow.grass.patch_m);
  return sample_texel(texel, meadow.grass, meadow.ageing, point_seed(meadow.seed, variant, sample));
}

SampledTexel scattered(const scene::MeadowPart& meadow, const TexelShape& shape, int variant,
                       int sample) {
  SampledTexel result{sample_blades(meadow, variant, sample), {}};
  result.points = sample_points(result.blades, shape, meadow.grass.points_per_voxel_face,
                                point_seed(meadow.seed, variant, sample));
  return result;
}

}  // namespace

std::vector<Blade> sample_blades(const scene::MeadowPart& meadow, int variant, int sample) {
  if (!meadow.grass.from_texel.empty()) return from_texel(meadow, variant, sample).blades;
  const MeadowSample of = samples_of(meadow, variant).at(static_cast<std::size_t>(sample));
  const scene::Species species = scene::species_of(meadow).at(static_cast<std::size_t>(of.species));
  const Scattering scattering{meadow.grass.patch_m, of.blades, meadow.seed, variant, sample};
  std::vector<Blade> blades = scatter_blades(species.plant, species.physiology, scattering);
  if (scene::flowers(species)) blades = with_flowers(std::move(blades), species.flower, scattering);
  for (Blade& blade : blades) blade.species = of.species;
  return blades;
}

std::vector<Curve> ageing_rates(const scene::MeadowPart& meadow, int variant) {
  std::vector<Curve> rates;
  for (const MeadowSample& sample : samples_of(meadow, variant))
    rates.push_back(sample.rate ? load_curve(CurveKind::rate, *sample.rate)
                                : Curve({{0.0, 0.0}, {1.0, 1.0}}));
  return rates;
}

Samples::Samples(const scene::MeadowPart& meadow, const TexelShape& shape, int variant,
                 const MeadowModel& model)
    : shape_(shape), rates_(ageing_rates(meadow, variant)) {
  const std::vector<scene::Species> species = scene::species_of(meadow);
  int sample = 0;
  for (const MeadowSample& of : samples_of(meadow, variant)) {
    SampledTexel sampled = meadow.grass.from_texel.empty()
                               ? scattered(meadow, shape, variant, sample)
                               : from_texel(meadow, variant, sample);
    const scene::Physiology& physiology = species[static_cast<std::size_t>(of.species)].physiology;
    samples_.emplace_back(model.of_species(of.species), std::move(sampled.blades),
                          std::move(sampled.points),
                          physiology.merge_distance_voxels * shape.voxel_m);
    ++sample;
  }
}

void Samples::advance_to(double weathering) {
  snow_ = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].advance_to(rates_[i](weathering));
}

void Samples::support_load(double snow) {
  snow_ = snow;
  for (PointDynamics& sample : samples_) sample.support_load(snow);
}

Texel Samples::texel() const {
  std::vector<Texel> texels;
  for (const PointDynamics& sample : samples_) {
    texels.push_back(rasterise_points(sample.points(), shape_));
    if (snow_ == 0.0) continue;
    const Points snow = snow_points(sample.blades(), sample.poses(), shape_.voxel_m);
    if (snow.size() > 0) texels.push_back(rasterise_points(snow, shape_));
  }
  // A single sample is its own sum; adding it up anew would only round it.
  return texels.size() == 1 ? std::move(texels.front()) : mingle(texels);
}

std::size_t Samples::points() const {
  std::size_t sum = 0;
  for (const PointDynamics& sample : samples_) sum += sample.points().size();
  return sum;
}

}  // namespace wold::grass
