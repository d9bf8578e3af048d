#include "sky/blowing_snow.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "place/air.h"
#include "scene/winter.h"
#include "sky/cloud_boxes.h"
#include "sky/grain_light.h"
#include "snow/blowing_snow.h"
#include "terrain/relief.h"

namespace wold::sky {
namespace {

/// Along a side, of the square that each volume stands on.
constexpr int side_voxels = 192, side_voxels_of_sketch = 96;
constexpr double near_side_m = 48.0, far_side_m = 240.0;
/// As high as a volume should be: where the ground is steeper, voxels are twice as large, and
/// again.
constexpr int max_height_voxels = 128, coarsest = 8;
/// Thicker than that is but a skin on the ground, which hides it as far as it is seen.
constexpr double thickest_per_m = 2.0;

/// The square that a volume stands on. It lies on multiples of the coarsest voxels, so that nothing
/// swims when the camera moves.
struct Window {
  Square square;
  int voxels = side_voxels;  ///< along a side, where the ground is not steep
  bool is_whole = false;     ///< all of the terrain

  double voxel_m() const { return square.size_m / voxels; }

  /// 1 inside, 0 outside, falling smoothly along the border.
  double fraction(const glm::dvec2& at_m) const {
    return is_whole ? 1.0 : CloudWindow{square.corner_m, square.size_m}.fraction(at_m);
  }
};

Window window_before(const landscape::Camera& camera, const Heightfield& terrain, double side_m,
                     int voxels) {
  if (terrain.size_m() <= side_m) return {terrain.square(), voxels, true};
  constexpr double ahead = 0.36;  // of the side: the eye stands well inside
  const glm::dvec2 level(camera.target_m - camera.eye_m);
  const double across = glm::length(level);
  const glm::dvec2 forward = across > 0.0 ? level / across : glm::dvec2(0.0);
  const glm::dvec2 corner_m = glm::dvec2(camera.eye_m) + (ahead * forward - 0.5) * side_m;
  const double step_m = coarsest * side_m / voxels;
  return {{glm::round(corner_m / step_m) * step_m, side_m}, voxels};
}

/// The ground of a window as renderers draw it, as fine as its voxels.
Heightfield ground_of(const Heightfield& terrain, const Window& window) {
  return terrain::mesh_heights(terrain, {window.square, window.voxels + 1});
}

/// An empty volume over a window's ground, up to where snow is blown.
landscape::CloudBox box_over(const Heightfield& ground, const Window& window) {
  landscape::CloudBox box;
  const auto [lowest, highest] = std::ranges::minmax(ground.values());
  const double depth_m = double{highest} - double{lowest} + snow::blown_depth_m;
  int larger = 1;
  while (larger < coarsest && depth_m > larger * window.voxel_m() * max_height_voxels) larger *= 2;
  box.voxel_m = larger * window.voxel_m();
  const int side = window.voxels / larger;
  const double low_m = (std::floor(double{lowest} / box.voxel_m) - 1.0) * box.voxel_m;
  box.voxels = {side, side, static_cast<int>(std::ceil(depth_m / box.voxel_m)) + 3};
  box.corner_m = {window.square.corner_m, low_m};
  box.asymmetry = snow::grain_asymmetry;
  box.is_haze = true;
  const auto count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                     static_cast<std::size_t>(box.voxels.z);
  box.extinction_per_m.assign(count, 0.0F);
  box.radiance.assign(count, glm::vec3(0.0F));
  return box;
}

/// What is lifted in a window and upwind of it.
class Lifted {
 public:
  Lifted(const snow::BlowingSnow& snow, const Square& square, double step_m)
      : snow_(snow),
        gusts_(map_over<glm::vec2>(snow, square, std::max(step_m, gust_step_m))),
        streamers_(map_over<float>(snow, square, step_m)) {
    fill_in(gusts_, [&](const glm::dvec2& at_m) {
      const auto lift = snow.lift(at_m);
      return glm::vec2(lift.factor, lift.leaping_m);
    });
    if (is_anything())
      fill_in(streamers_,
              [&](const glm::dvec2& at_m) { return static_cast<float>(snow.streamer(at_m)); });
  }

  bool is_anything() const {
    return std::ranges::any_of(gusts_.values(),
                               [](const glm::vec2& lift) { return lift.x > 0.0F; });
  }

  /// Mean of a layer so thick about a height above the ground.
  double extinction_per_m(const glm::dvec2& at_m, double height_m, double layer_m) const {
    constexpr double fine_m = 0.25;
    const int samples = std::max(1, static_cast<int>(std::lround(layer_m / fine_m)));
    double sum = 0.0;
    for (int i = 0; i < samples; ++i)
      sum += extinction_per_m(at_m, height_m + layer_m * ((i + 0.5) / samples - 0.5));
    return sum / samples;
  }

 private:
  static constexpr double gust_step_m = 1.0;  // shorter gusts count as streamers

  template <class T>
  static GroundMap<T> map_over(const snow::BlowingSnow& snow, const Square& square, double step_m) {
    const glm::dvec2 way_m = snow.foot_m(square.corner_m, snow::blown_depth_m) - square.corner_m;
    const double longer_m = square.size_m + std::max(std::abs(way_m.x), std::abs(way_m.y));
    const int steps = static_cast<int>(std::ceil(longer_m / step_m));
    const glm::dvec2 corner_m = square.corner_m + glm::min(way_m, 0.0);
    return {steps + 1, Square{corner_m, steps * step_m}};
  }

  template <class T, class Value>
  static void fill_in(GroundMap<T>& map, const Value& value_at) {
    parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < map.samples(); ++i) map.at(i, j) = value_at(map.place_m(i, j));
    });
  }

  double extinction_per_m(const glm::dvec2& at_m, double height_m) const {
    const glm::dvec2 foot_m = snow_.foot_m(at_m, height_m);
    const glm::vec2 gust = gusts_.sample(foot_m.x, foot_m.y);
    return snow_.extinction_per_m({gust.x, gust.y}, streamers_.sample(foot_m.x, foot_m.y),
                                  height_m);
  }

  const snow::BlowingSnow& snow_;
  GroundMap<glm::vec2> gusts_;  ///< snow::BlowingSnow::Lift's numbers
  FactorMap streamers_;
};

/// Fills a volume in: `part` of the snow at a place belongs to it.
template <class Part>
void fill(const Lifted& lifted, const Heightfield& ground, const GrainLight& light,
          const FactorMap& sunlit, const Part& part, landscape::CloudBox& box) {
  const auto side = static_cast<std::size_t>(box.voxels.x);
  const auto fill_column = [&](std::size_t x, std::size_t y) {
    const glm::dvec2 at_m = glm::dvec2(box.corner_m) + (glm::dvec2(x, y) + 0.5) * box.voxel_m;
    const double amount = part(at_m);
    if (amount <= 0.0) return;
    const double ground_m = ground.sample(at_m.x, at_m.y);
    const double lit = sunlit.sample(at_m.x, at_m.y);
    double depth = 0.0;
    for (int z = box.voxels.z - 1; z >= 0; --z) {
      const double centre_m = box.corner_m.z + (z + 0.5) * box.voxel_m;
      if (centre_m < ground_m - 2.0 * box.voxel_m) return;
      // Below the ground as just above it: renderers read between voxels.
      const double height_m = std::max(centre_m - ground_m, 0.5 * box.voxel_m);
      const double extinction_per_m =
          std::min(amount * lifted.extinction_per_m(at_m, height_m, box.voxel_m), thickest_per_m);
      if (extinction_per_m <= 0.0) continue;
      depth += extinction_per_m * box.voxel_m;
      const std::size_t voxel = (static_cast<std::size_t>(z) * side + y) * side + x;
      box.extinction_per_m[voxel] = static_cast<float>(extinction_per_m);
      box.radiance[voxel] = light.radiance({at_m, centre_m}, depth, lit);
    }
  };
  parallel_for(side, [&](std::size_t y) {
    for (std::size_t x = 0; x < side; ++x) fill_column(x, y);
  });
}

bool is_empty(const landscape::CloudBox& box) {
  return std::ranges::all_of(box.extinction_per_m, [](float value) { return value <= 0.0F; });
}

/// By the temperature where the camera is.
snow::BlowingSnow blowing_snow(const scene::Scene& scene, const place::Site& site,
                               const landscape::Landscape& landscape, double step_m) {
  const double temperature_c = site.weather->at(landscape.time_s).temperature_c -
                               snow::lapse_k_per_m * landscape.camera.eye_m.z;
  return {*site.air_over_snow, place::mean_wind(*site.weather, landscape.time_s), temperature_c,
          scene.seed, step_m};
}

/// Whether a wind may lift snow somewhere: hills make it twice as strong at most, gusts again.
bool may_lift(const place::Site& site, double time_s) {
  return scene::strongest_over_mean * site.weather->at(time_s).wind_speed_m_s >
         scene::min_lifting_wind_m_s;
}

}  // namespace

void add_blowing_snow(const scene::Scene& scene, const place::Site& site,
                      const std::function<SnowField()>& field_of, landscape::Landscape& landscape) {
  if (!site.air_over_snow || !may_lift(site, landscape.time_s)) return;
  const landscape::Camera& camera = landscape.camera;
  const Heightfield& terrain = landscape.terrain;
  const int voxels = site.sketch ? side_voxels_of_sketch : side_voxels;
  const Window near = window_before(camera, terrain, near_side_m, voxels);
  std::optional<SnowField> field;
  const auto add = [&](const char* name, const Window& window, const auto& fraction) {
    const Heightfield ground = ground_of(terrain, window);
    landscape::CloudBox box = box_over(ground, window);
    const snow::BlowingSnow snow = blowing_snow(scene, site, landscape, box.voxel_m);
    const Lifted lifted(snow, window.square, box.voxel_m);
    if (!lifted.is_anything()) return;
    if (!field) field = field_of();
    const auto part = [&](const glm::dvec2& at_m) {
      if (!terrain.square().contains(at_m)) return 0.0;
      return scene.snow_cover.blowing * fraction(at_m) * field->loose(at_m);
    };
    const GrainLight light(landscape.daylight, landscape.sky, field->albedo, camera.eye_m);
    fill(lifted, ground, light, field->sunlit, part, box);
    box.name = name;
    if (!is_empty(box)) landscape.clouds.push_back(std::move(box));
  };
  if (!near.is_whole) {
    const Window far = window_before(camera, terrain, far_side_m, voxels);
    add("blowing_snow_far", far,
        [&](const glm::dvec2& at_m) { return far.fraction(at_m) * (1.0 - near.fraction(at_m)); });
  }
  add("blowing_snow", near, [&](const glm::dvec2& at_m) { return near.fraction(at_m); });
}

double blowing_snow_voxels(const scene::Scene& scene) {
  if (!scene::is_stormy(scene)) return 0.0;
  const double size_m = scene.terrain.size_m;
  const auto voxels = [&](double side_m) {
    // Of the rise to the hill's top, and relief as high as it is on most terrains.
    const double rise_m =
        std::min(side_m / size_m, 1.0) * scene.terrain.hill_height_m + 4.0 * scene.terrain.relief_m;
    const double layers = (snow::blown_depth_m + rise_m) * side_voxels / side_m;
    return 1.0 * side_voxels * side_voxels * std::min(layers + 3.0, 1.0 * max_height_voxels);
  };
  if (size_m <= near_side_m) return voxels(size_m);
  return voxels(near_side_m) + voxels(std::min(size_m, far_side_m));
}

}  // namespace wold::sky
