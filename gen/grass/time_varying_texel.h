#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/progress.h"
#include "core/tubes.h"
#include "grass/dynamics.h"
#include "grass/shading.h"
#include "grass/texel.h"
#include "grass/volume_data.h"
#include "scene/scene.h"

namespace wold::grass {

/// Quarter-turns wanted of each level of one texel.
using LevelTurns = std::map<int, std::set<int>>;
/// What a film needs: demand[variant][key frame][level] = turns.
using TexelDemand = std::map<int, std::map<int, LevelTurns>>;

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

/// The time-varying texel of a scene's meadow, T(x, y, z, wd): computed on demand and kept in a
/// folder of .vdb files, one `v<variant>_k<key frame>.vdb` for the texel itself and one
/// `v<variant>_k<key frame>_<side>.vdb` for each demanded level, baked for the scene's light.
class TimeVaryingTexel {
 public:
  /// `lighting` is what the levels are baked for. Throws what AgeingModel's constructor throws.
  TimeVaryingTexel(const scene::Scene& scene, Lighting lighting, std::filesystem::path folder);

  /// Extent of the finest level: high enough for the tallest blade of any variant.
  const TexelShape& shape() const { return shape_; }
  /// Extent of a level of the scene.
  TexelShape level_shape(int level) const;

  /// Makes what is demanded and not in the folder yet. Variants run in parallel, key frames in
  /// order. Throws FileError; whole files stay, so a later call resumes.
  StageTimes generate(const TexelDemand& demand, Progress& progress) const;

  /// The blades that a variant's texel stands for at a key frame, and the points it is made of,
  /// shaded for the same light.
  Tubes blades(int variant, int key_frame) const;
  Tubes points(int variant, int key_frame) const;
  /// What both were made from: equal for equal tubes.
  std::string content(int variant, int key_frame) const;

  /// Files of generate(); `level` indexes the scene's levels.
  std::filesystem::path texel_path(int variant, int key_frame) const;
  std::filesystem::path volume_path(int variant, int key_frame, int level) const;

  /// What a demanded level's file was made from: equal for equal files.
  std::string volume_content(int variant, int key_frame, int level,
                             const std::set<int>& turns) const;

 private:
  bool is_current(int variant, int key_frame, const LevelTurns& levels) const;
  StageTimes generate_variant(int variant, const std::map<int, LevelTurns>& key_frames,
                              Progress& progress) const;
  void store(int variant, int key_frame, const Texel& texel, const std::vector<VolumeData>& baked,
             const LevelTurns& levels) const;

  scene::Scene scene_;
  std::vector<double> key_frames_;  ///< weathering degrees
  Lighting lighting_;
  std::filesystem::path folder_;
  TexelShape shape_;
  AgeingModel model_;
  std::string basis_;  ///< everything the texels depend on
};

}  // namespace wold::grass
