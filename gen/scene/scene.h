#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/modes.h"

/// The scene file as plain, checked data. Lengths are metres, angles degrees, z is up, x east,
/// y north; colours are linear sRGB. Meaning, unit, default and range of every key stand once, in
/// the registry (registry.h).
namespace wold::scene {

/// A curve over the weathering degree: the name of one of models/ageing/*.toml, or the user's own
/// control points (weathering degree, value), joined by monotone cubics. Points win over the name.
/// Values are contents relative to the fresh leaf or, of an ageing rate, weathering degrees.
struct CurveChoice {
  std::string name;
  std::vector<glm::dvec2> points;

  bool operator==(const CurveChoice&) const = default;
};

/// A procedural hillside, a slope with a crest, or a mountain with ridges and valleys; both with
/// fractal relief, hydraulic and thermal erosion. Or a real place of an elevation model.
struct Terrain {
  TerrainShape shape = TerrainShape::hillside;
  std::string elevation;  ///< path of a raster that GDAL reads; empty: procedural
  std::string system;     ///< the raster's, "EPSG:4326"; empty: as the raster says, else metres
  std::vector<double> centre;     ///< of the square, in the raster's coordinates; empty: its middle
  std::string surroundings = {};  ///< path of another raster of the land around; empty: none
  std::string cover = {};         ///< path of a raster of land cover; empty: none
  std::string photo = {};         ///< path of an orthophoto; empty: none
  WaterSource water = WaterSource::automatic;
  double size_m = 42.0;            ///< side of the square
  int samples = 337;               ///< heights per side
  double hill_height_m = 6.0;      ///< from the near edge to the crest
  double relief_m = 0.45;          ///< standard deviation of the fractal relief
  double relief_feature_m = 14.0;  ///< largest feature of the relief
  double roughness = 0.9;          ///< Hurst exponent H: 1 smooth, 0.5 rugged
  int octaves = 6;
  double streams = 0.6;     ///< how far streams have cut, Incision::reach
  double talus_deg = 33.0;  ///< steepest slope that erosion leaves
  int erosion_steps = 60;
  std::array<double, 3> ground_albedo = {0.13, 0.095, 0.06};
  std::array<double, 3> rock_albedo = {0.19, 0.162, 0.128};
  double rock_slope_deg = 40.0;       ///< rock shows where the ground is steeper
  double boulders_per_hectare = 0.0;  ///< wider than 1 m, on open ground
  double grazing_steps = 0.0;         ///< share of slopes that hold them, in [0, 1]

  bool operator==(const Terrain&) const = default;
};

/// What a number of terrain.cover stands for.
struct CoverClass {
  std::int64_t number = 0;
  double grass = 1.0;               ///< share on which grass grows as far as [growth] lets it
  double water = 0.0;               ///< from a half on it is water
  std::vector<double> albedo = {};  ///< where no grass grows, linear RGB; empty: soil and rock

  bool operator==(const CoverClass&) const = default;
};

/// A path that feet have worn into the meadow; see terrain/paths.h.
struct Path {
  /// East and north of places on the terrain that it leads to, one after the other, metres.
  std::vector<double> way_m = {};
  double width_m = 0.6;  ///< of what is bare

  bool operator==(const Path&) const = default;
};

/// Where grass grows: each limit is a ragged border, a strip where it grows in patches.
struct Growth {
  double cover = 1.0;          ///< of the ground within the limits that is grown over
  double feature_m = 3.0;      ///< size of the bare patches
  double steepest_deg = 45.0;  ///< slope
  double lowest_m = -10000.0;
  double highest_m = 10000.0;
  std::string mask;  ///< path of a picture over the terrain's square, white where grass may grow

  bool operator==(const Growth&) const = default;
};

/// Where a species grows: within limits like those of [growth], and others. How wet a place is,
/// and how sunny, place::Topography says.
struct Habitat : Growth {
  double gentlest_deg = 0.0;  ///< slope
  double driest = 0.0;        ///< fraction of the terrain that is drier
  double wettest = 1.0;
  double shadiest = 0.0;  ///< noon's sun at the equinox, over that on level ground
  double sunniest = 2.0;

  Habitat() { steepest_deg = 90.0; }

  bool operator==(const Habitat&) const = default;
};

/// The blades of a species while they are fresh, and in which order they age.
struct Plant {
  /// Ageing rates wd_i = Mg_i(wd) of the samples that are mingled; none: one sample that ages as
  /// the meadow does.
  std::vector<CurveChoice> mingle;
  double crown_m = 0.0;         ///< up to here blades stand on twigs; 0: in the ground
  double height_m = 0.32;       ///< mean blade length
  double height_spread = 0.22;  ///< standard deviation / mean
  double width_m = 0.0056;      ///< mean diameter of the cone at its foot
  double width_spread = 0.25;
  double lean_deg = 14.0;  ///< mean angle from the vertical
  double lean_spread_deg = 8.0;
  double bend = 1.0;             ///< droop of fresh blades, rad per sqrt(m); [TVT]'s rule
  double keel_depth_m = 0.0011;  ///< of a mean blade's fold, edges to keel; the elastica's
  double specular = 0.12;        ///< Kajiya-Kay specular coefficient ms

  bool operator==(const Plant&) const = default;
};

/// The meadow's patch and what it is drawn with. Its plant is that of the only species, or what
/// [[species]] have in common.
struct Grass : Plant {
  double patch_m = 0.6;             ///< side of the tile
  int blades = 400;                 ///< per patch, in the ground, of all species and samples
  double specular_exponent = 24.0;  ///< Kajiya-Kay exponent p
  int variants = 4;
  std::vector<int> lods = {254, 126, 62, 30};  ///< voxels per side, finest first
  double points_per_voxel_face = 2.5;          ///< points per unit optical depth of a voxel
  std::vector<double> key_frames = {};         ///< weathering degrees; empty: see key_frames.h
  std::string from_texel = "";    ///< .vdb that points are sampled from; "": blades are scattered
  double pixels_per_voxel = 1.3;  ///< a level is fine enough when its voxel covers at most this
  double far_field_below_pixels =
      1.2;                   ///< grass that looks lower than this is painted on the ground
  double unevenness = 0.35;  ///< of its top on a wide terrain: standard deviation over its mean

  bool operator==(const Grass&) const = default;
};

/// A patch of hair instead of grass: blades are hairs, weathering degrees go from wet to dry.
struct Fur {
  int clumps = 0;                ///< in a patch; 0: it is grass
  double lying = 0.55;           ///< how far wet tips are combed down, in hair lengths
  double comb_deg = 90.0;        ///< where to, clockwise from north
  double eumelanin_um = 3.0;     ///< black pigment: its thickness across a hair, alone
  double pheomelanin_um = 25.0;  ///< red pigment

  bool operator==(const Fur&) const = default;
};

/// The physical-biological model of withering: what becomes of the blades of a species.
struct Physiology {
  CurveChoice water = {"standard", {}};        ///< relative water content over weathering degree
  CurveChoice chlorophyll = {"standard", {}};  ///< relative chlorophyll content
  ColourModel colour = ColourModel::prospect;
  double vein_shrinkage = 0.15;      ///< kv: volume lost per unit of water lost
  double mesophyll_shrinkage = 0.6;  ///< km > kv
  double stiffening = 2.0;           ///< b: E(w) = E0 (1 + b (1 - w))
  DroopRule droop_rule = DroopRule::paper;
  AgeingMotion motion = AgeingMotion::closed_form;
  double merge_distance_voxels = 0.1;  ///< points nearer than this become one
  double droop = 2.6;                  ///< omega: rad per sqrt(m) and unit of water lost
  double turgor_support = 0.7;         ///< fraction of a fresh blade's stiffness, elastica
  double droop_spread = 0.3;           ///< of omega from blade to blade
  double onset_spread = 0.12;          ///< of a blade's own weathering degree
  double fresh_spread = 0.24;  ///< mean of the ages that single blades have in a fresh meadow
  double litter = 0.55;        ///< fraction of dead blades of the year before in a fresh meadow
  double chlorophyll_ug_cm2 = 22.0;
  double carotenoid_ug_cm2 = 5.0;
  double brown_pigment = 1.3;  ///< of a dead leaf, PROSPECT's arbitrary unit
  Fur fur;                     ///< how it is combed and coloured when it is hair

  bool operator==(const Physiology&) const = default;
};

/// How the meadow withers, place by place and frame by frame. Its physiology is that of the only
/// species, or what [[species]] have in common.
struct Ageing : Physiology {
  double age_spread = 0.10;           ///< amplitude of the weathering field on the ground
  double age_spread_feature_m = 7.0;  ///< its feature size
  double pigment_spread = 0.3;  ///< of pigments on the ground, standard deviation of their log
  double pigment_spread_feature_m = 4.0;            ///< its largest feature size
  std::vector<double> frames = {0.0, 0.30, 0.917};  ///< weathering degree of each frame

  bool operator==(const Ageing&) const = default;
};

/// The flower on the tip of each blade of a species, which is its stalk.
struct Flower {
  int petals = 0;             ///< 0: it does not flower
  double length_m = 0.012;    ///< of a petal
  double width_m = 0.005;     ///< of a petal at its outer end
  double opening_deg = 80.0;  ///< of petals from the stalk: 0 closed, 90 flat
  PetalColour colour = PetalColour::white;
  double disc_m = 0.006;  ///< across the yellow middle; 0: none
  double fades = 0.3;     ///< own weathering degree at which the petals begin to wither

  bool operator==(const Flower&) const = default;
};

/// One kind of plant of a meadow.
struct Species {
  std::string name = "grass";
  double share = 1.0;  ///< of the patch's blades, relative to others; a shrub's: times these
  Plant plant;
  Physiology physiology;
  Habitat habitat = {};
  Flower flower = {};

  bool operator==(const Species&) const = default;
};

struct Sun {
  double elevation_deg = 38.0;
  double azimuth_deg = 235.0;  ///< where the sun stands, clockwise from north
  /// Year, month, day; if any, the sun stands where it stood then and there.
  std::vector<std::int64_t> date = {};
  double time_h = 12.0;  ///< of that day, universal time
  double latitude_deg = 47.0;
  double longitude_deg = 9.0;  ///< east positive
  /// Elevation and azimuth in the last frame, in degrees; none: it stands still.
  std::vector<double> end = {};

  bool operator==(const Sun&) const = default;
};

struct Sky {
  double turbidity = 2.5;        ///< Preetham's T: 2 very clear, 10 hazy
  double visual_range_m = 25e3;  ///< Koschmieder's, at which black things vanish in haze

  bool operator==(const Sky&) const = default;
};

/// The wind that has combed the grass, carries the flakes and may move the grass.
struct Wind {
  double heading_deg = 75.0;               ///< where it blows to, clockwise from north
  double lean_deg = 15.0;                  ///< mean angle by which the grass leans over
  double waves_deg = 9.0;                  ///< standard deviation of that angle from place to place
  double wave_length_m = 6.0;              ///< size of such places, along the wind
  WindPattern field = WindPattern::gusts;  ///< of flakes
  double speed_m_s = 1.5;                  ///< of flakes, and 10 m above the grass that it moves
  double turbulence = 0.25;  ///< standard deviation of that speed over its mean, in gusts
  GrassMotion grass = GrassMotion::still;

  bool operator==(const Wind&) const = default;
};

struct Camera {
  std::array<double, 2> eye_m = {21.0, 2.0};
  double eye_height_m = 1.6;  ///< above the ground under it
  std::array<double, 2> target_m = {21.0, 20.0};
  double target_height_m = 0.5;     ///< above the ground under it
  double field_of_view_deg = 55.0;  ///< horizontal
  /// East, north and height above the ground in the last frame, on a straight way; empty: it stays.
  std::vector<double> eye_end = {};
  std::vector<double> target_end = {};

  bool operator==(const Camera&) const = default;
};

struct Render {
  std::vector<std::string> renderers = {"blender", "povray"};  ///< exporters by name, each once
  std::array<int, 2> size_px = {960, 540};
  int samples = 4;  ///< per pixel
  GrassForm grass = GrassForm::texels;
  double exposure = 0.0;  ///< in stops
  int df3_bits = 8;
  Device device = Device::cpu;    ///< of Blender
  int threads = 0;                ///< 0: all
  double timeout_minutes = 60.0;  ///< per frame and renderer

  bool operator==(const Render&) const = default;
};

/// The time that passes in the landscape; frame k, from 1, shows it at (k - 1) frame_seconds. Shots
/// have clocks of their own, shots.h.
struct FilmTiming {
  double frame_seconds = 10.0;
  double frames_per_second = 24.0;  ///< at which it is played
  double shutter = 0.0;  ///< open for this share of the time between frames; 0 leaves them sharp

  bool operator==(const FilmTiming&) const = default;
};

/// Frames that follow each other without a cut. A film of shots shows them one after the other;
/// what a shot does not say of its camera and its rate, [camera] and [film] say for all of them.
struct Shot {
  std::string name;
  /// Year, month and day on which it begins, in a season; else empty.
  std::vector<std::int64_t> date = {};
  std::optional<double> time_h = {};  ///< of that day, universal time; none: that of [sun]
  double start_s = 0.0;               ///< where there is no season: on the scene's clock
  double seconds = 2.0;               ///< for which it is played
  double frame_seconds = 10.0;        ///< that pass in the landscape from frame to frame
  /// Where there is no season: weathering degree all through, or of its first and of its last
  /// frame; empty: 0.
  std::vector<double> weathering = {};
  Camera camera = {};  ///< its way leads from the shot's first frame to its last

  bool operator==(const Shot&) const = default;
};

/// What falls and how warm it is while the film lasts.
struct Weather {
  double temperature_c = -2.0;      ///< at the terrain's zero
  double precipitation_mm_h = 0.0;  ///< of water
  std::string table;  ///< path of comma-separated values over time, see snow/weather.h; it wins
  double earlier_h = 0.0;  ///< for how long it had been so when the film starts

  bool operator==(const Weather&) const = default;
};

/// The days that the film's frames are spread over evenly, or that its shots are of. With a first
/// day the film is a season: weathering degrees, weather and the sun's place follow the days, and
/// [ageing] frames, [weather] and [sun] elevation, azimuth and date do not count.
struct Season {
  std::vector<std::int64_t> first = {};  ///< year, month, day of the first frame; empty: no season
  std::vector<std::int64_t> last = {};   ///< of the last frame
  int frames = 120;
  std::string table;            ///< path of the weather day by day, weather/daily_weather.h
  double hollow_frost_k = 4.0;  ///< how much colder the nights of the deepest hollows are
  double spread_days = 5.0;     ///< standard deviation of what place and soil delay withering by

  bool operator==(const Season&) const = default;
};

/// What is so on a day of the season; linear between days that say, held before and after. What no
/// key says is as the table has it.
struct SeasonKey {
  std::vector<std::int64_t> date = {};       ///< year, month, day
  std::optional<double> weathering = {};     ///< degree, at the terrain's mean height
  std::optional<double> temperature_c = {};  ///< mean of the day, at the terrain's zero
  std::optional<double> precipitation_mm_day = {};
  std::optional<double> cloud_cover = {};  ///< how much of the clouds has gathered
  std::optional<double> wind_speed_m_s = {};
  std::optional<double> wind_heading_deg = {};
  std::optional<double> visual_range_m = {};  ///< of the air without rain

  bool operator==(const SeasonKey&) const = default;
};

/// Flakes in the air.
struct Snowfall {
  SnowfallStrength strength = SnowfallStrength::weather;
  Law motion = Law::physical;
  CrystalChoice crystal = CrystalChoice::mixed;
  int flakes = 0;  ///< drawn in the picture, about; 0: 30000, or [He2007]'s 500, 1000 or 4000
  std::array<double, 3> box_m = {16.0, 16.0, 10.0};  ///< [He2007]'s: east, north, up
  double shutter_s = 0.003;                          ///< how long each picture is exposed

  bool operator==(const Snowfall&) const = default;
};

/// Drops in the air.
struct Rainfall {
  int drops = 0;             ///< drawn in the picture, about; 0: 30000
  double shutter_s = 0.004;  ///< how long each picture is exposed for them

  bool operator==(const Rainfall&) const = default;
};

/// Snow on the ground and on the grass.
struct SnowCover {
  CoverModel cover = CoverModel::depth;
  double initial_mm = 0.0;       ///< of water that lies when the weather begins
  double drifting = 0.5;         ///< k of 1 + k tanh(Sx / 15 degrees)
  double blowing = 1.0;          ///< factor on the snow that wind lifts into the air
  double melt_mm_per_day = 3.0;  ///< degree-day factor, per kelvin above 0 degrees Celsius
  double feature_m = 0.35;       ///< size of the first patches of white
  double white_after_mm = 8.0;   ///< of water, of [He2007]'s cover: gamma is 1

  bool operator==(const SnowCover&) const = default;
};

/// A layer of clouds. What is empty is as models/cloud has it for the kind, or as the pictures do.
struct CloudLayer {
  CloudKind kind = CloudKind::cumulus;
  std::vector<std::string> textures;  ///< paths of pictures; none: made for the kind
  std::optional<double> base_m;       ///< above the terrain's zero
  std::optional<double> thickness_m;  ///< of the thickest clouds
  std::optional<double> cell_m;       ///< side of the square that a texture covers
  std::array<int, 2> cells = {8, 8};  ///< east and north; then the layer repeats
  std::optional<double> cover;        ///< fraction of the sky that is covered
  std::optional<double> opacity;      ///< of the densest place
  double gathered = 1.0;              ///< at the film's start: 0 none of it is there, 1 all
  CloudRepeat repeat = CloudRepeat::blend;
  Law motion = Law::physical;
  double speed_m_s = 8.0;
  double heading_deg = 90.0;  ///< where it drifts to, clockwise from north
  double gusts_m_s = 0.0;     ///< standard deviation of the velocity
  Law light = Law::physical;
  CloudBody body = CloudBody::sheet;

  bool operator==(const CloudLayer&) const = default;
};

/// Something that happens to the clouds on the film's time line. Each kind has keys of its own.
struct CloudEvent {
  CloudEventKind kind = CloudEventKind::wind;
  int layer = 0;         ///< the number of a layer, from 1; 0: all
  double start_s = 0.0;  ///< since the first frame
  double duration_s = 60.0;
  std::vector<std::int64_t> date = {};   ///< in a season: year, month, day on which it begins
  std::vector<std::int64_t> until = {};  ///< in a season: the day on which it has happened
  double heading_deg = 90.0;             ///< wind: where clouds drift to afterwards
  double speed_m_s = 10.0;               ///< wind: afterwards
  double shear = 1.0;                    ///< wind: how far it changes the clouds' shape
  double factor = 2.0;                   ///< faster, slower: of the speed
  double fraction = 1.0;  ///< gather, dissipate: fraction of the way to all, or to none
  std::vector<double> colour = {0.7, 0.4, 0.4};  ///< light: afterwards; empty: of sun_elevation_deg
  double sun_elevation_deg = 5.0;
  CloudFade fade = CloudFade::optical;

  bool operator==(const CloudEvent&) const = default;
};

struct Scene {
  std::string name = "meadow";
  std::uint64_t seed = 1;
  Terrain terrain;
  Growth growth;
  Grass grass;
  Ageing ageing;
  std::vector<Species> species;  ///< empty: the one of grass and ageing; see species.h
  Sun sun;
  Sky sky;
  Wind wind;
  FilmTiming film;
  std::vector<Shot> shots;  ///< empty: one film of ageing's or of the season's frames; see shots.h
  Weather weather;
  Season season;
  std::vector<Path> paths;
  std::vector<CoverClass> cover_classes;  ///< empty: ESA WorldCover's, cover_classes_of()
  std::vector<SeasonKey> season_keys;
  Snowfall snowfall;
  Rainfall rainfall;
  SnowCover snow_cover;
  std::vector<CloudLayer> clouds;
  std::vector<CloudEvent> cloud_events;
  Camera camera;
  Render render;

  bool operator==(const Scene&) const = default;
};

}  // namespace wold::scene
