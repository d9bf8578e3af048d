#include "grass/texel/time_varying_texel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/elementary.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/random.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/blade_tubes.h"
#include "grass/geometry/meadow_samples.h"
#include "grass/geometry/point_tubes.h"
#include "grass/texel/baking.h"
#include "grass/texel/lods.h"
#include "grass/texel/samples.h"
#include "grass/texel/texel_file.h"
#include "scene/key_frames.h"
#include "scene/species.h"
#include "scene/write.h"

namespace wold::grass {
namespace {

/// Adds the time since it was made to a sum when it goes.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void add(StageTimes& to, const StageTimes& from) {
  to.sampling += from.sampling;
  to.dynamics += from.dynamics;
  to.conversion += from.conversion;
  to.baking += from.baking;
  to.storing += from.storing;
  to.steps += from.steps;
  to.points += from.points;
}

/// Of a blade's highest point over its foot.
double rise_m(const Blade& blade, const scene::Physiology& physiology, double water_lost) {
  // Blades that move by steps bow from the straight one; how far, only the steps tell.
  if (physiology.motion == scene::AgeingMotion::points)
    return double{blade.length_m * math::cos(blade.lean)};
  const BladePose pose = blade_pose(blade, physiology, water_lost, 1.0);
  const BladeAxis axis(blade, pose);
  double highest = 0.0;
  for (int i = 1; i <= 16; ++i) {
    const float arc_m = blade.length_m * pose.length_scale * static_cast<float>(i) / 16.0F;
    highest = std::max(highest, double{axis.at(arc_m).position_m.y});
  }
  // Petals are highest where they are widest.
  if (sits_on_stalk(blade))
    highest = std::max(highest, double{blade.radius_m * math::sin(blade.lean)});
  return highest;
}

/// Highest point of any blade at any time: withering only lowers grass, drying only raises hair.
double tallest_m(const scene::MeadowPart& meadow) {
  const std::vector<scene::Species> species = scene::species_of(meadow);
  double tallest = 0.0;
  for (int variant = 0; variant < scene::patch_count(meadow); ++variant) {
    const int samples = static_cast<int>(samples_of(meadow, variant).size());
    for (int sample = 0; sample < samples; ++sample)
      for (const Blade& blade : sample_blades(meadow, variant, sample)) {
        const scene::Physiology& physiology =
            species[static_cast<std::size_t>(blade.species)].physiology;
        const double rise =
            std::max(rise_m(blade, physiology, 0.0), rise_m(blade, physiology, 1.0));
        tallest = std::max(tallest, double{blade.root_height_m} + rise);
      }
  }
  return tallest;
}

TexelShape finest_shape(const scene::MeadowPart& meadow) {
  const int side = meadow.grass.lods.front();
  const double voxel_m = meadow.grass.patch_m / side;
  // Two voxels more: one for the point's footprint, one for the cone's width.
  return {side, static_cast<int>(std::ceil(tallest_m(meadow) / voxel_m)) + 2, voxel_m};
}

/// Shrubs have around them what else grows on their patch, and other shrubs as often as they grow
/// anywhere.
FibreLook fibre_look(const scene::MeadowPart& meadow, int variant) {
  FibreLook look{static_cast<float>(meadow.grass.specular_exponent),
                 scene::mean_grass(meadow).width_m};
  const std::vector<scene::Species> species = scene::species_of(meadow);
  double shrubs = 0.0;
  for (const int one : scene::mixture_of(meadow, variant)) {
    const scene::Species& grown = species[static_cast<std::size_t>(one)];
    if (scene::is_shrub(grown)) {
      shrubs += grown.habitat.cover;
      look.like_neighbours = std::min(shrubs, 1.0);
    } else if (!scene::flowers(grown)) {
      look.neighbours_m = std::max(look.neighbours_m, scene::standing_m(grown.plant));
    }
  }
  return look;
}

/// Every turn that any level wants, ascending.
std::vector<int> all_turns(const LodTurns& lods) {
  std::set<int> turns;
  for (const auto& lod : lods) turns.insert(lod.second.begin(), lod.second.end());
  return {turns.begin(), turns.end()};
}

/// Everything a texel depends on, as text: the scene without what changes no texel, the light and
/// the models.
std::string described(const scene::MeadowPart& meadow, const Lighting& lighting) {
  const scene::Scene plain;
  scene::Scene relevant;
  relevant.seed = meadow.seed;
  relevant.grass = meadow.grass;
  relevant.grass.key_frames = scene::key_frames(meadow);
  relevant.grass.pixels_per_voxel = plain.grass.pixels_per_voxel;
  relevant.grass.far_field_below_pixels = plain.grass.far_field_below_pixels;
  relevant.grass.unevenness = plain.grass.unevenness;
  relevant.ageing = meadow.ageing;
  relevant.species = meadow.species;
  for (scene::Species& species : relevant.species) {
    const double cover = species.habitat.cover;
    species.habitat = {};
    if (scene::is_shrub(species)) species.habitat.cover = cover;  // how far it shades others
  }
  relevant.ageing.frames = plain.ageing.frames;
  relevant.ageing.age_spread = plain.ageing.age_spread;
  relevant.ageing.age_spread_feature_m = plain.ageing.age_spread_feature_m;
  relevant.ageing.pigment_spread = plain.ageing.pigment_spread;
  relevant.ageing.pigment_spread_feature_m = plain.ageing.pigment_spread_feature_m;
  const auto three = [](const auto& v) { return fmt::format(" {},{},{}", v.x, v.y, v.z); };
  relevant.grass.from_texel = plain.grass.from_texel;
  std::string text = texel_models() + scene::settings_text(relevant);
  text += three(lighting.sun_direction) + three(lighting.sun_irradiance) +
          three(lighting.eye_direction) + three(lighting.ground_albedo);
  for (const glm::vec3& radiance : lighting.sky_radiance) text += three(radiance);
  if (!meadow.grass.from_texel.empty()) text += content_hash(read_file(meadow.grass.from_texel));
  return text;
}

}  // namespace

std::string texel_models() {
  constexpr int version = 8;  // raise when the same scene and models give other texels
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped_file("models")))
    if (entry.is_regular_file() && entry.path().parent_path().filename() != "cloud")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string text = fmt::format("{}", version);
  for (const auto& file : files)
    text += fmt::format(" {} {}", file.filename().string(), content_hash(read_file(file)));
  return content_hash(text);
}

TimeVaryingTexel::TimeVaryingTexel(const scene::MeadowPart& meadow, std::vector<Lighting> lights,
                                   std::filesystem::path folder, TexelFiles files)
    : meadow_(meadow),
      key_frames_(scene::key_frames(meadow)),
      lights_(std::move(lights)),
      folder_(std::move(folder)),
      files_(files),
      shape_(finest_shape(meadow)),
      model_(meadow) {
  for (const Lighting& lighting : lights_) bases_.push_back(described(meadow_, lighting));
}

const Lighting& TimeVaryingTexel::lighting(const PatchState& state) const {
  return lights_.at(static_cast<std::size_t>(state.light));
}

TexelShape TimeVaryingTexel::lod_shape(int lod) const {
  TexelShape shape = shape_;
  for (int coarser = 1; coarser <= lod; ++coarser)
    shape = coarse_shape(shape, meadow_.grass.lods[static_cast<std::size_t>(coarser)]);
  return shape;
}

std::filesystem::path TimeVaryingTexel::texel_path(int variant, const PatchState& state) const {
  return folder_ / fmt::format("v{}_{}.vdb", variant, state.unlit().name());
}

std::filesystem::path TimeVaryingTexel::volume_path(int variant, const PatchState& state,
                                                    int lod) const {
  const int side = meadow_.grass.lods[static_cast<std::size_t>(lod)];
  return folder_ / fmt::format("v{}_{}_{:03}.vdb", variant, state.name(), side);
}

std::string TimeVaryingTexel::content(int variant, const PatchState& state) const {
  std::string snow;
  if (state.snow > 0) snow = fmt::format(" snow {} of {}", state.snow, snow_levels);
  std::string species;
  if (const scene::Mixture mixture = scene::mixture_of(meadow_, variant);
      mixture.size() < scene::species_of(meadow_).size())
    species = fmt::format(" species {}", fmt::join(mixture, ","));
  return content_hash(fmt::format("{} {} {}{}{}", variant, state.key_frame,
                                  bases_.at(static_cast<std::size_t>(state.light)), snow, species));
}

std::string TimeVaryingTexel::volume_content(int variant, const PatchState& state, int lod,
                                             const std::set<int>& turns) const {
  return content_hash(fmt::format("{} {} {}", content(variant, state), lod, fmt::join(turns, ",")));
}

BladePatch TimeVaryingTexel::patch(int variant, const PatchState& state) const {
  return WitheringPatch(meadow_, model_, variant)
      .at(key_frames_[static_cast<std::size_t>(state.key_frame)], state.snow_fraction());
}

Tubes TimeVaryingTexel::blades(int variant, const PatchState& state, double shadow_pixel_m) const {
  return blade_tubes(patch(variant, state), model_, lighting(state), fibre_look(meadow_, variant),
                     shadow_pixel_m);
}

Tubes TimeVaryingTexel::bent_blades(int variant, const PatchState& state, const BladeBend& bend,
                                    const Tubes& straight) const {
  return bent(straight, blade_places(patch(variant, state), model_), bend);
}

Tubes TimeVaryingTexel::points(int variant, const PatchState& state) const {
  const auto now = static_cast<std::size_t>(state.key_frame);
  Samples samples(meadow_, shape_, variant, model_);
  for (std::size_t step = 0; step <= now; ++step) samples.advance_to(key_frames_[step]);
  if (state.snow > 0) samples.support_load(state.snow_fraction());
  return point_tubes(patch(variant, state), samples.all(), lighting(state),
                     fibre_look(meadow_, variant), shape_.voxel_m);
}

void TimeVaryingTexel::add_leaf_shades(int variant, const PatchState& state, Tubes& blades) const {
  grass::add_leaf_shades(patch(variant, state), model_, blades);
}

bool TimeVaryingTexel::is_current(int variant, const PatchState& state,
                                  const LodTurns& lods) const {
  if (files_ == TexelFiles::baked_and_unlit &&
      file_content(texel_path(variant, state)) != content(variant, state.unlit()))
    return false;
  return std::all_of(lods.begin(), lods.end(), [&](const auto& lod) {
    return file_content(volume_path(variant, state, lod.first)) ==
           volume_content(variant, state, lod.first, lod.second);
  });
}

StageTimes TimeVaryingTexel::generate(const TexelDemand& demand, Progress& progress) const {
  make_folder(folder_);
  std::vector<std::pair<int, std::map<PatchState, LodTurns>>> missing;
  std::size_t count = 0;
  for (const auto& [variant, states] : demand) {
    missing.emplace_back(variant, std::map<PatchState, LodTurns>{});
    for (const auto& [state, lods] : states)
      if (!is_current(variant, state, lods)) missing.back().second[state] = lods;
    count += missing.back().second.size();
  }
  progress.begin("texels", count);
  std::vector<StageTimes> times(missing.size());
  parallel_for(missing.size(), [&](std::size_t i) {
    if (!missing[i].second.empty())
      times[i] = generate_variant(missing[i].first, missing[i].second, progress);
  });
  progress.end();
  StageTimes total;
  for (const StageTimes& one : times) add(total, one);
  return total;
}

StageTimes TimeVaryingTexel::generate_variant(int variant,
                                              const std::map<PatchState, LodTurns>& states,
                                              Progress& progress) const {
  StageTimes times;
  Samples samples = [&] {
    const Stopwatch watch(times.sampling);
    return Samples(meadow_, shape_, variant, model_);
  }();
  auto wanted = states.begin();
  for (int key_frame = 0; wanted != states.end(); ++key_frame) {
    {
      const Stopwatch watch(times.dynamics);
      samples.advance_to(key_frames_[static_cast<std::size_t>(key_frame)]);
    }
    ++times.steps;
    times.points += static_cast<long>(samples.points());
    for (; wanted != states.end() && wanted->first.key_frame == key_frame; ++wanted) {
      if (wanted->first.snow > 0) {
        const Stopwatch watch(times.dynamics);
        samples.support_load(wanted->first.snow_fraction());
      }
      make_texel(variant, wanted->first, samples, wanted->second, times);
      progress.advance(1, texel_path(variant, wanted->first).stem().string());
    }
  }
  return times;
}

void TimeVaryingTexel::make_texel(int variant, const PatchState& state, const Samples& samples,
                                  const LodTurns& lods, StageTimes& times) const {
  const scene::Grass& grass = meadow_.grass;
  Texel texel;
  {
    const Stopwatch watch(times.conversion);
    texel = samples.texel();
  }
  std::vector<VolumeData> baked;
  {
    const Stopwatch watch(times.baking);
    baked = bake_lods(texel, samples.all(), lighting(state), fibre_look(meadow_, variant),
                      grass.lods, all_turns(lods));
  }
  const Stopwatch watch(times.storing);
  store(variant, state, texel, baked, lods);
}

void TimeVaryingTexel::store(int variant, const PatchState& state, const Texel& texel,
                             const std::vector<VolumeData>& baked, const LodTurns& lods) const {
  for (const auto& [lod, turns] : lods)
    write_volume(volume_path(variant, state, lod), baked[static_cast<std::size_t>(lod)], turns,
                 volume_content(variant, state, lod, turns));
  if (files_ == TexelFiles::baked) return;
  const std::filesystem::path path = texel_path(variant, state);
  const std::string made_from = content(variant, state.unlit());
  if (file_content(path) != made_from) write_texel(path, texel, made_from);
}

}  // namespace wold::grass
