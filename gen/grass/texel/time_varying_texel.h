#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/tubes.h"
#include "grass/ageing/patch_state.h"
#include "grass/geometry/blade_bend.h"
#include "grass/mechanics/meadow_model.h"
#include "grass/optics/blade_light.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"
#include "grass/texel/samples.h"
#include "grass/texel/texel.h"
#include "grass/texel/volume_data.h"
#include "scene/parts.h"

namespace wold::grass {

/// Quarter-turns wanted of each level of one texel.
using LodTurns = std::map<int, std::set<int>>;
/// What a film needs: demand[variant][key frame and snow][level] = turns.
using TexelDemand = std::map<int, std::map<PatchState, LodTurns>>;

/// Seconds that the threads together spent in each step of making texels, for the benchmark.
struct StageTimes {
  double sampling = 0.0;    ///< cones to voxels to points
  double dynamics = 0.0;    ///< Algorithm 1
  double conversion = 0.0;  ///< points to texel, mingling
  double baking = 0.0;      ///< extinction, shading, levels
  double storing = 0.0;     ///< .vdb files
  long steps = 0;           ///< of point dynamics
  long points = 0;          ///< over all steps
};

/// What texels depend on besides their scene and light, as a hash: the tables in models/ and how
/// this version of the program makes texels of them.
std::string texel_models();

/// Which files a time-varying texel is kept in. That without light is two thirds of all bytes, and
/// renderers that show baked light do not read it.
enum class TexelFiles { baked, baked_and_unlit };

/// The time-varying texel of a scene's meadow, T(x, y, z, wd): computed on demand and kept in a
/// folder of .vdb files, one `v<variant>_<state>_<side>.vdb` for each demanded level, baked for the
/// state's light, and, if wanted, one `v<variant>_<state>.vdb` for the texel itself, which has no
/// light; the state is PatchState's name.
class TimeVaryingTexel {
 public:
  /// `lights` are what the levels are baked for, by PatchState::light; one at least. Throws what
  /// MeadowModel's constructor throws.
  TimeVaryingTexel(const scene::MeadowPart& meadow, std::vector<Lighting> lights,
                   std::filesystem::path folder, TexelFiles files = TexelFiles::baked_and_unlit);

  /// Extent of the finest level: high enough for the tallest blade of any variant.
  const TexelShape& shape() const { return shape_; }
  /// Extent of a level of the scene.
  TexelShape lod_shape(int lod) const;

  /// Makes what is demanded and not in the folder yet. Variants run in parallel, key frames in
  /// order, each under all the snow it is wanted with. Throws FileError; whole files stay, so a
  /// later call resumes.
  StageTimes generate(const TexelDemand& demand, Progress& progress) const;

  /// The blades that a variant's texel stands for in a state, and the points it is made of, shaded
  /// for the same light; `shadow_pixel_m` is place_radiance()'s.
  Tubes blades(int variant, const PatchState& state,
               double shadow_pixel_m = fine_shadow_pixel_m) const;
  Tubes points(int variant, const PatchState& state) const;
  /// The blades() of that variant and state as wind bends them; their light stays.
  Tubes bent_blades(int variant, const PatchState& state, const BladeBend& bend,
                    const Tubes& straight) const;
  /// Sets reflectance and transmittance of the blades() of that variant and state.
  void add_leaf_shades(int variant, const PatchState& state, Tubes& blades) const;
  /// What both were made from: equal for equal tubes.
  std::string content(int variant, const PatchState& state) const;

  /// Files of generate(); `lod` indexes the scene's levels.
  std::filesystem::path texel_path(int variant, const PatchState& state) const;
  std::filesystem::path volume_path(int variant, const PatchState& state, int lod) const;

  /// What a demanded level's file was made from: equal for equal files.
  std::string volume_content(int variant, const PatchState& state, int lod,
                             const std::set<int>& turns) const;

 private:
  const Lighting& lighting(const PatchState& state) const;
  BladePatch patch(int variant, const PatchState& state) const;
  bool is_current(int variant, const PatchState& state, const LodTurns& lods) const;
  StageTimes generate_variant(int variant, const std::map<PatchState, LodTurns>& states,
                              Progress& progress) const;
  /// Texel and levels of the samples as they stand; adds to the times.
  void make_texel(int variant, const PatchState& state, const Samples& samples,
                  const LodTurns& lods, StageTimes& times) const;
  void store(int variant, const PatchState& state, const Texel& texel,
             const std::vector<VolumeData>& baked, const LodTurns& lods) const;

  scene::MeadowPart meadow_;
  std::vector<double> key_frames_;  ///< weathering degrees
  std::vector<Lighting> lights_;
  std::filesystem::path folder_;
  TexelFiles files_;
  TexelShape shape_;
  MeadowModel model_;
  std::vector<std::string> bases_;  ///< everything the texels depend on, by light
};

}  // namespace wold::grass
