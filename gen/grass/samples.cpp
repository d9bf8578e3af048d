#include "grass/samples.h"

#include "core/random.h"
#include "grass/ageing_curves.h"
#include "grass/mingle.h"
#include "grass/rasterise.h"
#include "grass/snow_points.h"

namespace wold::grass {
namespace {

std::uint64_t point_seed(std::uint64_t seed, int variant, int sample) {
  return random_bits({seed, key_of("points"), static_cast<std::uint64_t>(variant),
                      static_cast<std::uint64_t>(sample)});
}

}  // namespace

std::vector<Curve> ageing_rates(const scene::Grass& grass) {
  if (grass.mingle.empty()) return {Curve({{0.0, 0.0}, {1.0, 1.0}})};
  std::vector<Curve> rates;
  for (const scene::CurveChoice& choice : grass.mingle)
    rates.push_back(load_curve(CurveKind::rate, choice));
  return rates;
}

Samples::Samples(const scene::Scene& scene, const TexelShape& shape, int variant,
                 const AgeingModel& model)
    : shape_(shape), rates_(ageing_rates(scene.grass)) {
  for (int sample = 0; sample < sample_count(scene.grass); ++sample) {
    auto blades = scatter_blades(scene.grass, scene.ageing, scene.seed, variant, sample);
    auto points = sample_points(blades, shape, scene.grass.proportion,
                                point_seed(scene.seed, variant, sample));
    samples_.emplace_back(model, std::move(blades), std::move(points),
                          scene.ageing.merge_distance_voxels * shape.voxel_m);
  }
}

void Samples::advance_to(double weathering) {
  snow_ = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i].advance_to(rates_[i](weathering));
}

void Samples::bear(double snow) {
  snow_ = snow;
  for (PointDynamics& sample : samples_) sample.bear(snow);
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
