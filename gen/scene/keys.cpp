#include "scene/keys.h"

#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/renderers.h"
#include "scene/sun_position.h"

/// A key's field, for reading and writing alike.
#define FIELD(path) ([](auto& scene) -> auto& { return scene.path; })

namespace wold::scene {
namespace {

constexpr ListRule pair = {.min_items = 2, .max_items = 2};
constexpr ListRule colour = {.min_items = 3, .max_items = 3};

Key renderer_key() {
  Key key = words("render.renderer", renderer_words(), "Who makes the pictures.");
  key.get = [](const Scene& scene) { return renderers_value(scene.render.renderers); };
  key.set = [](Scene& scene, const Value& value) { scene.render.renderers = renderers_of(value); };
  return key;
}

}  // namespace

std::vector<Key> top_level_keys() {
  return {
      bound(plain(Kind::name, "name", "", {1, 64}, "Names the output folder."), FIELD(name)),
      // The largest seed is the largest whole number that every JSON reader keeps exactly.
      bound(integer("seed", "", {0, 9007199254740991.0},
                    "Another seed gives another meadow of the same kind."),
            FIELD(seed)),
  };
}

std::vector<Key> terrain_keys() {
  return {
      bound(word("terrain.shape", "A slope with a crest, or a mountain with ridges and valleys."),
            FIELD(terrain.shape)),
      bound(
          plain(Kind::file, "terrain.elevation", "", {0, 0},
                "Elevation model of a real place: GeoTIFF, .asc, .hgt or another raster that is a "
                "plain file; without it, the ground is terrain.shape. Relative paths start at the "
                "scene file."),
          FIELD(terrain.elevation)),
      bound(plain(Kind::system, "terrain.system", "", {0, 0},
                  "Coordinate system of the elevation model, by its EPSG number, where the file "
                  "does not say it or says another: 4326 is longitude and latitude; without "
                  "either, its coordinates are metres."),
            FIELD(terrain.system)),
      bound(list(Kind::numbers, "terrain.centre", "", {-1e8, 1e8}, {.min_items = 0, .max_items = 2},
                 "Middle of the square in the elevation model's own coordinates, east and north or "
                 "longitude and latitude; an empty list is the model's middle."),
            FIELD(terrain.centre)),
      bound(plain(Kind::file, "terrain.surroundings", "", {0, 0},
                  "Coarser elevation model of the land around, in any coordinate system, for what "
                  "lies farther out than terrain.elevation reaches; where no model reaches, the "
                  "land goes on as it may. Relative paths start at the scene file."),
            FIELD(terrain.surroundings)),
      bound(
          plain(Kind::file, "terrain.cover", "", {0, 0},
                "Raster of land cover, in any coordinate system, whose numbers are classes: ESA "
                "WorldCover's, or those of [[cover_classes]]. They say where grass may grow, what "
                "colour other ground has, and where lakes and rivers are. Relative paths start at "
                "the scene file."),
          FIELD(terrain.cover)),
      bound(
          plain(Kind::file, "terrain.photo", "", {0, 0},
                "Orthophoto, in any coordinate system: a raster of red, green and blue bytes. Its "
                "shading is taken out; grass grows where it is green, other ground has its "
                "colour. What terrain.cover says of grass holds, too. Relative paths start at the "
                "scene file."),
          FIELD(terrain.photo)),
      bound(word("terrain.water",
                 "Lakes where the elevation model is level as only water is, and lakes and rivers "
                 "where terrain.cover has them (\"auto\"), or none."),
            FIELD(terrain.water)),
      bound(number("terrain.size", "m", {1, 200000}, "Side of the square."), FIELD(terrain.size_m)),
      bound(integer("terrain.samples", "", {17, 4097}, "Heights along each side."),
            FIELD(terrain.samples)),
      bound(number("terrain.hill_height", "m", {0, 9000}, "Rise from the near edge to the top."),
            FIELD(terrain.hill_height_m)),
      bound(number("terrain.relief", "m", {0, 2000},
                   "Standard deviation of the fractal relief; below an elevation model's cells, 0 "
                   "is none and any other the model's own."),
            FIELD(terrain.relief_m)),
      bound(number("terrain.relief_feature", "m", {0.1, 200000},
                   "Size of the relief's largest features."),
            FIELD(terrain.relief_feature_m)),
      bound(number("terrain.roughness", "", {0.1, 1},
                   "Hurst exponent of the relief: 1 is smooth, 0.5 rugged."),
            FIELD(terrain.roughness)),
      bound(integer("terrain.octaves", "", {1, 16}, "Octaves of noise in the relief."),
            FIELD(terrain.octaves)),
      bound(number("terrain.streams", "", {0, 10},
                   "How far streams have cut into the ground: 0 not at all, 1 gorges on the lower "
                   "slopes, 10 up to the crests."),
            FIELD(terrain.streams)),
      bound(number("terrain.talus", "deg", {5, 80}, "Steepest slope that erosion leaves."),
            FIELD(terrain.talus_deg)),
      bound(integer("terrain.erosion_steps", "", {0, 10000}, "Passes of erosion; 0 is none."),
            FIELD(terrain.erosion_steps)),
      bound(list(Kind::numbers, "terrain.ground_albedo", "", {0, 1}, colour,
                 "Colour of the bare ground, linear red, green and blue."),
            FIELD(terrain.ground_albedo)),
      bound(list(Kind::numbers, "terrain.rock_albedo", "", {0, 1}, colour,
                 "Colour of rock, linear red, green and blue."),
            FIELD(terrain.rock_albedo)),
      bound(number("terrain.rock_slope", "deg", {0, 90}, "Rock shows where the ground is steeper."),
            FIELD(terrain.rock_slope_deg)),
      bound(number("terrain.boulders", "per hectare", {0, 200},
                   "Boulders at least a metre wide on open ground. Smaller ones, down to half a "
                   "metre, are more, as in nature; below rock of large terrains there are up to "
                   "twenty times as many."),
            FIELD(terrain.boulders_per_hectare)),
      bound(number("terrain.grazing_steps", "", {0, 1},
                   "Share of slopes of 23 to 33 degrees on which grazing animals have trodden "
                   "steps along the contour; it is less down to 15 and up to 42 degrees."),
            FIELD(terrain.grazing_steps)),
  };
}

std::vector<Key> growth_keys() {
  return {
      bound(number("growth.cover", "", {0, 1},
                   "Share of the ground within the limits that is grown over."),
            FIELD(growth.cover)),
      bound(number("growth.feature", "m", {0.1, 10000},
                   "Size of the bare patches; on large terrains "
                   "they have all sizes."),
            FIELD(growth.feature_m)),
      bound(number("growth.steepest", "deg", {0, 90}, "Steepest slope on which grass grows."),
            FIELD(growth.steepest_deg)),
      bound(number("growth.lowest", "m", {-10000, 10000},
                   "Lowest ground on which grass grows, over the terrain's zero."),
            FIELD(growth.lowest_m)),
      bound(number("growth.highest", "m", {-10000, 10000},
                   "Highest ground on which grass grows, likewise."),
            FIELD(growth.highest_m)),
      bound(plain(Kind::file, "growth.mask", "", {0, 0},
                  "Picture over the terrain's square, north at the top: no grass where it is "
                  "black. Relative paths start at the scene file."),
            FIELD(growth.mask)),
  };
}

std::vector<Key> sun_keys() {
  return {
      bound(number("sun.elevation", "deg", {min_sun_elevation_deg, 90},
                   "Height of the sun above the horizon; below 0 it has set, and it is dusk."),
            FIELD(sun.elevation_deg)),
      bound(number("sun.azimuth", "deg", {0, 360}, "Where the sun stands, clockwise from north."),
            FIELD(sun.azimuth_deg)),
      bound(list(Kind::integers, "sun.date", "", {1, 2999}, {.min_items = 0, .max_items = 3},
                 "Year, month and day: the sun stands where it stood then, not at sun.elevation "
                 "and sun.azimuth; an empty list is no day."),
            FIELD(sun.date)),
      bound(number("sun.time", "h", {0, 24}, "Universal time of that day."), FIELD(sun.time_h)),
      bound(number("sun.latitude", "deg", {-90, 90}, "Where, north positive."),
            FIELD(sun.latitude_deg)),
      bound(number("sun.longitude", "deg", {-180, 180}, "Where, east positive."),
            FIELD(sun.longitude_deg)),
      bound(list(Kind::numbers, "sun.end", "deg", {min_sun_elevation_deg, 360},
                 {.min_items = 0, .max_items = 2},
                 "Where the sun has moved to in the last frame: height above the horizon, as "
                 "sun.elevation, and direction, as sun.azimuth; an empty list is nowhere. Not with "
                 "sun.date and not in a season, whose sun has its own way."),
            FIELD(sun.end)),
  };
}

std::vector<Key> sky_keys() {
  return {
      bound(number("sky.turbidity", "", {2, 10},
                   "Haze of the air (Preetham's T): 2 is very clear, 10 hazy."),
            FIELD(sky.turbidity)),
      bound(number("sky.visual_range", "m", {100, 1e6},
                   "Distance at which dark things vanish in the haze."),
            FIELD(sky.visual_range_m)),
  };
}

std::vector<Key> wind_keys() {
  return {
      bound(number("wind.heading", "deg", {0, 360}, "Where it blows to, clockwise from north."),
            FIELD(wind.heading_deg)),
      bound(number("wind.lean", "deg", {0, 40}, "How far it has combed the grass over."),
            FIELD(wind.lean_deg)),
      bound(number("wind.waves", "deg", {0, 15},
                   "How much that differs from place to place (standard deviation): a meadow shows "
                   "waves."),
            FIELD(wind.waves_deg)),
      bound(number("wind.wave_length", "m", {0.5, 1000}, "Size of such places along the wind."),
            FIELD(wind.wave_length_m)),
      bound(
          word("wind.field",
               "How it carries flakes: evenly, in gusts that every flake feels in its own way, or "
               "round a tornado on the terrain's middle that drifts with the wind."),
          FIELD(wind.field)),
      bound(number("wind.speed", "m/s", {0, 60},
                   "How fast it carries flakes, and blows 10 m above the grass that it moves."),
            FIELD(wind.speed_m_s)),
      bound(number("wind.turbulence", "", {0, 1},
                   "Standard deviation of that speed over its mean, in gusts."),
            FIELD(wind.turbulence)),
      bound(
          word("wind.grass",
               "Whether grass stands still as it has been combed, or waves from frame to frame in "
               "the wind of the moment: in gusts, over hills and in waves of its own. "
               "film.frame_seconds of 0.0417 shows it as one sees it."),
          FIELD(wind.grass)),
  };
}

std::vector<Key> film_keys() {
  return {
      bound(number("film.frame_seconds", "s", {0.001, 1e6},
                   "Time that passes in the landscape from one frame to the next; how many frames "
                   "there are, ageing.frames, the season or [[shots]] say."),
            FIELD(film.frame_seconds)),
      bound(number("film.frames_per_second", "1/s", {0.1, 240},
                   "How fast the film is played: by it [[shots]] have frames, and `wold film` has "
                   "it without --fps."),
            FIELD(film.frames_per_second)),
      bound(
          number("film.shutter", "", {0, 1},
                 "Share of the time between two frames in which the film's shutter is open: `wold "
                 "film` blurs by it what moves before the camera, 0.5 as film cameras do; frames "
                 "have the passes depth and motion for it. Pictures stay sharp."),
          FIELD(film.shutter)),
  };
}

std::vector<Key> camera_keys() {
  return {
      bound(list(Kind::numbers, "camera.eye", "m", {0, 200000}, pair,
                 "Where the camera stands: east and north, inside the terrain."),
            FIELD(camera.eye_m)),
      bound(number("camera.eye_height", "m", {0.01, 10000},
                   "Height of the eye above the ground; at least half of it over the snow that "
                   "lies at first."),
            FIELD(camera.eye_height_m)),
      bound(list(Kind::numbers, "camera.target", "m", {0, 200000}, pair,
                 "Where it looks: east and north, inside the terrain."),
            FIELD(camera.target_m)),
      bound(
          number("camera.target_height", "m", {0, 10000}, "Height of that point above the ground."),
          FIELD(camera.target_height_m)),
      bound(number("camera.field_of_view", "deg", {5, 150}, "Horizontal angle of view."),
            FIELD(camera.field_of_view_deg)),
      bound(
          list(Kind::numbers, "camera.eye_end", "m", {0, 200000}, {.min_items = 0, .max_items = 3},
               "Where the camera has moved to in the last frame: east, north and height above "
               "the ground; an empty list is nowhere."),
          FIELD(camera.eye_end)),
      bound(list(Kind::numbers, "camera.target_end", "m", {0, 200000},
                 {.min_items = 0, .max_items = 3}, "Where it looks in the last frame, likewise."),
            FIELD(camera.target_end)),
  };
}

std::vector<Key> render_keys() {
  return {
      renderer_key(),
      bound(list(Kind::integers, "render.size", "px", {16, 16384}, pair,
                 "Width and height of the picture."),
            FIELD(render.size_px)),
      bound(integer("render.samples", "", {1, 4096}, "Samples per pixel."), FIELD(render.samples)),
      bound(word("render.grass",
                 "What grass is drawn as: volumes, true blades, blades where the finest volume is "
                 "too coarse and volumes beyond, or the points that the volumes are made of."),
            FIELD(render.grass)),
      bound(number("render.exposure", "stops", {-6, 6}, "Brightness of the picture."),
            FIELD(render.exposure)),
      bound(only(integer("render.df3_bits", "bits", {8, 16}, "Depth of POV-Ray's density files."),
                 {8, 16}),
            FIELD(render.df3_bits)),
      bound(word("render.device",
                 "What Blender computes on: the processor, a graphics card (OptiX, CUDA, HIP, "
                 "oneAPI or Metal, as Blender finds it), or a graphics card if there is one. "
                 "POV-Ray has only the processor."),
            FIELD(render.device)),
      bound(integer("render.threads", "", {0, 1024}, "Threads to use; 0 is all processors."),
            FIELD(render.threads)),
      bound(number("render.timeout", "min", {0.01, 10080},
                   "Longest time for one frame of one renderer."),
            FIELD(render.timeout_minutes)),
  };
}

}  // namespace wold::scene
