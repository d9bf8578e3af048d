#include "place/starter_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/error.h"
#include "light/daylight.h"
#include "place/viewpoint.h"
#include "scene/shots.h"
#include "scene/sun_path.h"
#include "terrain/elevation_model.h"
#include "terrain/ground.h"

namespace wold::place {
namespace {

constexpr double smallest_m = 10.0, largest_m = 25e3, eye_height_m = 1.7;

scene::Terrain terrain_of(const std::string& elevation, const terrain::ElevationModel& model) {
  constexpr double most_samples = 4097.0;
  scene::Terrain terrain;
  terrain.elevation = elevation;
  terrain.system = model.system;
  terrain.size_m = std::min(model.square_m, largest_m);
  const double samples = std::ceil(terrain.size_m / model.cell_m) + 1.0;
  terrain.samples =
      static_cast<int>(std::clamp(samples, static_cast<double>(terrain.samples), most_samples));
  return terrain;
}

/// To steps that are short for a terrain.
double rounded_m(double length_m, double size_m) {
  const double per_m = size_m > 1000.0 ? 1.0 : 10.0;
  return std::round(per_m * length_m) / per_m;
}

std::array<double, 2> rounded_m(const glm::dvec2& place_m, double size_m) {
  return {rounded_m(place_m.x, size_m), rounded_m(place_m.y, size_m)};
}

std::array<double, 2> rounded_deg(const glm::dvec2& place_deg) {
  constexpr double per_deg = 1000.0;
  return {std::round(per_deg * place_deg.x) / per_deg, std::round(per_deg * place_deg.y) / per_deg};
}

/// Three squares wide at least, so that mountains at its end are seen.
double visual_range_m(const scene::Scene& kind, double size_m) {
  return std::max(kind.sky.visual_range_m, 3.0 * size_m);
}

/// Where the sun stands in the middle of its film.
glm::dvec3 to_sun(const scene::Scene& scene) {
  const scene::Sun sun = scene::sun_of_frame(scene, (scene::frame_count(scene) + 1) / 2);
  return light::direction_of(radians(sun.azimuth_deg), radians(sun.elevation_deg));
}

}  // namespace

scene::StarterPlace starter_place(const std::string& elevation, const std::string& kind) {
  const terrain::ElevationModel model = terrain::describe_elevation(elevation);
  if (model.square_m < smallest_m)
    throw InputError(fmt::format(
        "{}: found {:.3g} m of ground about the model's middle, expected {} m or more; a model in "
        "degrees has to say so itself, or by terrain.system in a scene",
        elevation, model.square_m, smallest_m));
  scene::StarterPlace place;
  if (model.longitude_latitude_deg)
    place.longitude_latitude_deg = rounded_deg(*model.longitude_latitude_deg);
  const scene::Scene scene = scene::scene_of_kind(kind, place.longitude_latitude_deg);
  const scene::Terrain terrain = terrain_of(elevation, model);
  const auto [width_px, height_px] = scene.render.size_px;
  const Viewpoint view = find_viewpoint(terrain::make_ground(terrain, scene.seed).heights_m,
                                        {eye_height_m, scene.camera.field_of_view_deg,
                                         static_cast<double>(height_px) / width_px, to_sun(scene)});
  place.elevation = elevation;
  place.system = terrain.system;
  place.size_m = terrain.size_m;
  place.samples = terrain.samples;
  place.visual_range_m = visual_range_m(scene, terrain.size_m);
  place.eye_m = rounded_m(view.eye_m, terrain.size_m);
  place.target_m = rounded_m(view.target_m, terrain.size_m);
  place.eye_height_m = eye_height_m;
  place.target_height_m = rounded_m(view.target_height_m, terrain.size_m);
  return place;
}

}  // namespace wold::place
