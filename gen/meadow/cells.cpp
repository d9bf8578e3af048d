#include "meadow/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/noise.h"
#include "core/parallel.h"
#include "meadow/cell_lattice.h"
#include "meadow/cell_texels.h"
#include "meadow/cell_uniform.h"
#include "meadow/far_field.h"
#include "meadow/shrubs.h"
#include "place/ground_grids.h"
#include "place/view.h"
#include "scene/key_frames.h"
#include "scene/species.h"
#include "terrain/horizon.h"
#include "terrain/relief.h"

namespace wold::meadow {
namespace {

/// What cells are dithered in, each in an order of its own.
enum class Dither { key_frame, snow, light };

/// A number in [0, 1) of a cell: those that want at least so much of the way between two states
/// show the second. Each variant has its own part of [0, 1), so that variants pass to the second
/// state one after the other: few states of a variant are seen at once, and each of them is a
/// volume in a renderer's memory.
double threshold(const scene::Scene& scene, const CellChoice& choice, Dither dither) {
  constexpr std::array<const char*, 3> purposes = {"key frame", "snow", "light"};
  const auto which = static_cast<int>(dither);
  const int place = (choice.variant + which) % scene.grass.variants;
  const double within =
      cell_uniform(scene.seed, choice.cell, purposes[static_cast<std::size_t>(which)]);
  return (place + within) / scene.grass.variants;
}

int choose_key_frame(const std::vector<double>& keys, double wanted, double threshold) {
  const auto above = std::upper_bound(keys.begin(), keys.end(), wanted);
  if (above == keys.begin()) return 0;
  const auto below = static_cast<int>(above - keys.begin()) - 1;
  if (above == keys.end()) return below;
  const double fraction = (wanted - *(above - 1)) / (*above - *(above - 1));
  return threshold < fraction ? below + 1 : below;
}

/// The whole number below or above.
int choose_between(double wanted, double threshold) {
  const auto below = static_cast<int>(wanted);
  return threshold < wanted - below ? below + 1 : below;
}

/// Whether a level is fine enough where one metre covers `pixels_per_m`.
bool is_fine_enough(const scene::Grass& grass, int lod, double pixels_per_m) {
  const double voxel_m = grass.patch_m / grass.lods[static_cast<std::size_t>(lod)];
  return voxel_m * pixels_per_m <= grass.pixels_per_voxel;
}

/// The coarsest level that is fine enough, else the finest.
int choose_lod(const scene::Grass& grass, double pixels_per_m) {
  for (int lod = static_cast<int>(grass.lods.size()) - 1; lod > 0; --lod)
    if (is_fine_enough(grass, lod, pixels_per_m)) return lod;
  return 0;
}

bool choose_blades(const scene::Scene& scene, double pixels_per_m) {
  if (scene.render.grass == scene::GrassForm::automatic)
    return !is_fine_enough(scene.grass, 0, pixels_per_m);
  return scene.render.grass != scene::GrassForm::texels;
}

/// How far above the middle of the grass on a cell the highest blades may reach.
double above_middle_m(const scene::Scene& scene) {
  const double mean_m = scene::mean_grass(scene).height_m;
  double max_m = 0.0;
  for (const scene::Species& species : scene::species_of(scene)) {
    const scene::Plant& plant = species.plant;
    const double size = scene::is_shrub(species) ? largest_shrub : 1.0;
    const double higher_m = size * plant.crown_m + 0.5 * (plant.height_m - mean_m);
    const double blade_m = plant.height_m * std::max(1.5, 0.5 + 2.2 * plant.height_spread);
    max_m = std::max(max_m, size * blade_m + higher_m);
  }
  return max_m;
}

}  // namespace

double cell_reach_m(const scene::Scene& scene) {
  // A shrub's middle is anywhere in its cell, whose corners are so far from its own at most.
  constexpr double to_corner = 0.76;
  constexpr double cells_of_shrubs = to_corner + 0.5 * std::numbers::sqrt2 * largest_shrub;
  constexpr double cells_of_grass = 1.75;
  const double cells = std::ranges::any_of(scene::species_of(scene), scene::is_shrub)
                           ? cells_of_shrubs
                           : cells_of_grass;
  return cells * scene.grass.patch_m + above_middle_m(scene);
}

namespace {

/// What the camera sees of the cells.
class Sight {
 public:
  Sight(const scene::Scene& scene, const Heightfield& terrain, const landscape::Camera& camera)
      : grass_(scene::mean_grass(scene)),
        window_(scene),
        terrain_(terrain),
        eye_m_(camera.eye_m),
        view_(camera, scene.render.size_px[0], scene.render.size_px[1]),
        margin_m_(cell_reach_m(scene)) {}

  bool may_see(const glm::dvec3& middle_m) const {
    return view_.may_see(middle_m, margin_m_) && far(middle_m) < 1.0 && !is_behind_a_hill(middle_m);
  }

  /// The fraction of the grass there that is painted on the ground.
  double far(const glm::dvec3& middle_m) const {
    return far_fraction(grass_, window_, view_, middle_m);
  }

  /// Pixels that a metre covers there.
  double pixels(const glm::dvec3& middle_m) const { return view_.pixels(1.0, middle_m); }

 private:
  /// Whether the ground hides all that can stand on the cell.
  bool is_behind_a_hill(const glm::dvec3& middle_m) const {
    return terrain::is_hidden(terrain_, eye_m_, middle_m + glm::dvec3(0.0, 0.0, margin_m_));
  }

  scene::Grass grass_;
  place::CellWindow window_;
  const Heightfield& terrain_;
  glm::dvec3 eye_m_;
  place::View view_;
  double margin_m_;
};

/// How much grass grows on a cell.
struct Grown {
  float max = 0.0F;
  float mean = 0.0F;
};

Grown grown_in(const FactorMap& growth, const CellGround& cell) {
  constexpr int steps = 6;
  Grown grown;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      const glm::dvec2 at_m = cell.place_m(glm::dvec2(i, j) / (1.0 * steps));
      const float here = growth.sample(at_m.x, at_m.y);
      grown.max = std::max(grown.max, here);
      grown.mean += here / ((steps + 1) * (steps + 1));
    }
  return grown;
}

/// What cells show of a frame.
struct Showing {
  double snow;   ///< level of PatchState, not whole
  double light;  ///< FrameGrass's
};

/// All of the choice but where the cell stands.
CellChoice choose_cell(const scene::Scene& scene, const glm::ivec2& cell, const CellTexel& texel,
                       const std::vector<double>& key_frames, double weathering,
                       const Showing& showing, double pixels_per_m) {
  CellChoice choice;
  choice.cell = cell;
  const double jittered = pixels_per_m * (0.9 + 0.2 * cell_uniform(scene.seed, cell, "level"));
  choice.lod = choose_lod(scene.grass, jittered);
  choice.blades = choose_blades(scene, jittered);
  choice.variant = texel.variant;
  choice.turn = choice.blades ? 0 : texel.turn % turns_of_lod(scene, choice.lod);
  choice.key_frame =
      choose_key_frame(key_frames, weathering, threshold(scene, choice, Dither::key_frame));
  choice.snow = choose_between(showing.snow, threshold(scene, choice, Dither::snow));
  choice.light = choose_between(showing.light, threshold(scene, choice, Dither::light));
  return choice;
}

/// What cells ask of a mixture.
struct MixtureFacts {
  double leaning = 1.0;       ///< how far it leans with the wind, of what grass does: shrubs stand
  bool has_shrubs = false;    ///< that stand beside their cell
  std::optional<int> around;  ///< the mixture that stands on the cell, if any does
};

std::vector<MixtureFacts> facts_of_mixtures(const scene::Scene& scene) {
  std::vector<MixtureFacts> facts;
  const std::vector<scene::Mixture> mixtures = scene::mixtures_of(scene);
  for (int number = 0; number < static_cast<int>(mixtures.size()); ++number) {
    const bool has_shrubs = scene::has_placed_shrubs(scene, number);
    const int around = scene::without_shrubs(scene, number);
    facts.push_back({scene::rooted_fraction(scene, mixtures[static_cast<std::size_t>(number)]),
                     has_shrubs,
                     has_shrubs && around == number ? std::nullopt : std::optional(around)});
  }
  return facts;
}

int voxels_of(const scene::Scene& scene, const CellChoice& choice) {
  return scene.grass.lods[static_cast<std::size_t>(choice.lod)];
}

}  // namespace

glm::dmat4 reach_to_neighbours(const WindLean& wind_lean, double patch_m,
                               const landscape::CellPose& pose, double height_m) {
  const glm::dvec2 here_m = landscape::middle_m(pose, patch_m);
  const glm::dvec2& own = pose.lean;
  glm::dvec2 low_m, high_m;  // beyond the cell's sides
  for (int axis = 0; axis < 2; ++axis) {
    glm::dvec2 step_m(0.0);
    step_m[axis] = patch_m;
    step_m.y += pose.shear * step_m.x;
    const double low = wind_lean.lean(here_m - step_m)[axis];
    const double high = wind_lean.lean(here_m + step_m)[axis];
    low_m[axis] = 0.5 * height_m * std::max(0.0, own[axis] - low);
    high_m[axis] = 0.5 * height_m * std::max(0.0, high - own[axis]);
  }
  const glm::dvec2 stretch = 1.0 + (low_m + high_m) / patch_m;
  const glm::dvec2 shift_m = 0.5 * (high_m - low_m);
  const glm::dvec2 east = landscape::east_of(pose.turn);
  const glm::dvec2 north = landscape::left_of(east);
  const glm::dvec2 in_cell = pose.turn % 2 == 0 ? stretch : glm::dvec2(stretch.y, stretch.x);
  const glm::dvec2 origin_m = glm::dvec2(glm::dot(shift_m, east), glm::dot(shift_m, north)) +
                              0.5 * patch_m * (1.0 - in_cell);
  return {{in_cell.x, 0, 0, 0}, {0, in_cell.y, 0, 0}, {0, 0, 1, 0}, {origin_m, 0, 1}};
}

int turns_of_lod(int voxels_per_side) { return voxels_per_side >= 200 ? 1 : 2; }

int turns_of_lod(const scene::Scene& scene, int lod) {
  if (scene::has_hair(scene)) return 1;
  return turns_of_lod(scene.grass.lods[static_cast<std::size_t>(lod)]);
}

namespace {

/// Chooses what stands on each cell of a frame.
class CellChooser {
 public:
  CellChooser(const scene::Scene& scene, const Heightfield& terrain, const FactorMap& growth,
              const place::MixtureField& mixtures, const place::Withering& withering,
              const FrameGrass& now)
      : scene_(scene),
        terrain_(terrain),
        growth_(growth),
        mixtures_(mixtures),
        withering_(withering),
        now_(now),
        window_(scene),
        lattice_(scene),
        grass_(scene::mean_grass(scene)),
        sight_(scene, terrain, place::camera_of_frame(scene, terrain, now.frame)),
        key_frames_(scene::key_frames(scene)),
        mixture_facts_(facts_of_mixtures(scene)),
        showing_{grass::PatchState::level_of(now.snow), now.light} {
    if (place::is_large(scene)) mesh_ = terrain::mesh_heights(terrain, place::window_grid(scene));
  }

  /// Adds what stands on a cell, if anything does that can be seen. Shrubs stand beside their cell,
  /// which has the grass that grows around them.
  void add(const glm::ivec2& cell, const CellTexel& texel, std::vector<CellChoice>& row) const {
    const CellGround ground = lattice_.ground(cell);
    const glm::dvec3 middle_m =
        place::above_ground(terrain_, ground.middle_m, grass_.height_m / 2.0);
    const Grown grown = grown_in(growth_, ground);
    if (grown.max <= 0.0F || !sight_.may_see(middle_m)) return;
    const double weathering = withering_.at(glm::dvec2(middle_m), now_.frame);
    const auto of_size = [&](double size) {
      return choose_cell(scene_, cell, texel, key_frames_, weathering, showing_,
                         sight_.pixels(middle_m) * size);
    };
    const CellChoice choice = of_size(1.0);
    if (choice.blades && cell_uniform(scene_.seed, cell, "grown") >= double{grown.mean}) return;
    const int mixture = mixtures_.at(glm::dvec2(middle_m));
    const MixtureFacts& facts = mixture_facts_[static_cast<std::size_t>(mixture)];
    if (facts.around) row.push_back(on_cell(choice, *facts.around));
    if (!facts.has_shrubs) return;
    const ShrubPlace place = shrub_place(scene_, window_, lattice_, cell);
    const glm::dvec2 shrub_m =
        landscape::middle_m({.cell = cell, .shift_m = place.shift_m}, scene_.grass.patch_m);
    const double grown_there{growth_.sample(shrub_m.x, shrub_m.y)};
    if (cell_uniform(scene_.seed, cell, "shrub grown") >= grown_there) return;
    const CellChoice shrub = of_size(place.size);
    const double standing = shrub.blades ? 1.0 : grown_there * (1.0 - sight_.far(middle_m));
    row.push_back(beside_cell(shrub, mixture, place, standing));
  }

 private:
  /// The choice with the patch of a mixture on its cell.
  CellChoice on_cell(CellChoice choice, int mixture) const {
    choice.variant = scene::patch_number(scene_, mixture, choice.variant);
    landscape::CellPose pose = pose_of(choice, mixture);
    lattice_.place_patch(pose);
    choice.parts = landscape::parts_on_ground(ground(), scene_.grass.patch_m, pose,
                                              voxels_of(scene_, choice), ground_tolerance_m);
    // Half-way up, so that they show as much too little above as too much below: along a line of
    // sight between them either would be a seam.
    choice.reach =
        reach_to_neighbours(now_.wind_lean, scene_.grass.patch_m, pose, 0.5 * grass_.height_m);
    return choice;
  }

  CellChoice beside_cell(CellChoice choice, int mixture, const ShrubPlace& place,
                         double standing) const {
    constexpr double tolerance_m = 5.0 * ground_tolerance_m;  // the grass around hides their feet
    const double patch_m = scene_.grass.patch_m;
    choice.variant = scene::patch_number(scene_, mixture, choice.variant);
    landscape::CellPose pose = pose_of(choice, mixture);
    pose.shift_m = place.shift_m;
    pose.size = place.size;
    choice.parts =
        landscape::parts_on_ground(ground(), patch_m, pose, voxels_of(scene_, choice), tolerance_m);
    choice.beside_cell = {
        landscape::fit_to_ground(ground(), patch_m, pose, landscape::Part{}).world_from_cell,
        standing};
    return choice;
  }

  landscape::CellPose pose_of(const CellChoice& choice, int mixture) const {
    const glm::dvec2 lean = now_.wind_lean.lean(lattice_.ground(choice.cell).middle_m);
    return {choice.cell, choice.turn,
            mixture_facts_[static_cast<std::size_t>(mixture)].leaning * lean};
  }

  /// As it is drawn.
  const Heightfield& ground() const { return mesh_ ? *mesh_ : terrain_; }

  const scene::Scene& scene_;
  const Heightfield& terrain_;
  const FactorMap& growth_;
  const place::MixtureField& mixtures_;
  const place::Withering& withering_;
  const FrameGrass& now_;
  place::CellWindow window_;
  CellLattice lattice_;
  scene::Grass grass_;  ///< in the mean of all species
  Sight sight_;
  std::optional<Heightfield> mesh_;  ///< of a large terrain's ground, as it is drawn
  std::vector<double> key_frames_;
  std::vector<MixtureFacts> mixture_facts_;
  Showing showing_;
};

}  // namespace

Square square_of_cells(const scene::Scene& scene, std::span<const CellChoice> cells) {
  glm::ivec2 low = cells.front().cell, high = low;
  for (const CellChoice& choice : cells) {
    low = glm::min(low, choice.cell);
    high = glm::max(high, choice.cell);
  }
  return square_of_cells(scene, low, high);
}

Square square_of_cells(const scene::Scene& scene, const glm::ivec2& low, const glm::ivec2& high) {
  const glm::ivec2 count = high - low + 1;
  const double reach_m = cell_reach_m(scene) + CellLattice::max_shift * scene.grass.patch_m;
  return {glm::dvec2(low) * scene.grass.patch_m - reach_m,
          std::max(count.x, count.y) * scene.grass.patch_m + 2.0 * reach_m};
}

std::vector<CellChoice> choose_cells(const scene::Scene& scene, const Heightfield& terrain,
                                     const FactorMap& growth, const place::MixtureField& mixtures,
                                     const place::Withering& withering, const FrameGrass& now) {
  const place::CellWindow window(scene);
  const std::vector<CellTexel> texels = choose_texels(scene, window);
  const CellChooser chooser(scene, terrain, growth, mixtures, withering, now);
  const auto side = static_cast<std::size_t>(window.per_side);
  std::vector<std::vector<CellChoice>> rows(side);
  parallel_for(side, [&](std::size_t j) {
    for (std::size_t i = 0; i < side; ++i)
      chooser.add(window.first + glm::ivec2(i, j), texels[j * side + i], rows[j]);
  });
  std::vector<CellChoice> choices;
  for (const std::vector<CellChoice>& row : rows)
    choices.insert(choices.end(), row.begin(), row.end());
  return choices;
}

}  // namespace wold::meadow
