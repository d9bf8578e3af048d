#include "ground/snowy_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "core/elementary.h"
#include "core/noise.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "place/cell_window.h"
#include "place/ground_grids.h"
#include "place/view.h"
#include "scene/species.h"
#include "scene/winter.h"
#include "snow/lake_ice.h"
#include "snow/wet_ground.h"
#include "terrain/lighting.h"

namespace wold::ground {
namespace {

/// Of a meadow's grass, seen from above: what is reported of the ground's surroundings.
constexpr double grass_albedo = 0.2;

/// Of pictures of the ground.
constexpr double finest_step_m = 0.03;

/// Snow heaps where tufts hold it: a fraction of its depth.
Fbm heaps(std::uint64_t seed) {
  return Fbm(random_bits({seed, key_of("snow cover"), 0, key_of("heaps")}), 3, 0.7);
}
constexpr double heap_feature_m = 0.55;
constexpr double heap_fraction = 0.16;

/// Snow as deep as a step of the map hides a bump of that size: so many passes of smoothing.
int smoothing_passes(double depth_m, double step_m) {
  constexpr double max = 24.0;
  const double radius_steps = 1.2 * depth_m / step_m;
  return static_cast<int>(std::ceil(std::min(max, 2.0 * radius_steps * radius_steps)));
}

/// Fraction of a canopy that stands out of snow; blades lean, so that most of one is in its lower
/// two thirds.
float fraction_above(const scene::Grass& grass, float depth_m) {
  const auto canopy_m = static_cast<float>(0.67 * grass.height_m);
  return std::clamp(1.0F - depth_m / canopy_m, 0.0F, 1.0F);
}

/// Exponent of the canopy's transmittance for snow below: white ground lights the blades from
/// below, laden as they are, and they send most of what they held back down again.
constexpr double shading_under_grass = 0.25;

/// The ground raised by snow: at most smooth, at least a third of the depth above the bare ground.
Heightfield snow_surface(const scene::Scene& scene, const Heightfield& terrain,
                         const FactorMap& depth_m, const FactorMap& white) {
  const Fbm heaped = heaps(scene.seed);
  FactorMap snow_m(terrain.samples(), terrain.size_m());
  parallel_for(static_cast<std::size_t>(terrain.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < terrain.samples(); ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * terrain.step_m();
      const double heap = math::tanh(heaped.at(at_m / heap_feature_m));
      snow_m.at(i, j) = depth_m.sample(at_m.x, at_m.y) * white.sample(at_m.x, at_m.y) *
                        static_cast<float>(1.0 + heap_fraction * heap);
    }
  });
  Heightfield surface = terrain;
  for (std::size_t k = 0; k < surface.values().size(); ++k)
    surface.values()[k] += snow_m.values()[k];
  for (int pass = smoothing_passes(mean(snow_m.values()), terrain.step_m()); pass > 0; --pass)
    smooth(surface);
  for (std::size_t k = 0; k < surface.values().size(); ++k)
    surface.values()[k] =
        std::max(surface.values()[k], terrain.values()[k] + snow_m.values()[k] / 3.0F);
  return surface;
}

/// How coarse snow is where it lies: grains, ripples and what has fallen off blades, as factors on
/// its albedo.
class Grain {
 public:
  Grain(std::uint64_t seed, double step_m)
      : ripples_{random_bits({seed, key_of("snow cover"), 0, key_of("grain")}), 4, 0.4},
        shown_(shown_fraction(feature_m, step_m)) {}
  float at(const glm::dvec2& at_m) const {
    const double ripple = shown_ > 0.0 ? math::tanh(ripples_.at(at_m / feature_m)) : 0.0;
    return static_cast<float>(1.0 - 0.035 * (1.0 + shown_ * ripple));
  }

 private:
  static constexpr double feature_m = 0.25;
  Fbm ripples_;
  double shown_;
};

/// Old snow loses its red first; shadows and depth make it blue (Wiscombe and Warren 1980).
glm::vec3 snow_albedo(float albedo) { return albedo * glm::vec3(0.985F, 1.0F, 1.015F); }

/// The fraction of the light that reaches the ground where grass grows thinner: a power of that
/// under a closed meadow, from a table.
class PartlyUnderGrass {
 public:
  explicit PartlyUnderGrass(const glm::vec3& under_grass) {
    for (std::size_t k = 0; k < powers_.size(); ++k)
      for (int c = 0; c < 3; ++c)
        powers_[k][c] = static_cast<float>(
            math::pow(double{under_grass[c]}, static_cast<double>(k) / (powers_.size() - 1.0)));
  }
  /// growth in [0, 1].
  glm::vec3 operator()(double growth) const {
    const double place = std::clamp(growth, 0.0, 1.0) * (powers_.size() - 1.0);
    const auto below = std::min(static_cast<std::size_t>(place), powers_.size() - 2);
    return glm::mix(powers_[below], powers_[below + 1],
                    static_cast<float>(place - static_cast<double>(below)));
  }

 private:
  std::array<glm::vec3, 65> powers_{};
};

/// Bare ground in the shade of the grass that grows on it.
ColourMap shaded(ColourMap bare, const FactorMap& growth, const glm::vec3& under_grass) {
  const PartlyUnderGrass light(under_grass);
  parallel_for(static_cast<std::size_t>(bare.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < bare.samples(); ++i) {
      const glm::dvec2 at_m = bare.place_m(i, j);
      bare.at(i, j) *= light(double{growth.sample(at_m.x, at_m.y)});
    }
  });
  return bare;
}

/// What is left of bare ground where some of it is white.
ColourMap uncovered(ColourMap bare, const FactorMap& white) {
  parallel_for(static_cast<std::size_t>(bare.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < bare.samples(); ++i) {
      const glm::dvec2 at_m = bare.place_m(i, j);
      bare.at(i, j) *= 1.0F - white.sample(at_m.x, at_m.y);
    }
  });
  return bare;
}

/// Of maps on the same grid; throws std::invalid_argument when they are not.
void multiply(FactorMap& map, const FactorMap& factors) {
  if (map.samples() != factors.samples())
    throw std::invalid_argument("maps of the ground have different grids");
  for (std::size_t k = 0; k < map.values().size(); ++k) map.values()[k] *= factors.values()[k];
}

bool is_paper(const scene::Scene& scene) {
  return scene.snow_cover.cover == scene::CoverModel::paper;
}

}  // namespace

SnowyGround::SnowyGround(const scene::Scene& scene, const place::Site& site, int frame)
    : scene_(scene), site_(site), grass_(scene::mean_grass(scene)), surface_(site.terrain) {
  if (site.water) freeze_water(frame);
  if (!site.snow) return;
  wetness_ =
      snow::ground_wetness(*site.weather, scene::time_s(scene, frame), mean(site.terrain.values()));
  if (site.snow->large) {
    lay_about_the_camera(frame);
  } else if (!place::is_large(scene) || is_paper(scene)) {
    lay_everywhere(frame);
  }
}

void SnowyGround::lay_about_the_camera(int frame) {
  const landscape::Camera camera = place::camera_of_frame(scene_, site_.terrain, frame);
  LyingSnow lying(site_.snow->large->view(scene::time_s(scene_, frame), glm::dvec2(camera.eye_m)));
  if (lying.is_none()) return;
  lying_ = std::move(lying);
  snow_line_.emplace(site_.terrain, scene_.snow_cover.feature_m, scene_.seed);
  albedo_ = lying_->albedo();
  carve(frame);
  white_ = white(place::whole_grid(scene_), site_.ledges);
  parallel_for(static_cast<std::size_t>(surface_.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < surface_.samples(); ++i)
      surface_.at(i, j) += depth_m(surface_.place_m(i, j));
  });
  // Else the squares before the camera alone would show what snow hides and wind carves.
  if (!site_.sketch && snow::Bedforms::is_shown(place::whole_grid(scene_).step_m()))
    light_ = place::light_in_frame(scene_, site_, frame, layer());
}

void SnowyGround::lay_everywhere(int frame) {
  const snow::SnowGround& snow = site_.snow->ground;
  const snow::SnowGround::State state = snow.at(scene::time_s(scene_, frame));
  if (!(state.fallen_mm > 0.0)) return;
  depth_m_ = state.depth_m;
  albedo_ = static_cast<float>(mean(state.albedo.values()));
  const std::optional<place::Sketch>& sketch = site_.sketch;
  white_ = snow.white(state, sketch ? sketch->ground_samples : place::snow_grid(scene_).samples);
  keep_from_water(depth_m_);
  keep_from_water(*white_);
  clear_steep_sides(*white_);
  if (is_paper(scene_)) return;  // the ground's shape stays
  carve(frame);
  surface_ = snow_surface(scene_, site_.terrain, depth_m_, *white_);
  light_ = place::whole_light(site_, surface_, layer());
}

void SnowyGround::keep_from_water(FactorMap& snow) const {
  if (!site_.water) return;
  parallel_for(static_cast<std::size_t>(snow.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < snow.samples(); ++i)
      snow.at(i, j) *= holds_snow(snow.place_m(i, j), snow.step_m());
  });
}

void SnowyGround::clear_steep_sides(FactorMap& white) const {
  if (!site_.boulders) return;
  const terrain::Surface surface = site_.surface({white.square(), white.samples()}, {}, layer());
  parallel_for(static_cast<std::size_t>(white.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < white.samples(); ++i) {
      const double cover = surface.boulder(i, j).cover;
      if (cover <= 0.0) continue;
      const double steep = 1.0 - surface.holds_snow(i, j);
      white.at(i, j) *= static_cast<float>(1.0 - cover * steep);
    }
  });
}

const terrain::GroundLight& SnowyGround::light() const { return light_ ? *light_ : site_.light; }

std::optional<terrain::GroundLight> SnowyGround::uncarved_light() const {
  if (!light_ || !bedforms_) return std::nullopt;
  return lying_ ? site_.light : place::whole_light(site_, surface_, {layer().depth_m, {}});
}

void SnowyGround::freeze_water(int frame) {
  constexpr int heights = 9;
  const auto [lowest, highest] = std::ranges::minmax_element(site_.terrain.values());
  lowest_m_ = double{*lowest};
  highest_m_ = double{*highest};
  for (int k = 0; k < heights; ++k)
    ice_m_.push_back(snow::lake_ice_m(*site_.weather, scene::time_s(scene_, frame),
                                      std::lerp(lowest_m_, highest_m_, k / (heights - 1.0))));
}

double SnowyGround::frozen(const glm::dvec2& at_m) const {
  constexpr double first_m = 0.01, closed_m = 0.05;
  if (ice_m_.empty()) return 0.0;
  const double rise = (site_.water->level_m(at_m) - lowest_m_) / (highest_m_ - lowest_m_ + 1e-9);
  const double place = std::clamp(rise, 0.0, 1.0) * static_cast<double>(ice_m_.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), ice_m_.size() - 2);
  return glm::smoothstep(
      first_m, closed_m,
      std::lerp(ice_m_[below], ice_m_[below + 1], place - static_cast<double>(below)));
}

/// What falls into open water is gone.
float SnowyGround::holds_snow(const glm::dvec2& at_m, double step_m) const {
  if (!site_.water) return 1.0F;
  const double share = site_.water->share(at_m, step_m);
  return share > 0.0 ? static_cast<float>(1.0 - share * (1.0 - frozen(at_m))) : 1.0F;
}

ColourMap SnowyGround::iced(ColourMap bare) const {
  if (std::ranges::none_of(ice_m_, [](double ice_m) { return ice_m > 0.0; })) return bare;
  // Bare ice of lakes, grey and a little blue: 0.3 to 0.4 without bubbles ([Bolsenga1969]).
  constexpr glm::vec3 ice(0.30F, 0.34F, 0.36F);
  parallel_for(static_cast<std::size_t>(bare.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < bare.samples(); ++i) {
      const glm::dvec2 at_m = bare.place_m(i, j);
      const double share = site_.water->share(at_m, bare.step_m());
      if (share <= 0.0) continue;
      bare.at(i, j) = glm::mix(bare.at(i, j), ice / std::numbers::pi_v<float>,
                               static_cast<float>(share * frozen(at_m)));
    }
  });
  return bare;
}

float SnowyGround::depth_m(const glm::dvec2& at_m) const {
  if (lying_) return lying_->depth_m(at_m) * holds_snow(at_m, surface_.step_m());
  return is_bare() ? 0.0F : depth_m_.sample(at_m.x, at_m.y);
}

terrain::SnowSurface SnowyGround::layer() const {
  if (is_bare()) return {};
  terrain::SnowSurface snow{[this](const glm::dvec2& at_m) { return double{depth_m(at_m)}; }, {}};
  if (bedforms_)
    snow.carved = [this](const glm::dvec2& at_m, double step_m) { return carved(at_m, step_m); };
  return snow;
}

void SnowyGround::carve(int frame) {
  constexpr double usual_drifting = 0.5;
  const scene::SnowCover& cover = scene_.snow_cover;
  carved_ = cover.drifting / usual_drifting *
            snow::shaped_by_wind(*site_.weather, scene::time_s(scene_, frame),
                                 mean(site_.terrain.values()), cover.initial_mm > 0.0);
  if (carved_ > 0.0) bedforms_.emplace(snow::shaping_heading_deg(*site_.weather), scene_.seed);
}

/// Wind carves thin snow less deeply, and none in which grass stands.
glm::dvec2 SnowyGround::carved(const glm::dvec2& at_m, double step_m) const {
  constexpr double deep_m = 0.3;
  if (!snow::Bedforms::is_shown(step_m)) return glm::dvec2(0.0);
  const float grown = grass_above(at_m) * site_.growth.sample(at_m.x, at_m.y);
  const double open = std::max(1.0 - 2.0 * double{grown}, 0.0);
  const double depth = std::min(double{depth_m(at_m)} / deep_m, 1.0);
  const double fraction = carved_ * depth * open;
  return fraction > 0.0 ? fraction * bedforms_->ascent(at_m, step_m) : glm::dvec2(0.0);
}

float SnowyGround::white_fraction(const glm::dvec2& at_m) const {
  if (lying_) return white_without_walls(at_m) * site_.ledges->sample(at_m.x, at_m.y);
  return is_bare() ? 0.0F : white_->sample(at_m.x, at_m.y);
}

float SnowyGround::white_without_walls(const glm::dvec2& at_m) const {
  return lying_->fraction(at_m) * holds_snow(at_m, finest_step_m);
}

/// The fraction of a part of a large terrain that is white, patch by patch where its grid is fine:
/// what snow whitens of level ground, on the ledges of steep ground.
FactorMap SnowyGround::white(const GroundGrid& grid, const std::optional<FactorMap>& ledges) const {
  FactorMap fractions(grid.samples, grid.square);
  parallel_for(static_cast<std::size_t>(grid.samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < grid.samples; ++i) {
      const glm::dvec2 at_m = fractions.place_m(i, j);
      fractions.at(i, j) = lying_ ? white_without_walls(at_m) : white_fraction(at_m);
    }
  });
  if (!lying_) return fractions;
  FactorMap white = snow_line_->white_map(fractions);
  multiply(white, *ledges);
  return white;
}

ColourMap SnowyGround::reflectance(const glm::vec3& under_grass) const {
  ColourMap bare = wetted(site_.ground_reflectance);
  return is_bare() ? shaded(std::move(bare), site_.growth, under_grass)
                   : reflectance(std::move(bare), site_.growth, *white_, under_grass);
}

ColourMap SnowyGround::bare() const {
  ColourMap bare = wetted(site_.ground_reflectance);
  return is_bare() ? bare : uncovered(std::move(bare), *white_);
}

ColourMap SnowyGround::albedo() const {
  ColourMap albedo = reflectance(glm::vec3(1.0F));
  for (glm::vec3& value : albedo.values())
    value = glm::min(std::numbers::pi_v<float> * value, glm::vec3(1.0F));
  return albedo;
}

SnowyGround::CoveredPart SnowyGround::covered(place::GroundPart part,
                                              const glm::vec3& under_grass) const {
  ColourMap bare = wetted(std::move(part.reflectance));
  if (is_bare()) {
    part.reflectance = shaded(bare, part.growth, under_grass);
    return {std::move(part), std::move(bare)};
  }
  const FactorMap of_part = white({bare.square(), bare.samples()}, part.ledges);
  part.reflectance = reflectance(bare, part.growth, of_part, under_grass);
  part.growth = above_snow(std::move(part.growth));
  return {std::move(part), uncovered(std::move(bare), of_part)};
}

ColourMap SnowyGround::wetted(ColourMap bare) const {
  bare = iced(std::move(bare));
  if (wetness_ <= 0.0) return bare;
  constexpr float pi = std::numbers::pi_v<float>;
  const auto fraction = static_cast<float>(wetness_);
  parallel_for_blocks(bare.values().size(), [&](std::size_t i) {
    glm::vec3& radiance = bare.values()[i];
    for (int channel = 0; channel < 3; ++channel) {
      const auto wet = static_cast<float>(snow::wet_albedo(double{pi * radiance[channel]}));
      radiance[channel] = std::lerp(radiance[channel], wet / pi, fraction);
    }
  });
  return bare;
}

float SnowyGround::grass_above(const glm::dvec2& at_m) const {
  if (is_paper(scene_)) return 1.0F - white_->sample(at_m.x, at_m.y);
  return fraction_above(grass_, depth_m(at_m));
}

FactorMap SnowyGround::above_snow(FactorMap growth) const {
  parallel_for(static_cast<std::size_t>(growth.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < growth.samples(); ++i) growth.at(i, j) *= grass_above(growth.place_m(i, j));
  });
  return growth;
}

FactorMap SnowyGround::extinction_factor(FactorMap extinction_factor) const {
  return is_paper(scene_) && !is_bare() ? above_snow(std::move(extinction_factor))
                                        : extinction_factor;
}

ColourMap SnowyGround::reflectance(ColourMap bare, const FactorMap& growth,
                                   const FactorMap& white_fraction,
                                   const glm::vec3& under_grass) const {
  bare = shaded(std::move(bare), growth, under_grass);
  ColourMap map(white_fraction.samples(), white_fraction.square());
  const Grain grain(scene_.seed, map.step_m());
  const PartlyUnderGrass light(under_grass);
  const glm::vec3 snow = snow_albedo(albedo_) / std::numbers::pi_v<float>;
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec2 at_m = map.place_m(i, j);
      const double shade = shading_under_grass * grass_above(at_m) * growth.sample(at_m.x, at_m.y);
      const glm::vec3 white = snow * grain.at(at_m) * light(shade);
      map.at(i, j) = glm::mix(bare.sample(at_m.x, at_m.y), white, white_fraction.at(i, j));
    }
  });
  return map;
}

FactorMap SnowyGround::growth() const {
  return is_bare() ? site_.growth : above_snow(site_.growth);
}

double SnowyGround::white_fraction() const { return is_bare() ? 0.0 : mean(white_->values()); }

double SnowyGround::mean_albedo() const {
  return std::lerp(grass_albedo, double{albedo_}, white_fraction());
}

}  // namespace wold::ground
