#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/tiled_image.h"
#include "scene/parts.h"
#include "snow/cover.h"

namespace wold::snow {

/// A square terrain that may be larger than memory: samples x samples heights, step_m apart.
struct LargeGround {
  int samples = 2;
  double step_m = 1.0;
  /// Fills in the heights of side x side samples from `first` on, row by row, x fastest. Called by
  /// several threads at a time.
  std::function<void(const glm::ivec2& first, int side, std::span<float> heights_m)> heights;
};

/// A terrain in memory, which has to outlive it.
LargeGround large_ground(const Heightfield& terrain);

/// What lies on a square about the camera: side x side samples, x fastest.
struct CoverLevel {
  int side = 0;
  double step_m = 0.0;
  glm::dvec2 first_m = {};  ///< of sample (0, 0) from the terrain's south-western corner
  std::vector<float> depth_m;
  std::vector<float> white;   ///< fraction of the ground
  std::vector<float> albedo;  ///< of the snow, in visible light
};

/// The snow of a ground of any size: on disk as tiled pictures, in memory a few tiles and what the
/// camera sees. It is SnowGround's reckoning by the hours of snow_clock(), tile by tile. Each tile
/// is reckoned with an apron of its neighbours' ground and snow, so that wind and slides pass over
/// its borders; what is left out is snow that slides farther than the apron's 16 samples within one
/// pass (a day at most) over the ground.
class LargeCover {
 public:
  struct Limits {
    int tile_samples = 256;   ///< side of a tile; a multiple of 16
    int tiles_at_a_time = 8;  ///< in memory, with their aprons
    double cache_mb = 64.0;   ///< of tiles that are read
    int view_samples = 64;    ///< along a side of a view's squares; a multiple of 16
  };

  /// `folder` exists and is this object's alone: it keeps the two hours of the latest view there,
  /// as "hour_<hour since the weather began>_level_<l>.tif" with the channels water in mm, depth
  /// in m and age, in a season also what snowpack::SnowState holds and lacks in mm; a level has
  /// half the samples of the one before. First it writes, tile by tile, "ground.tif" with heights
  /// and max_depths_m(), and later "drift_<heading>.tif" for each wind that comes. Rows of
  /// pictures go north. The scene's cover is "depth". Throws InputError for heights that are no
  /// numbers, FileError for the disk.
  LargeCover(const scene::SnowCoverPart& part, const LargeGround& ground, WeatherFunction weather,
             std::filesystem::path folder, Limits limits);

  /// Brings the pictures of an hour of snow_clock(), since the weather began, to disk, from the
  /// latest earlier hour that is there, and removes those of all hours but it and the clock's one
  /// before. Throws InputError for weather that is no number, FileError for the disk.
  void integrate(int hour);

  /// What lies about a place at a time since the first frame: squares of at most view_samples^2
  /// samples about it, each with twice the step of the one before, the last over the whole ground.
  /// Between whole hours all of it changes evenly. What it costs does not depend on the ground's
  /// size, but for hours that are new. One call at a time.
  std::vector<CoverLevel> view(double time_s, const glm::dvec2& eye_m);

 private:
  struct Window;
  /// What lies on a square of a level at a whole hour, kept for the next view.
  struct Square {
    int hour = -1;
    glm::ivec2 first = {};
    CoverLevel lying;
  };

  int channels() const;
  TiledExtent extent(int level) const;
  TiledExtent extent_of(int channels) const;
  std::filesystem::path picture(int hour, int level) const;
  void write_ground(const LargeGround& ground);
  void write_drift(int heading_deg);
  void pass(int from_hour, int to_hour);
  int bare_until(int from_hour, int to_hour) const;
  WeatherMoment weather_during(int hour) const;
  void remove(int hour);
  Window window(const glm::ivec2& tile) const;
  std::vector<float> read(const std::filesystem::path& path, const Window& window,
                          int channels) const;
  SnowpackField packs(const Window& window, int hour) const;
  std::pair<Heightfield, FactorMap> ground(const Window& window) const;
  std::vector<float> drift(const Window& window, int heading_deg) const;
  SnowpackField after(const Window& window, SnowpackField packs,
                      const std::vector<WeatherMoment>& hours) const;
  int step_at(double hours) const;
  const CoverLevel& square(int level, int hour, const glm::ivec2& first, int side);
  CoverLevel level_view(int level, double hours, const glm::dvec2& eye_m);

  scene::SnowCover cover_;
  Snowpack first_;
  bool is_season_;
  SnowClock clock_;
  double earlier_s_;
  int samples_;
  double step_m_;
  WeatherFunction weather_;
  std::filesystem::path folder_;
  Limits limits_;
  TiledImages images_;
  int levels_ = 1;
  std::set<int> hours_;                         ///< on disk
  std::set<int> bare_hours_;                    ///< of these, at which no snow lies anywhere
  std::array<float, 2> lowest_to_highest_m_{};  ///< of the ground
  struct Drift {
    std::filesystem::path weights;
    double mean;
  };
  std::map<int, Drift> drifts_;                 ///< drift_weights() by heading
  std::vector<std::array<Square, 2>> squares_;  ///< by level and whether the step is odd
};

}  // namespace wold::snow
