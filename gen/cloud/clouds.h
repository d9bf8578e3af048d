#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "cloud/billow_box.h"
#include "cloud/detail.h"
#include "cloud/recipe.h"
#include "cloud/relief.h"
#include "cloud/scattering.h"
#include "cloud/sunlit.h"
#include "cloud/tiling.h"
#include "cloud/timeline.h"
#include "scene/parts.h"

/// The clouds of a scene: what they are at any frame. A caller makes `Clouds` once, asks it for the
/// `CloudState` of a frame, and has that composed into one picture of the sky or takes each layer's
/// picture (compose.h), the shadow on the ground (shadow.h), or a volume with its light (volume.h).
/// World space: metres, x east, y north, z up; colours are linear.
namespace wold::cloud {

/// What stays the same in a layer.
struct Layer {
  int number = 1;         ///< of the scene's layers, from 1
  std::uint64_t key = 0;  ///< of its randomness
  Droplets droplets;
  double base_m = 0.0;       ///< above the terrain's zero
  double thickness_m = 0.0;  ///< of the thickest clouds
  glm::dvec2 period_m = {};  ///< after which it repeats: a whole number of pixels
  glm::ivec2 period_px = {};
  bool is_volume = false;      ///< body = "volume"
  bool lit_as_paper = false;   ///< light = "paper": as bright however thick
  bool has_relief = false;     ///< so dense that what is seen of it has a shape
  double seen_depth = 0.0;     ///< vertical optical depth of the densest place, as it is seen
  double cover = 0.0;          ///< fraction of the sky, when the whole layer is there; above 1 it
                               ///< has no thin places
  std::vector<float> profile;  ///< TextureSet's
  Detail detail;               ///< what the maps are too coarse for
  std::vector<float> rank_per_field;      ///< TextureSet's
  std::optional<BillowBox> billow_cells;  ///< of one with relief or that is a volume
  std::optional<ForwardTable> forward;    ///< forward_through() of its droplets
};

/// Height of a layer's middle above the terrain's zero, metres.
inline double middle_m(const Layer& layer) { return layer.base_m + 0.5 * layer.thickness_m; }

/// Whether what is seen of a layer are heaps, whose sides show.
inline bool stands_in_heaps(const Layer& layer) { return layer.has_relief && layer.cover < 1.0; }

/// A shape of a layer over its whole period.
struct ShapeMaps {
  LayerMap ranks;
  LayerMap sunlit;                ///< base_brightness in steps of 1/65535, of the whole layer
  std::optional<Relief> relief;   ///< where the layer has one
  glm::dvec3 sun_direction = {};  ///< of the sun that shines there
  double detail = 1.0;            ///< fraction of Layer::detail that wind has not smoothed away
};

/// A layer at one moment: its shapes' maps and what is made of them.
struct LayerState {
  std::shared_ptr<const Layer> layer;
  LayerMoment moment;
  std::shared_ptr<const ShapeMaps> map;       ///< of the shape, where it would be without drift
  std::shared_ptr<const ShapeMaps> next_map;  ///< of the next shape; null while there is none
};

struct CloudState {
  double time_s = 0.0;             ///< since the first frame
  double pixel_m = 0.0;            ///< of the maps
  std::vector<LayerState> layers;  ///< from the highest base to the lowest
};

class Clouds {
 public:
  /// Makes or reads all textures. pixel_m: side of the maps' pixels, > 0; layers' cells are
  /// stretched, by less than a pixel per period, so that a period is a whole number of them. Throws
  /// FileError for bad pictures, InputError when a layer's period would have more than 16384 pixels
  /// along a side. `season`: phenology::film_season() of the scene, nullptr where that is none.
  Clouds(const scene::CloudsPart& part, double pixel_m,
         const phenology::FilmSeason* season = nullptr);

  /// A pixel's side with which the longest period has 2048 pixels, but no finer than a 256th of
  /// the smallest cell: what is smaller, Layer::detail and heads have. It has half that side where
  /// a layer has pictures or is a volume without heaps, which are without detail; 0 without clouds.
  static double usual_pixel_m(const std::vector<scene::CloudLayer>& layers);

  /// time_s >= 0, on the clouds' clock (scene/calendar.h), alone: no other moment is needed. Maps
  /// are made when they are first used. sun_direction, of unit length: the scene's or that of the
  /// frame.
  CloudState at(double time_s, const glm::dvec3& sun_direction) const;
  /// In the scene's sun.
  CloudState at(double time_s) const;

 private:
  struct LayerHistory;
  std::vector<std::shared_ptr<LayerHistory>> films_;  ///< one for each layer, highest first
  double pixel_m_;
  glm::dvec3 sun_direction_;
};

/// Side of the square that a texture of the layer covers, in metres: the layer's own, or else its
/// kind's. Heaps that are thicker than their kind's are as much wider, up to ten times, so that
/// they keep their proportions: a wide range of cumulus is about as deep as wide (Benner and Curry
/// 1998, Characteristics of small tropical cumulus clouds and their impact on the environment).
/// Throws FileError when the kind's file is missing or damaged.
double cell_m_of(const scene::CloudLayer& layer);

/// How much `field` more of the textures' field raises a rank in [0, 1] near which it is added.
double rank_rise(const Layer& layer, double rank, double field);

/// Depth over that of the densest place of the whole layer, for a rank in [0, 1] when `amount` in
/// [0, 1] of the layer has gathered. Rises with both; 0 outside the clouds.
double relative_depth(const Layer& layer, double rank, double amount);

/// Vertical optical depth likewise, as the eye sees it from below.
double optical_depth_of_rank(const Layer& layer, double rank, double amount);

/// Optical depth of the droplets over that which is seen, at least 1: thick clouds scatter more
/// than opacities below 1 tell.
double droplets_per_seen(const Layer& layer);

/// The top above the base of a place with that relative depth in [0, 1]: thickness_m times its
/// power 0.7, between a slab's, which has steep edges, and a lens's.
double top_m(const Layer& layer, double relative_depth);

/// How much less deep clouds are when `amount` in [0, 1] of a layer has gathered.
double depth_factor(double amount);

/// Vertical optical depth of the layer at a place of the world, all shapes and fades counted.
double optical_depth_at(const LayerState& state, double pixel_m, const glm::dvec2& place_m);

/// Fraction of the light that comes straight through all layers along lines of sight with that sine
/// of elevation, > 0: the mean over the whole of each layer, which does not change as it drifts.
double mean_transmittance(const CloudState& state, double sine);

}  // namespace wold::cloud
