#include "film/ground_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "ground/lit_ground.h"
#include "meadow/cell_lattice.h"
#include "meadow/far_field.h"
#include "place/air.h"
#include "place/cell_window.h"
#include "place/view.h"
#include "scene/shots.h"
#include "scene/species.h"

namespace wold::film {
namespace {

/// Of the species of a mixture, each by the area of its blades and petals.
std::vector<double> fractions_of(const scene::Scene& scene,
                                 const std::vector<scene::Species>& species,
                                 const scene::Mixture& mixture) {
  const std::vector<int> blades = scene::blades_of(scene, mixture);
  std::vector<double> areas(species.size(), 0.0);
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    const auto one = static_cast<std::size_t>(mixture[i]);
    areas[one] = blades[i] * scene::blade_area_m2(species[one]);
  }
  const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (double& area : areas) area = all > 0.0 ? area / all : 0.0;
  return areas;
}

/// Names that two species share, and those of none, get the species' number.
std::vector<std::string> names_of(const std::vector<scene::Species>& species) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < species.size(); ++i) {
    std::string name = species[i].name.empty() ? "grass" : species[i].name;
    if (name == "ground" || name == "snow" || std::ranges::count(names, name) > 0)
      name += fmt::format("_{}", i + 1);
    names.push_back(std::move(name));
  }
  return names;
}

/// The camera of the next frame. After the last one before a cut it goes on as it came.
landscape::Camera next_camera(const scene::Scene& scene, const place::Site& site, int frame) {
  const auto camera = [&](int of_frame) {
    return place::camera_of_frame(scene, site.terrain, of_frame);
  };
  const scene::Take take = scene::take_of(scene, frame);
  if (frame < take.last()) return camera(frame + 1);
  landscape::Camera next = camera(frame);
  if (take.count < 2) return next;
  const landscape::Camera before = camera(frame - 1);
  next.eye_m += next.eye_m - before.eye_m;
  next.target_m += next.target_m - before.target_m;
  return next;
}

/// By how much cells of waving grass lean over more in the next frame. After the last one before a
/// cut it goes on as it came.
class MoreLean {
 public:
  MoreLean(const scene::Scene& scene, const place::Site& site, const meadow::FrameGrass& now)
      : now_(now),
        is_last_(now.frame == scene::take_of(scene, now.frame).last()),
        other_(meadow::frame_grass(scene, site, is_last_ ? now.frame - 1 : now.frame + 1)),
        lattice_(scene) {}

  glm::dvec2 at(const glm::ivec2& cell) const {
    const glm::dvec2 middle_m = lattice_.ground(cell).middle_m;
    const glm::dvec2 more = other_.wind_lean.lean(middle_m) - now_.wind_lean.lean(middle_m);
    return is_last_ ? -more : more;
  }

 private:
  const meadow::FrameGrass& now_;
  bool is_last_;
  meadow::FrameGrass other_;
  meadow::CellLattice lattice_;
};

/// The meadow as it is painted on the ground, and what it is painted by.
class Painted {
 public:
  Painted(const scene::Scene& scene, const place::Site& site, const meadow::FrameGrass& now,
          const AssembledFrame& frame, const PatchLookup& lookup)
      : site_(site),
        growth_(frame.ground->growth()),
        grass_(scene::mean_grass(scene)),
        window_(scene),
        view_(frame.landscape.camera, frame.landscape.width_px, frame.landscape.height_px),
        meadow_(ground::far_meadow(scene, site, now, view_, lookup.far)) {}
  Painted(const Painted&) = delete;
  Painted& operator=(const Painted&) = delete;

  passes::PaintedGrass at(const glm::dvec3& at_m) const {
    if (!meadow_) return {};
    return {site_.mixtures->at(glm::dvec2(at_m)),
            meadow::painted_opacity(grass_, window_, view_, *meadow_, at_m,
                                    double{growth_.sample(at_m.x, at_m.y)})};
  }

 private:
  const place::Site& site_;
  FactorMap growth_;
  scene::Grass grass_;
  place::CellWindow window_;
  place::View view_;
  std::optional<meadow::Meadow> meadow_;
};

}  // namespace

passes::GroundFacts ground_facts(const scene::Scene& scene, const place::Site& site,
                                 const meadow::FrameGrass& now, const AssembledFrame& frame,
                                 const PatchLookup& lookup) {
  const ground::SnowyGround& ground = *frame.ground;
  const auto albedo = std::make_shared<const ColourMap>(ground.albedo());
  const auto painted = std::make_shared<const Painted>(scene, site, now, frame, lookup);
  passes::GroundFacts facts;
  facts.snow_m = [&ground](const glm::dvec2& at_m) { return double{ground.depth_m(at_m)}; };
  facts.white_fraction = [&ground](const glm::dvec2& at_m) {
    return double{ground.white_fraction(at_m)};
  };
  facts.weathering = [&site, day = now.frame](const glm::dvec2& at_m) {
    return site.withering->at(at_m, day);
  };
  facts.wetness = [&ground](const glm::dvec2& at_m) {
    return ground.wetness() * (1.0 - double{ground.white_fraction(at_m)});
  };
  facts.albedo = [albedo](const glm::dvec2& at_m) { return albedo->sample(at_m.x, at_m.y); };
  facts.irradiance = [&frame](const glm::dvec2& at_m) {
    return frame.light.sample(at_m.x, at_m.y);
  };
  facts.painted_grass = [painted](const glm::dvec3& at_m) { return painted->at(at_m); };
  const std::vector<scene::Species> species = scene::species_of(scene);
  facts.species = names_of(species);
  for (const scene::Mixture& mixture : scene::mixtures_of(scene))
    facts.mixtures.push_back(fractions_of(scene, species, mixture));
  for (int patch = 0; patch < scene::patch_count(scene); ++patch)
    facts.mixture_of_patch.push_back(scene::mixture_number(scene, patch));
  facts.next_camera = next_camera(scene, site, now.frame);
  if (place::grass_waves(scene) && scene::take_of(scene, now.frame).count > 1)
    facts.more_lean = [more = std::make_shared<const MoreLean>(scene, site, now)](
                          const glm::ivec2& cell) { return more->at(cell); };
  return facts;
}

}  // namespace wold::film
