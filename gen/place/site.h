#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "cloud/clouds.h"
#include "core/ground_map.h"
#include "light/daylight.h"
#include "phenology/film_season.h"
#include "place/growing_ground.h"
#include "place/mixture_field.h"
#include "place/withering.h"
#include "scene/scene.h"
#include "snow/cover.h"
#include "snow/crystal_picture.h"
#include "snow/large_cover.h"
#include "snow/weather.h"
#include "terrain/land_shadow.h"
#include "terrain/lighting.h"
#include "terrain/surface.h"
#include "terrain/surroundings.h"
#include "wind/air_flow.h"

namespace wold::place {

/// The snow of a film.
struct Snow {
  /// `folder`: see make_site(). Where it is not large, the ground has at most so many samples of
  /// snow along a side.
  Snow(const scene::Scene& scene, const std::shared_ptr<const snow::Weather>& weather,
       const Heightfield& terrain, const std::filesystem::path& folder, int max_samples);

  snow::FlakePictures pictures;
  snow::SnowGround ground;
  std::unique_ptr<snow::LargeCover> large;  ///< in its place on large terrains
};

/// What a part of the ground is like, without snow.
struct GroundPart {
  FactorMap growth;                      ///< growth_map()'s
  terrain::GroundLight light;            ///< under a clear sky
  ColourMap reflectance;                 ///< of the bare ground, radiance over irradiance
  std::optional<FactorMap> ledges = {};  ///< terrain::ledges(), where snow may lie on it
};

/// How fine maps of a site are at most that need not be as fine as renderers' pictures: values
/// along a side.
struct Sketch {
  int ground_samples;       ///< of the ground that is not large, and of what is white on it
  int light_samples;        ///< of light on the ground
  int lean_light_samples;   ///< of what leaning grass does to its light
  int snow_samples;         ///< of the snow on ground that is not large
  int sky_width_px = 1024;  ///< of the whole sky, where a backdrop stands before it
};

/// What stays the same from frame to frame: the place and the light of its day. Where the sun moves
/// the day is the one half-way, and only site_of_frame() has light and ground_reflectance.
struct Site {
  Heightfield terrain;
  std::shared_ptr<const terrain::FinerRelief> finer;  ///< of a large terrain, where it has some
  std::shared_ptr<const terrain::Water> water;        ///< of lakes and rivers, if there are any
  std::shared_ptr<const terrain::LandCover> cover;    ///< if it is known
  std::shared_ptr<const terrain::Scree> scree;        ///< of a large terrain, where it has some
  std::shared_ptr<const terrain::Photo> photo;        ///< if there is one
  std::shared_ptr<const terrain::Boulders> boulders;  ///< if there are any
  std::shared_ptr<const terrain::Paths> paths;        ///< if there are any
  std::shared_ptr<const terrain::GrazingSteps> grazing_steps;  ///< if there are any
  std::shared_ptr<const terrain::Surroundings> surroundings;
  FactorMap growth;                           ///< growth_map()'s
  std::optional<FactorMap> growth_of_window;  ///< the same in the CellWindow of a large terrain
  light::Daylight day;
  /// What land around hides of that day's sun; none where nobody knows that land.
  std::shared_ptr<const terrain::LandShadow> land_shadow;
  /// Under a clear sky; of a large terrain coarser where no camera sees it.
  terrain::GroundLight light;
  ColourMap ground_reflectance;     ///< the same of the bare ground, radiance over irradiance
  std::optional<FactorMap> ledges;  ///< terrain::ledges() of a large terrain that snow may lie on
  std::optional<cloud::Clouds> clouds;
  std::shared_ptr<const phenology::FilmSeason> season;  ///< if it is one
  std::shared_ptr<const snow::Weather> weather;
  std::shared_ptr<const Withering> withering;
  std::shared_ptr<const MixtureField> mixtures;
  std::shared_ptr<const Snow> snow;          ///< none where none can fall or lie
  std::shared_ptr<const wind::AirFlow> air;  ///< of grass that waves; none where it stands still
  std::shared_ptr<const wind::AirFlow> air_over_snow;  ///< none where wind lifts no snow
  std::optional<Sketch> sketch = {};                   ///< none: as fine as pictures need

  /// Whether the ground's surface() is uneven below the step of the terrain's heights.
  bool is_uneven() const { return finer || boulders || paths || grazing_steps; }

  /// The ground on a grid, or the parts of its rows that count, under snow; the site has to outlive
  /// it.
  terrain::Surface surface(const GroundGrid& grid, RowParts parts = {},
                           const terrain::SnowSurface& lying = {}) const;
};

/// Maps of a large terrain have as many samples as its pictures need; its snow is kept in tiled
/// pictures in `snow_folder`, which is made where it is needed and is the site's alone. Those of
/// any other have the usual steps, or those of a sketch. `season`: phenology::film_season() of the
/// scene, nullptr where that is none. Throws what terrain::make_ground(), growth_map(),
/// cloud::Clouds, snow::Weather and Snow's parts throw.
Site make_site(const scene::Scene& scene, std::shared_ptr<const phenology::FilmSeason> season,
               const std::filesystem::path& snow_folder = {},
               const std::optional<Sketch>& sketch = {});
/// The same on growing_ground() of the scene, which has been made before.
Site make_site(const scene::Scene& scene, GrowingGround land,
               std::shared_ptr<const phenology::FilmSeason> season,
               const std::filesystem::path& snow_folder);

/// How far one sees in a frame (from 1): sky.visual_range, in a season through that day's air.
double visual_range_m(const scene::Scene& scene, const Site& site, int frame);

/// The site at a frame (from 1): itself, but where the sun moves with the light of that moment, and
/// in a season with that day's air. Shares clouds and snow with it.
Site site_of_frame(const scene::Scene& scene, const Site& site, int frame);

/// The light of a site's day on all of the ground of a terrain that is not large. `surface`: its
/// heights with the snow on it, which is so deep.
terrain::GroundLight whole_light(const Site& site, const Heightfield& surface,
                                 const terrain::SnowSurface& lying = {});

/// Growth where cells are laid.
const FactorMap& growth_of_cells(const Site& site);

/// A part of a site's ground, of whose rows `parts` count: elsewhere nothing grows, and it is dark.
/// Its light is on the light_grid(), or as fine as the relief below the terrain's steps. `lying`
/// buries boulders, hides relief and is carved itself.
GroundPart ground_part(const scene::Scene& scene, const Site& site, const GroundGrid& grid,
                       RowParts parts, const terrain::SnowSurface& lying = {});

/// The light of a clear sky on such a part of a site's ground.
terrain::GroundLight light_on(const Site& site, const GroundGrid& grid, RowParts parts,
                              const terrain::SnowSurface& lying);

/// The same on all of a large terrain where a frame (from 1) shows it, as finely as whole_grid();
/// elsewhere the site's.
terrain::GroundLight light_in_frame(const scene::Scene& scene, const Site& site, int frame,
                                    const terrain::SnowSurface& lying);

/// The grid of the light on a part of the ground: as fine as `grid` or, where that is finer, as the
/// terrain; of a sketch no finer than it says.
GroundGrid light_grid(const Heightfield& terrain, const GroundGrid& grid,
                      const std::optional<Sketch>& sketch);

/// Leaf area, one side, of the scene's tapering blades per area of ground.
double leaf_area_index(const scene::Scene& scene);

}  // namespace wold::place
