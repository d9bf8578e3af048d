#include "film/assemble.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/colour.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "ground/boulders_in_view.h"
#include "ground/lit_ground.h"
#include "meadow/blade_parts.h"
#include "place/view.h"
#include "scene/calendar.h"
#include "scene/shots.h"
#include "scene/sun_path.h"
#include "scene/sun_position.h"
#include "scene/winter.h"
#include "sky/blowing_snow.h"
#include "sky/exposure.h"
#include "sky/frame_sky.h"
#include "sky/precipitation.h"
#include "sky/precipitation_medium.h"
#include "terrain/relief.h"

namespace wold::film {
namespace {

/// A part of a cell that is drawn.
struct Drawn {
  const meadow::CellChoice* choice;
  const landscape::PlacedPart* placed;
};

/// The parts of those cells that are drawn as blades, or of the others.
std::vector<Drawn> drawn_parts(std::span<const meadow::CellChoice> choices, bool blades) {
  std::vector<Drawn> parts;
  for (const meadow::CellChoice& choice : choices)
    if (choice.blades == blades)
      for (const landscape::PlacedPart& placed : choice.parts) parts.push_back({&choice, &placed});
  return parts;
}

landscape::CellOrigin origin_of(const Drawn& part) {
  return {part.choice->cell, part.choice->variant};
}

void add(const Drawn& part, int volume, std::vector<landscape::Cell>& cells) {
  const landscape::PlacedPart& placed = *part.placed;
  cells.push_back(
      {placed.world_from_cell, volume, part.choice->reach, placed.part, origin_of(part)});
}

void add(const Drawn& part, int mesh, std::vector<landscape::BladeCell>& cells) {
  cells.push_back({part.placed->world_from_cell, mesh, part.placed->part, origin_of(part)});
}

/// Each different patch once, in ascending order of `key`, and the cells that refer to them.
template <class Key, class Lookup, class Patch, class Instance>
void place(const std::vector<Drawn>& parts, const Key& key, const Lookup& lookup,
           std::vector<Patch>& patches, std::vector<Instance>& cells) {
  using Value = std::invoke_result_t<Key, const Drawn&>;
  std::map<Value, int> numbers;
  std::map<Value, const Drawn*> examples;
  for (const Drawn& part : parts) examples.emplace(key(part), &part);
  for (const auto& [value, example] : examples) {
    numbers[value] = static_cast<int>(patches.size());
    patches.push_back(lookup(*example));
  }
  for (const Drawn& part : parts) add(part, numbers.at(key(part)), cells);
}

std::tuple<int, grass::PatchState, int, int> volume_key(const Drawn& part) {
  const meadow::CellChoice& choice = *part.choice;
  return {choice.variant, choice.state(), choice.turn, choice.lod};
}

std::tuple<int, grass::PatchState, grass::BladeBend, landscape::Part> blades_key(
    const Drawn& part) {
  return {part.choice->variant, part.choice->state(), part.choice->bend, part.placed->part};
}

/// Where none of a patch's blades stands on a part, there is nothing to draw.
void leave_out_empty_meshes(landscape::Landscape& landscape) {
  std::vector<int> number(landscape.blade_meshes.size(), -1);
  std::vector<landscape::BladeMesh> meshes;
  for (std::size_t i = 0; i < number.size(); ++i) {
    landscape::BladeMesh& mesh = landscape.blade_meshes[i];
    if (mesh.tubes && mesh.tubes->count() == 0) continue;
    number[i] = static_cast<int>(meshes.size());
    meshes.push_back(std::move(mesh));
  }
  landscape.blade_meshes = std::move(meshes);
  for (landscape::BladeCell& cell : landscape.blade_cells)
    cell.mesh = number[static_cast<std::size_t>(cell.mesh)];
  std::erase_if(landscape.blade_cells,
                [](const landscape::BladeCell& cell) { return cell.mesh < 0; });
}

/// All that stands on the ground.
void place_grass(std::span<const meadow::CellChoice> choices, const PatchLookup& lookup,
                 landscape::Landscape& landscape) {
  const auto volume = [&](const Drawn& part) { return lookup.volume(*part.choice); };
  const auto blades = [&](const Drawn& part) {
    return meadow::part_of(lookup.blades(*part.choice), landscape.patch_m, part.placed->part);
  };
  place(drawn_parts(choices, /*blades=*/false), volume_key, volume, landscape.volumes,
        landscape.cells);
  place(drawn_parts(choices, /*blades=*/true), blades_key, blades, landscape.blade_meshes,
        landscape.blade_cells);
  leave_out_empty_meshes(landscape);
}

sky::Subject bare_subject(const scene::Scene& scene) {
  return scene.clouds.empty() ? sky::Subject::meadow : sky::Subject::clouds;
}

/// What the camera leaves of how dark it gets in a take. A season's frames are days apart, and each
/// is exposed anew.
double dusk(const scene::Scene& scene, int frame) {
  const auto elevation_deg = [](const scene::Sun& sun) {
    return scene::sun_position(sun).elevation_deg;
  };
  const double now_deg = elevation_deg(scene::sun_of_frame(scene, frame));
  if (scene::is_season(scene) && scene.shots.empty()) return sky::dusk_gain(now_deg, now_deg);
  const scene::Take take = scene::take_of(scene, frame);
  return sky::dusk_gain(now_deg, std::max(elevation_deg(scene::sun_on_way(scene, take, 0.0)),
                                          elevation_deg(scene::sun_on_way(scene, take, 1.0))));
}

/// The camera follows the ground as it whitens, and the `light` on it as clouds and snowfall hide
/// the sun. A film in which it may snow is exposed for snow before that, too; a season is too long
/// for it.
double gain(const scene::Scene& scene, const light::Daylight& day,
            const ground::SnowyGround& ground, const ColourMap& light) {
  const bool for_snow =
      !scene::is_season(scene) && (scene::may_lie(scene) || scene::may_snow(scene));
  const double for_bare =
      sky::metered_gain(day, for_snow ? sky::Subject::snow : bare_subject(scene));
  return std::lerp(for_bare, sky::snow_gain(day, light), ground.white_fraction());
}

/// What it leaves where it looks towards a low sun, as far as that is `open`, from 0 to 1: none
/// under an overcast sky.
double sunward(const place::Site& site, const landscape::Landscape& landscape, double open,
               double gain) {
  const double height_over_width = 1.0 * landscape.height_px / landscape.width_px;
  return math::pow(
      sky::sunward_gain(site.day, site.terrain, landscape.camera, height_over_width, gain), open);
}

/// `illuminate`: what clouds and snow make of the light on the ground under a clear sky.
template <class Illuminate>
landscape::Daylight open_daylight(const light::Daylight& day, double sunlit_fraction,
                                  const Illuminate& illuminate) {
  constexpr int samples = 2;
  constexpr Square square{.size_m = 1.0};
  const terrain::GroundLight by_sky{ColourMap(samples, square, glm::vec3(0.0F)),
                                    ColourMap(samples, square, day.sky_irradiance()),
                                    FactorMap(samples, square, 1.0F)};
  return {day.sun_direction(), day.sun_irradiance() * static_cast<float>(sunlit_fraction),
          illuminate(by_sky).at(0, 0)};
}

/// Fraction of the sun's light on open ground that reaches each place: less where hills and clouds
/// stand before it.
template <class Illuminate>
FactorMap sunlit_fraction(const ground::SnowyGround& ground, const landscape::Daylight& day,
                          const Illuminate& illuminate) {
  constexpr double flattest_cosine = 1e-3;
  const std::optional<terrain::GroundLight> uncarved = ground.uncarved_light();
  const terrain::GroundLight& clear = uncarved ? *uncarved : ground.light();
  const int samples = clear.sun.samples();
  const ColourMap dark(samples, clear.sun.square(), glm::vec3(0.0F));
  const ColourMap by_sun = illuminate(
      terrain::GroundLight{clear.sun, dark, FactorMap(samples, clear.sun.square(), 0.0F)});
  const Heightfield& surface = ground.surface();
  const double sun = luminance(day.sun_irradiance);
  FactorMap fraction(samples, clear.sun.square(), 0.0F);
  if (sun <= 0.0) return fraction;
  parallel_for(static_cast<std::size_t>(samples), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < samples; ++i) {
      const glm::dvec2 at_m = clear.sun.place_m(i, j);
      const double cosine = glm::dot(terrain::normal(surface, at_m.x, at_m.y), day.to_sun);
      fraction.at(i, j) = static_cast<float>(
          std::min(1.0, luminance(by_sun.at(i, j)) / (sun * std::max(cosine, flattest_cosine))));
    }
  });
  return fraction;
}

/// Snow that wind may lift: what lies where no grass stands out of it.
template <class Illuminate>
sky::SnowField snow_field(const ground::SnowyGround& ground, const landscape::Daylight& day,
                          const Illuminate& illuminate) {
  const auto loose = [&ground, growth = ground.growth()](const glm::dvec2& at_m) {
    const double open = 1.0 - growth.sample(at_m.x, at_m.y);
    return ground.white_fraction(at_m) * open * open;  // a few plants shelter much
  };
  return {loose, sunlit_fraction(ground, day, illuminate), ground.mean_albedo()};
}

}  // namespace

AssembledFrame assemble_frame(const scene::Scene& scene, const place::Site& site,
                              const meadow::FrameGrass& now,
                              std::span<const meadow::CellChoice> choices,
                              const PatchLookup& lookup, const landscape::Needs& needs) {
  const int frame = now.frame;
  AssembledFrame assembled;
  landscape::Landscape& landscape = assembled.landscape;
  landscape.frame = frame;
  landscape.weathering = scene.ageing.frames.at(static_cast<std::size_t>(frame - 1));
  landscape.time_s = scene::time_s(scene, frame);
  landscape.patch_m = scene.grass.patch_m;
  landscape.camera = place::camera_of_frame(scene, site.terrain, frame);
  landscape.width_px = scene.render.size_px[0];
  landscape.height_px = scene.render.size_px[1];
  landscape.samples = scene.render.samples;
  place_grass(choices, lookup, landscape);
  assembled.ground = std::make_unique<const ground::SnowyGround>(scene, site, frame);
  const ground::SnowyGround& ground = *assembled.ground;
  landscape.terrain = ground.surface();
  if (site.boulders) landscape.boulders = ground::boulders_in_view(site, landscape);
  const sky::FrameSky sky(scene, site, frame, landscape.camera.eye_m);
  const double overcast_per_m = sky::overcast_extinction_per_m(scene, site, frame);
  const sky::PrecipitationMedium air(site.day, overcast_per_m, ground.mean_albedo());
  const auto illuminate = [&](const terrain::GroundLight& clear) {
    const ColourMap light = sky.light(clear);
    return overcast_per_m > 0.0 ? air.light(light, clear.overcast) : light;
  };
  landscape.daylight = open_daylight(site.day, air.sunlit_fraction(), illuminate);
  assembled.light = illuminate(ground.light());
  const double metered = gain(scene, site.day, ground, assembled.light) * dusk(scene, frame);
  const double open = air.sunlit_fraction() * sky.openness();
  landscape.exposure_gain =
      metered * sunward(site, landscape, open, metered) * math::exp2(scene.render.exposure);
  sky.show(landscape,
           overcast_per_m > 0.0 || ground::sees_land_around(site, landscape.camera, scene.render));
  const auto mirrored_sky = [&, image = landscape.sky](const glm::dvec3& direction) {
    const glm::vec3 clear = ground::sky_radiance(image, direction);
    return overcast_per_m > 0.0 ? air.sky_radiance(clear, direction) : clear;
  };
  ground::LitGround(scene, site, now, landscape, choices, lookup.far, illuminate)
      .show(ground, assembled.light, mirrored_sky, landscape);
  if (overcast_per_m > 0.0) sky::add_precipitation(scene, site, air, needs, landscape);
  if (ground.white_fraction() > 0.0)
    sky::add_blowing_snow(
        scene, site, [&] { return snow_field(ground, landscape.daylight, illuminate); }, landscape);
  // Under an overcast sky the air itself shines: there is none without it.
  if (needs.materials)
    landscape.unlit = landscape::Unlit{
        landscape.daylight.sun_irradiance,
        overcast_per_m > 0.0 ? landscape.sky : sky.unlit(landscape.camera), ground.albedo()};
  return assembled;
}

landscape::Landscape assemble(const scene::Scene& scene, const place::Site& site,
                              const meadow::FrameGrass& now,
                              std::span<const meadow::CellChoice> choices,
                              const PatchLookup& lookup, const landscape::Needs& needs) {
  return assemble_frame(scene, site, now, choices, lookup, needs).landscape;
}

}  // namespace wold::film
