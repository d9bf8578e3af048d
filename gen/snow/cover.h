#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>

#include "core/ground_map.h"
#include "scene/parts.h"
#include "snow/slide.h"
#include "snow/snowpack_field.h"
#include "snow/weather.h"
#include "snow/whitening.h"

namespace wold::snow {

/// The weather at the terrain's zero, by seconds since the first frame; asked from -earlier on.
using WeatherFunction = std::function<WeatherMoment(double time_s)>;

/// The hours since the weather began at which steps of the snow on the ground begin.
struct SnowClock {
  int first_h = 0;
  int step_h = 1;
};

/// Every hour; in a season those of snowpack::snow_on_ground().
SnowClock snow_clock(bool is_season);

/// snow_cover.initial, snowpack::lain_snow().
Snowpack first_pack(const scene::SnowCoverPart& part);

/// The snow on a scene's ground over time: by degree-days, in a season by the heat that it gets, so
/// that on the level it is snowpack::snow_on_ground()'s.
class SnowGround {
 public:
  /// What lies at one moment, over the terrain's square.
  struct State {
    FactorMap depth_m;       ///< vertical
    FactorMap water_mm;      ///< of that depth, per horizontal area
    FactorMap albedo;        ///< of its surface in visible light, about 0.76 to 0.95
    double fallen_mm = 0.0;  ///< water of all snow so far, at the terrain's mean height
  };

  static constexpr int usual_max_samples = 1025;

  /// Snow is reckoned on at most that many samples along a side. Throws InputError when a height is
  /// no finite number.
  SnowGround(const scene::SnowCoverPart& part, const Heightfield& terrain, WeatherFunction weather,
             int max_samples = usual_max_samples);

  /// The state at a time since the first frame, after -earlier: from the beginning of the weather,
  /// an hour or less at a time, in a season three. Each step has its fixed place in time, so the
  /// state does not depend on which times were asked before; rising times are the cheapest. Maps
  /// have the terrain's samples, at most 1025 along a side. Where cover is not "depth", all depths
  /// are 0. May be called from several threads. Throws InputError when the weather is no number.
  State at(double time_s) const;

  /// Fraction of the ground that is white, [0, 1], on a map of `samples` >= 2 along a side over the
  /// same square: of cover "depth" where its snow lies, patch by patch; of "paper" where
  /// its noise has whitened the ground, at gamma = fallen_mm / white_after; of "none" nowhere.
  FactorMap white(const State& state, int samples) const;

 private:
  /// Whole steps of the weather so far.
  struct Progress {
    std::size_t steps = 0;
    SnowpackField packs;
    double fallen_mm = 0.0;
  };
  Progress beginning() const;
  double step_start_s(std::size_t step) const;
  void take_step(Progress& progress, double start_s, double end_s) const;
  const FactorMap& drift_of(const WeatherMoment& weather) const;

  scene::SnowCover cover_;
  std::uint64_t seed_;
  WeatherFunction weather_;
  Snowpack first_;
  Heightfield terrain_;  ///< coarsened
  double mean_height_m_;
  double earlier_s_;
  std::size_t earlier_steps_;
  double film_step_s_;
  std::optional<SnowClock> clock_;  ///< in a season
  HeightClasses classes_;
  GroundRise rise_;                 ///< in a season
  std::optional<SnowSlide> slide_;  ///< of cover "depth"

  mutable std::mutex mutex_;                     ///< of what is kept between calls
  mutable Progress progress_;                    ///< of the latest call
  mutable std::map<int, FactorMap> drifts_;      ///< by drift_heading_deg()
  mutable std::optional<WhitePatches> patches_;  ///< of the latest map's samples
};

}  // namespace wold::snow
