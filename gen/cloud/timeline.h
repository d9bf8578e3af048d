#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "cloud/drift.h"
#include "scene/parts.h"

namespace wold::cloud {

/// A shape that a layer's clouds take: as they were made, or drawn out by a wind.
struct Shape {
  double heading_rad = 0.0;  ///< where the wind blows to, clockwise from north
  double shear = 0.0;        ///< 0: as they were made
};

/// What a layer is doing at one moment.
struct LayerMoment {
  glm::dvec2 way_m = {};         ///< drifted, east and north, since the film's start
  glm::dvec2 velocity_m_s = {};  ///< of that drift; not of [Wang2010]'s, which is in cells a frame
  double amount = 1.0;           ///< gathered, from 0, none, to 1, the whole layer
  bool amount_is_alpha = false;  ///< it multiplies alpha, as in [Wang2010], not cover and depth
  std::size_t shape = 0;         ///< index into Timeline::shapes()
  std::size_t next_shape = 0;    ///< the one it is turning into
  double next_fraction = 0.0;    ///< of the next shape
  bool shapes_by_alpha = false;  ///< they fade by alpha, as in [Wang2010], not by optical depth
  glm::dvec3 light = glm::dvec3(1.0);  ///< colour of the light, linear; 1 on a clear day
};

/// One layer's film: every moment is a closed form of its time.
class Timeline {
 public:
  /// `layer` counts from 0; cell_m is the side of its cells.
  /// `season`: phenology::film_season() of the scene, nullptr where that is none.
  Timeline(const scene::CloudsPart& part, std::size_t layer, double cell_m,
           const phenology::FilmSeason* season = nullptr);

  /// time_s >= 0, since the first frame.
  LayerMoment at(double time_s) const;

  /// The shapes it takes, in order; the first is as the clouds were made.
  const std::vector<Shape>& shapes() const { return shapes_; }

 private:
  void set_amount(LayerMoment& moment, double time_s) const;
  void set_shape(LayerMoment& moment, double time_s) const;
  void set_light(LayerMoment& moment, double time_s) const;
  void set_way(LayerMoment& moment, double time_s) const;

  std::vector<scene::CloudEvent> winds_;    ///< that change the shape; each makes the next one
  std::vector<scene::CloudEvent> amounts_;  ///< gather, dissipate
  std::vector<scene::CloudEvent> lights_;
  std::vector<glm::dvec3> light_colours_;
  std::vector<Shape> shapes_;
  double gathered_;
  double cell_m_;
  Drift drift_;
  std::optional<PaperDrift> paper_drift_;
};

/// Colour of sunlight at that elevation over that of the zenith, its largest channel 1: what a
/// cloud's light turns to when the sun sinks.
glm::dvec3 sunlight_colour(double sun_elevation_deg, double turbidity);

}  // namespace wold::cloud
