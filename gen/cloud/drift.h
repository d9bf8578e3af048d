#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/parts.h"

/// Where a layer has drifted to. Every motion is a closed form of time: no frame needs another.
namespace wold::phenology {
class FilmSeason;
}

namespace wold::cloud {

/// Drift by speed and heading that change evenly over an interval, then stay.
struct DriftSegment {
  double start_s = 0.0;
  double duration_s = 0.0;  ///< > 0
  double speed_m_s = 0.0, speed_end_m_s = 0.0;
  double heading_rad = 0.0,
         heading_end_rad = 0.0;  ///< clockwise from north, any multiple of a turn
};

/// The way, east and north, that a segment has drifted at `seconds` in [0, duration_s] after its
/// start: the integral of (v + a t) (sin, cos)(h + w t), by parts.
glm::dvec2 way_m(const DriftSegment& segment, double seconds);

/// Gusts along each axis: eight sines of periods from 20 s to 15 min, on a logarithmic scale, with
/// keyed phases and equal fractions of the variance: weather's energy per octave is about even
/// there (Van der Hoven 1957, Power spectrum of horizontal wind speed, sees more only at a minute).
glm::dvec2 gust_way_m(double deviation_m_s, double time_s, std::uint64_t key);
glm::dvec2 gust_velocity_m_s(double deviation_m_s, double time_s, std::uint64_t key);

/// What a season's wind does to every drift from a moment on, evenly until the next one.
struct WindNow {
  double time_s = 0.0;
  double speed_factor = 1.0;
  double turned_rad = 0.0;  ///< clockwise
};

/// The season's wind on the clouds' clock, day by day from 0; none of a scene that is no season.
/// `season`: phenology::film_season() of the scene, nullptr where that is none.
std::vector<WindNow> season_winds(const scene::CloudsPart& part,
                                  const phenology::FilmSeason* season);

/// How one layer drifts through its wind, faster and slower events, in a season with its wind.
class Drift {
 public:
  Drift(const scene::CloudLayer& layer, const std::vector<scene::CloudEvent>& in_order,
        std::uint64_t key, const std::vector<WindNow>& winds = {});
  /// East and north since time 0; time_s >= 0.
  glm::dvec2 way_m(double time_s) const;
  glm::dvec2 velocity_m_s(double time_s) const;

 private:
  std::vector<DriftSegment> segments_;  ///< in order, without gaps; the last one has no change
  double gusts_m_s_;
  std::uint64_t key_;
};

/// [Wang2010]'s motion (2.3, 2.5, 3), in cells: x_t from a keyed start in [0, 1) grows by 0.0001 a
/// frame, which an opposing wind turns into a fall; while faster or slower lasts, 0.01 is added or
/// taken away as well; y_t = sin x_t. East is x, north y.
class PaperDrift {
 public:
  PaperDrift(const std::vector<scene::CloudEvent>& in_order, double frame_seconds,
             std::uint64_t key);
  glm::dvec2 way_cells(double time_s) const;

 private:
  struct Rate {
    double start_s;
    double per_frame;
  };
  std::vector<Rate> rates_;  ///< each until the next starts
  double frame_seconds_;
  double start_;
};

}  // namespace wold::cloud
