#include "scene/keys.h"

#include "scene/binding.h"
#include "scene/key_builders.h"

/// A key's field, for reading and writing alike.
#define FIELD(path) ([](auto& scene) -> auto& { return scene.path; })

namespace wold::scene {
namespace {

constexpr ListRule pair = {.fewest = 2, .most = 2};
constexpr ListRule colour = {.fewest = 3, .most = 3};

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
      bound(word("terrain.shape", {"hillside", "mountain"},
                 "A slope with a crest, or a mountain with ridges and valleys."),
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
      bound(list(Kind::numbers, "terrain.centre", "", {-1e8, 1e8}, {.fewest = 0, .most = 2},
                 "Middle of the square in the elevation model's own coordinates, east and north or "
                 "longitude and latitude; an empty list is the model's middle."),
            FIELD(terrain.centre)),
      bound(number("terrain.size", "m", {1, 200000}, "Side of the square."), FIELD(terrain.size_m)),
      bound(integer("terrain.samples", "", {17, 4097}, "Heights along each side."),
            FIELD(terrain.samples)),
      bound(number("terrain.hill_height", "m", {0, 9000}, "Rise from the near edge to the top."),
            FIELD(terrain.hill_height_m)),
      bound(number("terrain.relief", "m", {0, 2000}, "Standard deviation of the fractal relief."),
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
  };
}

std::vector<Key> growth_keys() {
  return {
      bound(number("growth.share", "", {0, 1},
                   "Share of the ground within the limits that is grown over."),
            FIELD(growth.share)),
      bound(number("growth.feature", "m", {0.1, 10000}, "Size of the bare patches."),
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

std::vector<Key> grass_keys() {
  return {
      bound(number("grass.patch", "m", {0.05, 20}, "Side of the patch that repeats."),
            FIELD(grass.patch_m)),
      bound(integer("grass.blades", "", {1, 20000}, "Blades in a patch."), FIELD(grass.blades)),
      bound(
          rates("grass.mingle", {"steady", "early", "late", "sudden", "slow", "evergreen"}, 32,
                "Samples that are mingled, each by its ageing rate, its own weathering degree over "
                "the meadow's; the blades are shared out evenly, an empty list is one steady "
                "sample."),
          FIELD(grass.mingle)),
      bound(number("grass.height", "m", {0.01, 3}, "Mean length of a blade."),
            FIELD(grass.height_m)),
      bound(number("grass.height_spread", "", {0, 1},
                   "Standard deviation of the length over its mean."),
            FIELD(grass.height_spread)),
      bound(number("grass.width", "m", {0.00005, 0.05}, "Mean width of a blade at its foot."),
            FIELD(grass.width_m)),
      bound(number("grass.width_spread", "", {0, 1},
                   "Standard deviation of the width over its mean."),
            FIELD(grass.width_spread)),
      bound(number("grass.lean", "deg", {0, 80}, "Mean angle of a blade from the vertical."),
            FIELD(grass.lean_deg)),
      bound(number("grass.lean_spread", "deg", {0, 45}, "Standard deviation of that angle."),
            FIELD(grass.lean_spread_deg)),
      bound(number("grass.bend", "rad/sqrt(m)", {0, 20},
                   "Bending of fresh blades under their own weight, by the paper's rule."),
            FIELD(grass.bend)),
      bound(number("grass.keel_depth", "m", {0.0001, 0.05},
                   "Depth of the fold of a blade of mean length, from its edges to its keel, for "
                   "the elastica: the deeper the stiffer; flat blades have their thickness."),
            FIELD(grass.keel_depth_m)),
      bound(number("grass.specular", "", {0, 1},
                   "Strength of the blades' highlight (Kajiya and Kay's ms)."),
            FIELD(grass.specular)),
      bound(number("grass.gloss", "", {1, 1000},
                   "Sharpness of the highlight (Kajiya and Kay's exponent p)."),
            FIELD(grass.gloss)),
      bound(integer("grass.variants", "", {1, 64}, "Different patches laid side by side."),
            FIELD(grass.variants)),
      bound(only(list(Kind::integers, "grass.levels", "voxels", {30, 254},
                      {.fewest = 1, .most = 4, .order = Order::decreasing},
                      "Levels of detail: voxels along a side of the patch, finest first."),
                 {254, 126, 62, 30}),
            FIELD(grass.levels)),
      bound(
          number(
              "grass.proportion", "", {0.1, 1000},
              "Points drawn per unit of a voxel's optical depth: the paper's best is 6; here each "
              "point spreads over more voxels, and 2.5 do."),
          FIELD(grass.proportion)),
      bound(plain(Kind::file, "grass.from_texel", "", {0, 0},
                  "Volume (.vdb) that the points are sampled from instead of scattered blades: a "
                  "texel of Wold's, or any fog volume \"density\", fitted to the patch. Relative "
                  "paths start at the scene file."),
            FIELD(grass.from_texel)),
      bound(
          list(Kind::numbers, "grass.key_frames", "", {0, 1},
               {.fewest = 0, .most = 64, .order = Order::increasing, .spans_range = true},
               "Weathering degrees for which patches are made; for one in between, each cell "
               "takes one of its two neighbours by chance. An empty list is 12 equal steps, or up "
               "to 48 for a film whose frames are nearer to each other."),
          FIELD(grass.key_frames)),
      bound(number("grass.pixels_per_voxel", "", {0.1, 16},
                   "A level is fine enough when its voxel covers at most this many pixels."),
            FIELD(grass.pixels_per_voxel)),
      bound(number("grass.far_pixels", "px", {0, 100},
                   "Grass that looks lower than this is painted on the ground, in its own colour."),
            FIELD(grass.far_pixels)),
  };
}

std::vector<Key> ageing_keys() {
  return {
      bound(curve("ageing.water", {"standard", "ample", "cold"},
                  "Relative water content of the leaves over the weathering degree."),
            FIELD(ageing.water)),
      bound(curve("ageing.chlorophyll", {"standard", "drought", "cold"},
                  "Relative chlorophyll content over the weathering degree."),
            FIELD(ageing.chlorophyll)),
      bound(word("ageing.colour", {"prospect", "paper", "melanin"},
                 "How pigments become colour: the PROSPECT leaf model, the paper's functions, or "
                 "those of hair, dark when wet."),
            FIELD(ageing.colour)),
      bound(number("ageing.vein_shrinkage", "", {0, 1},
                   "Share of the veins' volume that is lost with all water; below "
                   "ageing.mesophyll_shrinkage."),
            FIELD(ageing.vein_shrinkage)),
      bound(number("ageing.mesophyll_shrinkage", "", {0, 1},
                   "Share of the soft tissue's volume that is lost with all water."),
            FIELD(ageing.mesophyll_shrinkage)),
      bound(number("ageing.stiffening", "", {0, 100},
                   "How many times stiffer a dry blade is, less one."),
            FIELD(ageing.stiffening)),
      bound(word("ageing.droop_rule", {"paper", "elastica"},
                 "How blades bow: about their roots by the paper's rule, or as elastic blades "
                 "under their own weight."),
            FIELD(ageing.droop_rule)),
      bound(word("ageing.motion", {"closed_form", "points"},
                 "How blades get there: by the rule's closed form, or point by point through the "
                 "weathering degrees (Algorithm 1 of the paper)."),
            FIELD(ageing.motion)),
      bound(number("ageing.merge_distance", "voxels", {0, 100},
                   "Points of a blade that are nearer to each other than this become one; 0 merges "
                   "none."),
            FIELD(ageing.merge_distance_voxels)),
      bound(number("ageing.droop", "rad/sqrt(m)", {0, 50},
                   "Bending towards the ground with all water lost, by the paper's rule."),
            FIELD(ageing.droop)),
      bound(number("ageing.turgor_support", "", {0, 0.99},
                   "Share of a fresh blade's stiffness that goes when it wilts, for the elastica."),
            FIELD(ageing.turgor_support)),
      bound(number("ageing.droop_spread", "", {0, 1},
                   "Standard deviation of the droop from blade to blade over its mean."),
            FIELD(ageing.droop_spread)),
      bound(number("ageing.onset_spread", "", {0, 0.5},
                   "Standard deviation of the weathering degree from blade to blade."),
            FIELD(ageing.onset_spread)),
      bound(number("ageing.fresh_spread", "", {0, 0.5},
                   "Mean weathering degree that single blades have in a fresh meadow."),
            FIELD(ageing.fresh_spread)),
      bound(number("ageing.litter", "", {0, 1},
                   "Share of dead blades of the year before in a fresh meadow."),
            FIELD(ageing.litter)),
      bound(number("ageing.chlorophyll_content", "ug/cm2", {0, 120},
                   "Chlorophyll of the fresh leaf."),
            FIELD(ageing.chlorophyll_ug_cm2)),
      bound(
          number("ageing.carotenoid_content", "ug/cm2", {0, 30}, "Carotenoids of the fresh leaf."),
          FIELD(ageing.carotenoid_ug_cm2)),
      bound(
          number(
              "ageing.brown_pigment", "", {0, 2},
              "Brown pigment of a dead leaf, PROSPECT's arbitrary unit: 0.25 pale straw, 1 brown."),
          FIELD(ageing.brown_pigment)),
      bound(number("ageing.variation", "", {0, 0.5},
                   "How far the weathering degree differs from place to place."),
            FIELD(ageing.variation)),
      bound(number("ageing.variation_feature", "m", {0.1, 1000}, "Size of such places."),
            FIELD(ageing.variation_feature_m)),
      bound(number("ageing.variety", "", {0, 0.5},
                   "How far chlorophyll and brown pigment differ from place to place, as a share, "
                   "with ageing.colour \"prospect\"."),
            FIELD(ageing.variety)),
      bound(number("ageing.variety_feature", "m", {0.1, 1000},
                   "Size of the largest such places; others are down to an eighth of it."),
            FIELD(ageing.variety_feature_m)),
      bound(list(Kind::numbers, "ageing.frames", "", {0, 1}, {.fewest = 1, .most = 10000},
                 "Weathering degree of each frame: 0 is fresh, 1 fully withered."),
            FIELD(ageing.frames)),
  };
}

std::vector<Key> fur_keys() {
  return {
      bound(integer("fur.clumps", "", {0, 10000},
                    "Clumps that the wet hairs of a patch stick together in; the hairs are "
                    "grass.blades, 0 clumps are grass."),
            FIELD(ageing.fur.clumps)),
      bound(number("fur.lying", "", {0, 0.9},
                   "How far the tips of wet clumps are combed away from their roots, in lengths of "
                   "a hair."),
            FIELD(ageing.fur.lying)),
      bound(number("fur.comb", "deg", {0, 360}, "Where to, clockwise from north."),
            FIELD(ageing.fur.comb_deg)),
      bound(number("fur.eumelanin", "um", {0, 1000},
                   "Black pigment across a hair, with ageing.colour \"melanin\": 1 pale, 10 brown, "
                   "50 black."),
            FIELD(ageing.fur.eumelanin_um)),
      bound(
          number("fur.pheomelanin", "um", {0, 1000}, "Red pigment across a hair: 3 blond, 25 fox."),
          FIELD(ageing.fur.pheomelanin_um)),
  };
}

std::vector<Key> sun_keys() {
  return {
      bound(number("sun.elevation", "deg", {1, 90}, "Height of the sun above the horizon."),
            FIELD(sun.elevation_deg)),
      bound(number("sun.azimuth", "deg", {0, 360}, "Where the sun stands, clockwise from north."),
            FIELD(sun.azimuth_deg)),
      bound(list(Kind::integers, "sun.date", "", {1, 2999}, {.fewest = 0, .most = 3},
                 "Year, month and day: the sun stands where it stood then, not at sun.elevation "
                 "and sun.azimuth; an empty list is no day."),
            FIELD(sun.date)),
      bound(number("sun.time", "h", {0, 24}, "Universal time of that day."), FIELD(sun.time_h)),
      bound(number("sun.latitude", "deg", {-90, 90}, "Where, north positive."),
            FIELD(sun.latitude_deg)),
      bound(number("sun.longitude", "deg", {-180, 180}, "Where, east positive."),
            FIELD(sun.longitude_deg)),
      bound(list(Kind::numbers, "sun.end", "deg", {0, 360}, {.fewest = 0, .most = 2},
                 "Where the sun has moved to in the last frame: height above the horizon, 1 at "
                 "least, and direction; an empty list is nowhere. Not with sun.date and not in a "
                 "season, whose sun has its own way."),
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
          word("wind.field", {"steady", "gusts", "tornado"},
               "How it carries flakes: evenly, in gusts that every flake feels in its own way, or "
               "round a tornado on the terrain's middle that drifts with the wind."),
          FIELD(wind.field)),
      bound(number("wind.speed", "m/s", {0, 60}, "How fast it carries flakes."),
            FIELD(wind.speed_m_s)),
      bound(number("wind.turbulence", "", {0, 1},
                   "Standard deviation of that speed over its mean, in gusts."),
            FIELD(wind.turbulence)),
  };
}

std::vector<Key> film_keys() {
  return {
      bound(number("film.frame_seconds", "s", {0.001, 1e6},
                   "Time that passes in the landscape from one frame to the next; how many frames "
                   "there are, ageing.frames says."),
            FIELD(film.frame_seconds)),
  };
}

std::vector<Key> camera_keys() {
  return {
      bound(list(Kind::numbers, "camera.eye", "m", {0, 200000}, pair,
                 "Where the camera stands: east and north, inside the terrain."),
            FIELD(camera.eye_m)),
      bound(number("camera.eye_height", "m", {0.01, 10000}, "Height of the eye above the ground."),
            FIELD(camera.eye_height_m)),
      bound(list(Kind::numbers, "camera.target", "m", {0, 200000}, pair,
                 "Where it looks: east and north, inside the terrain."),
            FIELD(camera.target_m)),
      bound(
          number("camera.target_height", "m", {0, 10000}, "Height of that point above the ground."),
          FIELD(camera.target_height_m)),
      bound(number("camera.field_of_view", "deg", {5, 150}, "Horizontal angle of view."),
            FIELD(camera.field_of_view_deg)),
      bound(list(Kind::numbers, "camera.eye_end", "m", {0, 200000}, {.fewest = 0, .most = 3},
                 "Where the camera has moved to in the last frame: east, north and height above "
                 "the ground; an empty list is nowhere."),
            FIELD(camera.eye_end)),
      bound(list(Kind::numbers, "camera.target_end", "m", {0, 200000}, {.fewest = 0, .most = 3},
                 "Where it looks in the last frame, likewise."),
            FIELD(camera.target_end)),
  };
}

std::vector<Key> render_keys() {
  return {
      bound(word("render.renderer", {"blender", "povray", "both", "mitsuba"},
                 "Who makes the pictures."),
            FIELD(render.renderer)),
      bound(list(Kind::integers, "render.size", "px", {16, 16384}, pair,
                 "Width and height of the picture."),
            FIELD(render.size_px)),
      bound(integer("render.samples", "", {1, 4096}, "Samples per pixel."), FIELD(render.samples)),
      bound(word("render.grass", {"texels", "blades", "auto", "points"},
                 "What grass is drawn as: volumes, true blades, blades where the finest volume is "
                 "too coarse and volumes beyond, or the points that the volumes are made of."),
            FIELD(render.grass)),
      bound(number("render.exposure", "stops", {-6, 6}, "Brightness of the picture."),
            FIELD(render.exposure)),
      bound(only(integer("render.df3_bits", "bits", {8, 16}, "Depth of POV-Ray's density files."),
                 {8, 16}),
            FIELD(render.df3_bits)),
      bound(word("render.device", {"cpu", "gpu", "auto"},
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
