#include "ground/lit_ground.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "core/cropped_map.h"
#include "core/filled_map.h"
#include "core/parallel.h"
#include "core/pinhole.h"
#include "grass/optics/light_under_grass.h"
#include "grass/texel/fibres.h"
#include "meadow/film_lights.h"
#include "meadow/light_grids.h"
#include "meadow/sward.h"
#include "meadow/tint.h"
#include "place/cell_window.h"
#include "place/each_in_view.h"
#include "place/ground_grids.h"
#include "place/ground_views.h"
#include "scene/calendar.h"
#include "scene/species.h"

namespace wold::ground {
namespace {

/// A patch of all that grows, but for shrubs that stand here and there: evergreen ones would give
/// withered grass the tint of what they lack.
int patch_of_grass(const scene::Scene& scene) {
  return scene::patch_number(scene, scene::without_shrubs(scene, 0), 0);
}

/// Mean colour of the meadow's grass by weathering degree, under `snow` and what the cells show.
meadow::GrassColour grass_colour(const grass::WitheringPatch& patch,
                                 const grass::MeadowModel& model, double snow,
                                 std::span<const meadow::CellChoice> choices) {
  constexpr int steps = 64;
  std::map<double, std::vector<glm::vec3>> colours = {{snow, {}}};
  for (const meadow::CellChoice& choice : choices) colours[choice.state().snow_fraction()];
  for (auto& entry : colours) {
    std::vector<glm::vec3>& by_weathering = entry.second;
    by_weathering.resize(steps + 1);
    parallel_for(by_weathering.size(), [&](std::size_t i) {
      by_weathering[i] =
          grass::mean_albedo(patch.at(static_cast<double>(i) / steps, entry.first), model);
    });
  }
  return [colours](double weathering, double fraction) {
    const std::vector<glm::vec3>& by_weathering = colours.at(fraction);
    const double place = std::clamp(weathering, 0.0, 1.0) * steps;
    const auto i = std::min(static_cast<std::size_t>(place), std::size_t{steps - 1});
    return glm::mix(by_weathering[i], by_weathering[i + 1],
                    static_cast<float>(place - static_cast<double>(i)));
  };
}

/// What its lean does to the light of the frame's grass.
meadow::LeanLight lean_light(const scene::Scene& scene, const place::Site& site, int frame,
                             const grass::BladePatch& patch, const grass::MeadowModel& model) {
  constexpr int fibres = 150;
  return {grass::representative_fibres(patch, model, fibres),
          meadow::frame_lighting(scene, site, frame),
          static_cast<float>(scene.grass.specular_exponent)};
}

/// The grid of what lean does to light, on a part of the ground of a large terrain or a sketch: it
/// costs much.
GroundGrid lean_light_grid(const GroundGrid& grid, const std::optional<place::Sketch>& sketch) {
  constexpr int apart = 4;
  const int usual = (grid.samples - 1) / apart + 1;
  return {grid.square, sketch ? std::min(grid.samples, sketch->lean_light_samples) : usual};
}

/// Adds what ground with that reflectance makes of a light.
void add_reflected(const ColourMap& reflectance, const ColourMap& light, ColourMap& radiance) {
  parallel_for(static_cast<std::size_t>(radiance.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < radiance.samples(); ++i) {
      const glm::dvec2 at_m = radiance.place_m(i, j);
      radiance.at(i, j) += reflectance.sample(at_m.x, at_m.y) * light.sample(at_m.x, at_m.y);
    }
  });
}

/// What of the light comes straight from the sun.
terrain::GroundLight sun_of(const terrain::GroundLight& clear) {
  const int samples = clear.sun.samples();
  const Square& square = clear.sun.square();
  return {clear.sun, ColourMap(samples, square, glm::vec3(0.0F)), FactorMap(samples, square, 0.0F)};
}

meadow::PatchAppearances far_appearances(const scene::Scene& scene, const place::Site& site,
                                         const meadow::FrameGrass& now, const FarLook& far) {
  meadow::PatchAppearances looks;
  for (const int mixture : site.mixtures->present())
    for (const grass::PatchState& state : meadow::far_states(scene, *site.withering, now))
      looks.emplace(std::pair(mixture, state), far(mixture, state));
  return looks;
}

}  // namespace

std::optional<meadow::Meadow> far_meadow(const scene::Scene& scene, const place::Site& site,
                                         const meadow::FrameGrass& now, const place::View& view,
                                         const FarLook& far) {
  if (!shows_distance(scene, site, now.frame)) return std::nullopt;
  return std::optional<meadow::Meadow>(std::in_place, scene, site.terrain, *site.mixtures,
                                       *site.withering, view, now,
                                       far_appearances(scene, site, now, far));
}

LitGround::LitGround(const scene::Scene& scene, const place::Site& site,
                     const meadow::FrameGrass& now, const landscape::Landscape& landscape,
                     std::span<const meadow::CellChoice> choices, const FarLook& far,
                     Illuminate illuminate)
    : scene_(scene),
      site_(site),
      choices_(choices),
      illuminate_(std::move(illuminate)),
      now_(now),
      view_(landscape.camera, landscape.width_px, landscape.height_px),
      eye_m_(landscape.camera.eye_m),
      haze_(site.day, eye_m_),
      model_(scene),
      patch_(scene, model_, patch_of_grass(scene)),
      lean_light_(
          lean_light(scene, site, now.frame, patch_.at(landscape.weathering, now.snow), model_)),
      under_grass_(grass::light_under_grass(patch_.at(landscape.weathering, now.snow), model_,
                                            meadow::frame_lighting(scene, site, now.frame))),
      shared_gaps_(patch_.at(landscape.weathering, now.snow), model_),
      shrub_shade_(scene, choices, site.day.sun_direction()),
      meadow_(far_meadow(scene, site, now_, view_, far)) {
  if (scene.ageing.pigment_spread > 0.0)
    pigment_spread_.emplace(scene, patch_, now.snow,
                            meadow::frame_lighting(scene, site, now.frame));
}

ColourMap LitGround::shaded_by_shrubs(ColourMap light, const terrain::GroundLight& clear,
                                      const SnowyGround& ground, const GroundGrid& grid) const {
  const GroundGrid own{light.square(), light.samples()};
  const std::optional<FactorMap> sunlit = shrub_shade_.sunlit(
      site_.terrain, grid.samples > own.samples ? grid : own, ground.layer().depth_m);
  if (!sunlit) return light;
  const ColourMap sun = illuminate_(sun_of(clear));
  return filled<ColourMap>({sunlit->square(), sunlit->samples()}, [&](const glm::dvec2& at_m) {
    const float shade = 1.0F - sunlit->sample(at_m.x, at_m.y);
    return light.sample(at_m.x, at_m.y) - shade * sun.sample(at_m.x, at_m.y);
  });
}

ColourMap LitGround::on_grass(ColourMap light, const terrain::GroundLight& clear,
                              const GroundGrid& grid, const place::View& view,
                              const meadow::Sward::StepAt& shown_step_m) const {
  // Maps are large: each goes before the next one is made.
  const GroundGrid own{light.square(), light.samples()};
  ColourMap on_grass =
      product(std::move(light),
              place::is_large(scene_) || site_.sketch
                  ? meadow::lean_light_map(lean_light_, now_.wind_lean, site_.terrain, view,
                                           lean_light_grid(grid, site_.sketch))
                  : meadow::lean_light_map(lean_light_, now_.wind_lean, site_.terrain, view));
  if (place::is_large(scene_) && scene_.grass.unevenness > 0.0) {
    const meadow::Sward sward(scene_, GroundGrid{clear.sun.square(), clear.sun.samples()}.step_m());
    on_grass = product(std::move(on_grass),
                       meadow::sward_light_map(sward, clear, site_.day.sun_direction(),
                                               site_.terrain, view, shown_step_m));
  }
  if (!pigment_spread_) return on_grass;
  return product(std::move(on_grass),
                 meadow::pigment_spread_map(*pigment_spread_, *site_.withering, now_.frame,
                                            site_.terrain, view, own));
}

void LitGround::add_hot_spot(const ColourMap& bare, const terrain::GroundLight& clear,
                             const FactorMap& growth, const place::View& view,
                             ColourMap& radiance) const {
  const Square square = clear.sun.square();
  const int samples = clear.sun.samples();
  terrain::GroundLight more{ColourMap(samples, square), ColourMap(samples, square),
                            FactorMap(samples, square)};
  const glm::dvec3& sun = site_.day.sun_direction();
  place::each_in_view(more.sun, site_.terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const double grown{growth.sample(at_m.x, at_m.y)};
    more.sun.at(i, j) = clear.sun.at(i, j) * static_cast<float>(shared_gaps_.more_sunlit(
                                                 sun, -view.line_of_sight(at_m), grown));
  });
  add_reflected(bare, illuminate_(more), radiance);
}

ColourMap LitGround::painted(ColourMap ground, const FactorMap& growth, const ColourMap& light,
                             const ColourMap& grass_light, const LakeSurface* lakes,
                             const place::View& view) const {
  if (lakes != nullptr) lakes->add_to(ground, light, view);
  if (!meadow_) return ground;
  meadow::paint_far_grass(ground, scene_, site_.terrain, growth, grass_light, view, *meadow_);
  veil_ground(ground, site_.terrain, view, haze_);
  return ground;
}

landscape::GroundDetail LitGround::detail(const SnowyGround& ground, const GroundGrid& grid,
                                          const place::View& view, const LakeSurface* lakes,
                                          const ColourMap& coarser) const {
  const double margin_m = place::margin_in_view_m(view, grid.step_m());
  const RowParts made =
      place::rows_in_view(grid, site_.terrain, view, margin_m + 2.0 * grid.step_m());
  const auto [part, bare] =
      ground.covered(place::ground_part(scene_, site_, grid, made, ground.layer()), under_grass_);
  const ColourMap light = shaded_by_shrubs(illuminate_(part.light), part.light, ground, grid);
  ColourMap radiance = product(part.reflectance, light);
  add_hot_spot(bare, part.light, part.growth, view, radiance);
  radiance = painted(std::move(radiance), part.growth, light,
                     on_grass(light, part.light, grid, view), lakes, view);
  // What lies around that has no haze and no far grass on it.
  const RowParts painted_on = place::rows_in_view(grid, site_.terrain, view, margin_m);
  return {filled_up(radiance, painted_on, coarser).at_corner(glm::dvec2(0.0)),
          grid.square.corner_m};
}

ColourMap LitGround::light_on_cells(const SnowyGround& ground, const GroundGrid& grid,
                                    const place::View& in_sight) const {
  // Under all of a cell that reaches into the picture.
  const RowParts lit =
      place::rows_in_view(grid, site_.terrain, in_sight, 2.0 * meadow::cell_reach_m(scene_));
  const terrain::GroundLight clear = place::light_on(site_, grid, lit, ground.layer());
  const meadow::ShownSteps shown(scene_, eye_m_);
  return on_grass(shaded_by_shrubs(illuminate_(clear), clear, ground, grid), clear, grid, in_sight,
                  [&](const glm::dvec3& place_m) { return shown.at(place_m); });
}

ColourMap LitGround::veiled_and_tinted(ColourMap grass_light, const meadow::GrassColour& colour,
                                       const GroundGrid& tint_grid) const {
  if (meadow_) {
    const ColourMap veil = veil_of_grass(grass_light, site_.terrain, view_, *meadow_, haze_);
    grass_light = product(std::move(grass_light), veil);
  }
  return product(std::move(grass_light),
                 meadow::weathering_tint(scene_, *site_.withering, now_.frame, choices_, now_.snow,
                                         colour, tint_grid));
}

void LitGround::show_light_on_grass(const SnowyGround& ground, ColourMap grass_light,
                                    landscape::Landscape& landscape) const {
  const bool is_large = place::is_large(scene_);
  const place::View in_sight = view_.over(site_.terrain);
  if (is_large) {
    grass_light = {};  // goes before the next one is made
    grass_light = light_on_cells(ground, place::window_grid(scene_), in_sight);
  }
  const meadow::GrassColour colour = grass_colour(patch_, model_, now_.snow, choices_);
  landscape.light = veiled_and_tinted(std::move(grass_light), colour, place::tint_grid(scene_));
  if (!is_large || choices_.empty()) return;
  landscape.light = cropped(landscape.light, meadow::square_of_cells(scene_, choices_));
  if (site_.sketch) return;
  for (const GroundGrid& grid : meadow::light_detail_grids(scene_, choices_, site_.terrain, eye_m_))
    landscape.light_details.push_back(
        veiled_and_tinted(light_on_cells(ground, grid, in_sight), colour, grid));
}

struct LitGround::LevelLook {
  const LitGround& of;
  const ColourMap reflectance;
  const FactorMap growth;
  const ColourMap& light;
  const ColourMap& grass_light;
  const glm::dvec3 sight;

  LevelLook(const LitGround& lit, const SnowyGround& ground, const ColourMap& on_ground,
            const ColourMap& on_grass, const landscape::Camera& camera)
      : of(lit),
        reflectance(ground.reflectance(lit.under_grass_)),
        growth(ground.growth()),
        light(on_ground),
        grass_light(on_grass),
        sight(level_sight(camera)) {}

  glm::vec3 at(const glm::dvec2& at_m) const {
    constexpr float min = 1e-4F;
    const glm::dvec3 place_m = place::above_ground(of.site_.terrain, at_m, 0.0);
    const landscape::AggregateAppearance grass =
        meadow::thickened(of.meadow_->look(place_m, sight), growth.sample(at_m.x, at_m.y));
    const glm::vec3 on_blades =
        grass_light.sample(at_m.x, at_m.y) / glm::max(light.sample(at_m.x, at_m.y), glm::vec3(min));
    return glm::vec3(grass.radiance) * on_blades +
           static_cast<float>(grass.transmittance) * reflectance.sample(at_m.x, at_m.y);
  }

 private:
  static glm::dvec3 level_sight(const landscape::Camera& camera) {
    constexpr double grazing = 0.06;  // how much lower than level one looks at far land
    const CameraAxes axes(camera.eye_m, camera.target_m);
    const glm::dvec3 level = glm::cross(glm::dvec3(0.0, 0.0, 1.0), axes.right);
    return glm::normalize(level - glm::dvec3(0.0, 0.0, grazing));
  }
};

/// Water is no land that land around could look like.
LandAppearance LitGround::land_appearance(const LevelLook& look) const {
  constexpr int places = LandAppearance::places;
  constexpr double most_water = 0.5;
  const double step_m = site_.terrain.size_m() / places;
  std::vector<glm::dvec2> all_m, land_m;
  for (int place = 0; place < places * places; ++place)
    all_m.push_back((glm::dvec2(place % places, place / places) + 0.5) * step_m);
  std::ranges::copy_if(all_m, std::back_inserter(land_m), [&](const glm::dvec2& at_m) {
    return !site_.water || site_.water->share(at_m, 1.0) <= most_water;
  });
  const std::vector<glm::dvec2>& looked_at_m = land_m.empty() ? all_m : land_m;
  std::vector<LandSample> samples(looked_at_m.size());
  parallel_for(samples.size(), [&](std::size_t i) {
    const glm::dvec2& at_m = looked_at_m[i];
    const terrain::Surroundings& land = *site_.surroundings;
    samples[i] = {land.up(at_m, land.step_m(at_m)), double{site_.terrain.sample(at_m.x, at_m.y)},
                  look.at(at_m)};
  });
  return LandAppearance(samples);
}

LandAround LitGround::land_around(const LevelLook& look) const {
  return {*site_.surroundings, site_.day, haze_, land_appearance(look), illuminate_, scene_.seed};
}

std::unique_ptr<const LakeSurface> LitGround::lake_surface(
    const SnowyGround& ground, const ColourMap& light, const ColourMap& grass_light,
    const LandAround& around, const SkyRadiance& sky, const landscape::Landscape& landscape) const {
  const landscape::Camera& camera = landscape.camera;
  const Square& square = site_.surroundings->square();
  const LevelLook look(*this, ground, light, grass_light, camera);
  const auto of_around = [&](double width_m) {
    constexpr int samples = 193;
    const Square wide{square.corner_m - 0.5 * (width_m - square.size_m), width_m};
    const GroundGrid grid{wide, samples};
    return filled<ColourMap>(
        grid, [&](const glm::dvec2& at_m) { return around.near_radiance(at_m, grid.step_m()); });
  };
  constexpr int samples_of_square = 513;
  const std::optional<terrain::GroundLight> uncarved = ground.uncarved_light();
  OverLakes over{{*site_.surroundings, landscape.terrain, *site_.water, camera.eye_m,
                  panorama(camera, landscape.width_px, landscape.height_px)},
                 {filled<ColourMap>({square, samples_of_square},
                                    [&](const glm::dvec2& at_m) {
                                      return look.at(at_m) * light.sample(at_m.x, at_m.y);
                                    }),
                  of_around(3.0 * square.size_m),
                  of_around(square.size_m + 2.0 * site_.surroundings->reach_m())},
                 sky,
                 sun_alone(uncarved ? *uncarved : ground.light()),
                 camera.eye_m};
  return std::make_unique<const LakeSurface>(site_, ground, scene::time_s(scene_, now_.frame),
                                             scene_.seed, std::move(over));
}

/// What of the sun's light reaches places, whatever way they face.
ColourMap LitGround::sun_alone(const terrain::GroundLight& clear) const {
  ColourMap sun = illuminate_(sun_of(clear));
  const auto sine = static_cast<float>(std::max(site_.day.sun_direction().z, 1e-3));
  for (glm::vec3& irradiance : sun.values())
    irradiance = glm::min(irradiance / sine, site_.day.sun_irradiance());
  return sun;
}

glm::vec3 LitGround::seen_around(const LandAround& around, const LakeSurface* lakes,
                                 const glm::dvec2& at_m, double step_m) const {
  constexpr double water_step_m = 10.0;  // waves are smaller
  if (lakes == nullptr || lakes->open_water(at_m, water_step_m) < 0.5)
    return around.radiance(at_m, step_m);
  return haze_.before(lakes->at(at_m, water_step_m).radiance, {at_m, site_.water->level_m(at_m)});
}

void LitGround::show_land_around(const LandAround& around, const LakeSurface* lakes,
                                 landscape::Landscape& landscape) const {
  const landscape::Camera& camera = landscape.camera;
  const LandView view(*site_.surroundings, landscape.terrain, camera.eye_m,
                      panorama(camera, landscape.width_px, landscape.height_px));
  paint_land_around([&](const glm::dvec2& at_m,
                        double step_m) { return seen_around(around, lakes, at_m, step_m); },
                    around, view, camera.eye_m, *landscape.backdrop);
}

/// Where snow lies the ground is higher than the terrain, boulders are in their places. Light that
/// has fewer values than the pictures is made everywhere.
std::vector<place::View> LitGround::views_of_pictures(const SnowyGround& ground,
                                                      const std::vector<GroundGrid>& details,
                                                      const landscape::Landscape& landscape) const {
  if (details.empty()) return {view_};
  const place::View in_sight = view_.over(landscape.terrain);
  const bool coarse_light = site_.sketch || (!site_.is_uneven() && !ground.layer().carved);
  if (coarse_light) return std::vector(details.size() + 1, in_sight);
  const landscape::RaisedGround& boulders = landscape.boulders;
  const bool snowed = static_cast<bool>(ground.layer());
  const auto stands = [&](const Square& square) {
    return snowed || std::ranges::any_of(boulders.points_m, [&](const glm::vec3& point_m) {
             return square.contains(glm::dvec2(boulders.origin_m) + glm::dvec2(point_m));
           });
  };
  return place::views_of_pictures(in_sight, place::whole_grid(scene_), details, stands);
}

void LitGround::show(const SnowyGround& ground, ColourMap& light, const SkyRadiance& sky,
                     landscape::Landscape& landscape) const {
  light = shaded_by_shrubs(
      std::move(light), ground.light(), ground,
      place::is_large(scene_) ? place::whole_grid(scene_) : place::window_grid(scene_));
  const std::vector<GroundGrid> details = place::detail_grids(scene_, landscape.camera);
  const std::vector<place::View> pictures = views_of_pictures(ground, details, landscape);
  const bool sees_around =
      landscape.backdrop && sees_land_around(site_, landscape.camera, scene_.render);
  const bool looked_at_from_afar = sees_around || site_.water;
  // Land around is to look like this one, also like what this picture does not show.
  ColourMap grass_light = on_grass(light, ground.light(), place::whole_grid(scene_),
                                   looked_at_from_afar ? view_ : pictures.front());
  std::optional<LandAround> around;
  if (looked_at_from_afar)
    around.emplace(land_around(LevelLook(*this, ground, light, grass_light, landscape.camera)));
  const std::unique_ptr<const LakeSurface> lakes =
      site_.water ? lake_surface(ground, light, grass_light, *around, sky, landscape) : nullptr;
  ColourMap radiance = product(ground.reflectance(under_grass_), light);
  add_hot_spot(ground.bare(), ground.light(), ground.growth(), pictures.front(), radiance);
  landscape.ground = painted(std::move(radiance), ground.growth(), light, grass_light, lakes.get(),
                             pictures.front());
  for (std::size_t i = 0; i < details.size(); ++i)
    landscape.ground_details.push_back(
        detail(ground, details[i], pictures[i + 1], lakes.get(), landscape.ground));

  if (sees_around) show_land_around(*around, lakes.get(), landscape);
  show_light_on_grass(ground, std::move(grass_light), landscape);
  landscape.extinction_factor = ground.extinction_factor(
      meadow::grass_extinction_factor(scene_, site_.terrain, place::growth_of_cells(site_), view_));
  if (!place::is_large(scene_) || choices_.empty()) return;
  landscape.extinction_factor =
      cropped(landscape.extinction_factor, meadow::square_of_cells(scene_, choices_));
}

bool sees_land_around(const place::Site& site, const landscape::Camera& camera,
                      const scene::Render& render) {
  return sees_land_around(*site.surroundings, site.terrain, camera, render.size_px[0],
                          render.size_px[1]);
}

bool shows_distance(const scene::Scene& scene, const place::Site& site, int frame) {
  const landscape::Camera camera = place::camera_of_frame(scene, site.terrain, frame);
  const place::View view(camera, scene.render.size_px[0], scene.render.size_px[1]);
  return site.water || sees_land_around(site, camera, scene.render) ||
         meadow::has_far_field(scene, site.terrain, view) ||
         shows_haze(site.terrain, camera.eye_m, place::visual_range_m(scene, site, frame));
}

}  // namespace wold::ground
