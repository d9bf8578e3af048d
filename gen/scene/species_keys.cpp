#include <utility>

#include "scene/binding.h"
#include "scene/key_builders.h"
#include "scene/keys.h"

/// A key's field, for reading and writing alike.
#define FIELD(path) ([](auto& scene) -> auto& { return scene.path; })
/// The field of a part of the scene, which `of` finds in it.
#define PART(path) ([of](auto& scene) -> auto& { return of(scene).path; })

/// The keys of plants: those of [grass], [ageing] and [fur], which describe the only species, and
/// of the tables [[species]], which have them all.
namespace wold::scene {
namespace {

std::vector<Key> joined(std::initializer_list<std::vector<Key>> lists) {
  std::vector<Key> all;
  for (const std::vector<Key>& keys : lists) all.insert(all.end(), keys.begin(), keys.end());
  return all;
}

/// Of the Plant that `of` finds in a scene, as keys of `table`.
template <class Part>
std::vector<Key> plant_keys(const std::string& table, Part of) {
  return {
      bound(
          rates(table + ".mingle", {"steady", "early", "late", "sudden", "slow", "evergreen"}, 32,
                "Samples that are mingled, each by its ageing rate, its own weathering degree over "
                "the meadow's; the blades are shared out evenly, an empty list is one steady "
                "sample."),
          PART(mingle)),
      bound(
          number(table + ".crown", "m", {0, 3},
                 "Height of a shrub's crown, on whose twigs the blades stand, turned outwards; 0: "
                 "they stand in the ground."),
          PART(crown_m)),
      bound(number(table + ".height", "m", {0.01, 3}, "Mean length of a blade."), PART(height_m)),
      bound(number(table + ".height_spread", "", {0, 1},
                   "Standard deviation of the length over its mean."),
            PART(height_spread)),
      bound(number(table + ".width", "m", {0.00005, 0.05}, "Mean width of a blade at its foot."),
            PART(width_m)),
      bound(number(table + ".width_spread", "", {0, 1},
                   "Standard deviation of the width over its mean."),
            PART(width_spread)),
      bound(number(table + ".lean", "deg", {0, 80}, "Mean angle of a blade from the vertical."),
            PART(lean_deg)),
      bound(number(table + ".lean_spread", "deg", {0, 45}, "Standard deviation of that angle."),
            PART(lean_spread_deg)),
      bound(number(table + ".bend", "rad/sqrt(m)", {0, 20},
                   "Bending of fresh blades under their own weight, by the paper's rule."),
            PART(bend)),
      bound(number(table + ".keel_depth", "m", {0.0001, 0.05},
                   "Depth of the fold of a blade of mean length, from its edges to its keel, for "
                   "the elastica: the deeper the stiffer; flat blades have their thickness."),
            PART(keel_depth_m)),
      bound(number(table + ".specular", "", {0, 1},
                   "Strength of the blades' highlight (Kajiya and Kay's ms)."),
            PART(specular)),
  };
}

/// Of the Physiology that `of` finds in a scene, as keys of `table`.
template <class Part>
std::vector<Key> physiology_keys(const std::string& table, Part of) {
  return {
      bound(curve(table + ".water", {"standard", "ample", "cold"},
                  "Relative water content of the leaves over the weathering degree."),
            PART(water)),
      bound(curve(table + ".chlorophyll", {"standard", "drought", "cold"},
                  "Relative chlorophyll content over the weathering degree."),
            PART(chlorophyll)),
      bound(word(table + ".colour",
                 "How pigments become colour: the PROSPECT leaf model, the paper's functions, or "
                 "those of hair, dark when wet."),
            PART(colour)),
      bound(number(table + ".vein_shrinkage", "", {0, 1},
                   "Share of the veins' volume that is lost with all water; below "
                   "ageing.mesophyll_shrinkage."),
            PART(vein_shrinkage)),
      bound(number(table + ".mesophyll_shrinkage", "", {0, 1},
                   "Share of the soft tissue's volume that is lost with all water."),
            PART(mesophyll_shrinkage)),
      bound(number(table + ".stiffening", "", {0, 100},
                   "How many times stiffer a dry blade is, less one."),
            PART(stiffening)),
      bound(word(table + ".droop_rule",
                 "How blades bow: about their roots by the paper's rule, or as elastic blades "
                 "under their own weight."),
            PART(droop_rule)),
      bound(word(table + ".motion",
                 "How blades get there: by the rule's closed form, or point by point through the "
                 "weathering degrees (Algorithm 1 of the paper)."),
            PART(motion)),
      bound(number(table + ".merge_distance", "voxels", {0, 100},
                   "Points of a blade that are nearer to each other than this become one; 0 merges "
                   "none."),
            PART(merge_distance_voxels)),
      bound(number(table + ".droop", "rad/sqrt(m)", {0, 50},
                   "Bending towards the ground with all water lost, by the paper's rule."),
            PART(droop)),
      bound(number(table + ".turgor_support", "", {0, 0.99},
                   "Share of a fresh blade's stiffness that goes when it wilts, for the elastica."),
            PART(turgor_support)),
      bound(number(table + ".droop_spread", "", {0, 1},
                   "Standard deviation of the droop from blade to blade over its mean."),
            PART(droop_spread)),
      bound(number(table + ".onset_spread", "", {0, 0.5},
                   "Standard deviation of the weathering degree from blade to blade."),
            PART(onset_spread)),
      bound(number(table + ".fresh_spread", "", {0, 0.5},
                   "Mean weathering degree that single blades have in a fresh meadow."),
            PART(fresh_spread)),
      bound(number(table + ".litter", "", {0, 1},
                   "Share of dead blades of the year before in a fresh meadow."),
            PART(litter)),
      bound(number(table + ".chlorophyll_content", "ug/cm2", {0, 120},
                   "Chlorophyll of the fresh leaf."),
            PART(chlorophyll_ug_cm2)),
      bound(number(table + ".carotenoid_content", "ug/cm2", {0, 30},
                   "Carotenoids of the fresh leaf."),
            PART(carotenoid_ug_cm2)),
      bound(
          number(
              table + ".brown_pigment", "", {0, 2},
              "Brown pigment of a dead leaf, PROSPECT's arbitrary unit: 0.25 pale straw, 1 brown."),
          PART(brown_pigment)),
  };
}

/// Of the Fur that `of` finds in a scene, as keys of `table`.
template <class Part>
std::vector<Key> hair_keys(const std::string& table, Part of) {
  return {
      bound(integer(table + ".clumps", "", {0, 10000},
                    "Clumps that the wet hairs of a patch stick together in; the hairs are "
                    "grass.blades, 0 clumps are grass."),
            PART(clumps)),
      bound(number(table + ".lying", "", {0, 0.9},
                   "How far the tips of wet clumps are combed away from their roots, in lengths of "
                   "a hair."),
            PART(lying)),
      bound(number(table + ".comb", "deg", {0, 360}, "Where to, clockwise from north."),
            PART(comb_deg)),
      bound(number(table + ".eumelanin", "um", {0, 1000},
                   "Black pigment across a hair, with ageing.colour \"melanin\": 1 pale, 10 brown, "
                   "50 black."),
            PART(eumelanin_um)),
      bound(number(table + ".pheomelanin", "um", {0, 1000},
                   "Red pigment across a hair: 3 blond, 25 fox."),
            PART(pheomelanin_um)),
  };
}

/// Of the Habitat that `of` finds in a scene, as keys of `table`.
template <class Part>
std::vector<Key> habitat_keys(const std::string& table, Part of) {
  return {
      bound(number(table + ".cover", "", {0, 1},
                   "Share of the ground within the limits below on which this species stands."),
            PART(cover)),
      bound(number(table + ".feature", "m", {0.1, 10000},
                   "Size of the patches in which it stands where it does not stand everywhere: at "
                   "its borders, and with a cover below 1."),
            PART(feature_m)),
      bound(number(table + ".gentlest", "deg", {0, 90}, "Gentlest slope on which it grows."),
            PART(gentlest_deg)),
      bound(number(table + ".steepest", "deg", {0, 90}, "Steepest slope on which it grows."),
            PART(steepest_deg)),
      bound(number(table + ".lowest", "m", {-10000, 10000},
                   "Lowest ground on which it grows, over the terrain's zero."),
            PART(lowest_m)),
      bound(number(table + ".highest", "m", {-10000, 10000},
                   "Highest ground on which it grows, over the terrain's zero."),
            PART(highest_m)),
      bound(number(table + ".driest", "", {0, 1},
                   "Driest ground on which it grows, as the share of the terrain that is drier: "
                   "0.9 leaves the tenth that lies deepest below its surroundings."),
            PART(driest)),
      bound(number(table + ".wettest", "", {0, 1},
                   "Wettest ground on which it grows, as the share of the terrain that is drier: "
                   "0.3 leaves the three tenths that rise highest above their surroundings."),
            PART(wettest)),
      bound(number(table + ".shadiest", "", {0, 2},
                   "Shadiest slope on which it grows: noon's sun at the equinox over that on level "
                   "ground."),
            PART(shadiest)),
      bound(number(table + ".sunniest", "", {0, 2},
                   "Sunniest slope on which it grows: noon's sun at the equinox over that on level "
                   "ground."),
            PART(sunniest)),
      bound(plain(Kind::file, table + ".mask", "", {0, 0},
                  "Picture over the terrain's square, north at the top: this species does not grow "
                  "where it is black. Relative paths start at the scene file."),
            PART(mask)),
  };
}

/// Of the Flower that `of` finds in a scene, as keys of `table`.
template <class Part>
std::vector<Key> flower_keys(const std::string& table, Part of) {
  return {
      bound(integer(table + ".petals", "", {0, 60},
                    "Petals of the flower on the tip of each blade, which is its stiff stalk then; "
                    "0: it does not flower."),
            PART(petals)),
      bound(number(table + ".petal_length", "m", {0.001, 0.1}, "Length of a petal."),
            PART(length_m)),
      bound(
          number(table + ".petal_width", "m", {0.0002, 0.1}, "Width of a petal at its outer end."),
          PART(width_m)),
      bound(number(table + ".petal_opening", "deg", {0, 90},
                   "Angle between petals and stalk: 0 is a closed flower, 90 a flat one."),
            PART(opening_deg)),
      bound(word(table + ".petal_colour", "What pigments the petals have."), PART(colour)),
      bound(number(table + ".disc", "m", {0, 0.1},
                   "Width of the yellow middle, as daisies have it; 0: none."),
            PART(disc_m)),
      bound(number(table + ".petals_fade", "", {0, 1},
                   "Weathering degree of a flower at which its petals begin to wither."),
            PART(fades)),
  };
}

std::vector<Key> patch_keys() {
  return {
      bound(number("grass.patch", "m", {0.05, 20}, "Side of the patch that repeats."),
            FIELD(grass.patch_m)),
      bound(integer("grass.blades", "", {1, 20000}, "Blades in a patch."), FIELD(grass.blades)),
  };
}

std::vector<Key> texel_keys() {
  return {
      bound(number("grass.specular_exponent", "", {1, 1000},
                   "Sharpness of the highlight (Kajiya and Kay's exponent p)."),
            FIELD(grass.specular_exponent)),
      bound(integer("grass.variants", "", {1, 64}, "Different patches laid side by side."),
            FIELD(grass.variants)),
      bound(only(list(Kind::integers, "grass.levels", "voxels", {30, 254},
                      {.min_items = 1, .max_items = 4, .order = Order::decreasing},
                      "Levels of detail: voxels along a side of the patch, finest first."),
                 {254, 126, 62, 30}),
            FIELD(grass.lods)),
      bound(
          number(
              "grass.points_per_voxel_face", "", {0.1, 1000},
              "Points drawn per unit of a voxel's optical depth: the paper's best is 6; here each "
              "point spreads over more voxels, and 2.5 do."),
          FIELD(grass.points_per_voxel_face)),
      bound(plain(Kind::file, "grass.from_texel", "", {0, 0},
                  "Volume (.vdb) that the points are sampled from instead of scattered blades: a "
                  "texel of Wold's, or any fog volume \"density\", fitted to the patch. Relative "
                  "paths start at the scene file."),
            FIELD(grass.from_texel)),
      bound(
          list(Kind::numbers, "grass.key_frames", "", {0, 1},
               {.min_items = 0, .max_items = 64, .order = Order::increasing, .spans_range = true},
               "Weathering degrees for which patches are made; for one in between, each cell "
               "takes one of its two neighbours by chance. An empty list is 12 equal steps, or up "
               "to 48 for a film whose frames are nearer to each other."),
          FIELD(grass.key_frames)),
      bound(number("grass.pixels_per_voxel", "", {0.1, 16},
                   "A level is fine enough when its voxel covers at most this many pixels."),
            FIELD(grass.pixels_per_voxel)),
      bound(number("grass.far_field_below_pixels", "px", {0, 100},
                   "Grass that looks lower than this is painted on the ground, in its own colour."),
            FIELD(grass.far_field_below_pixels)),
      bound(number("grass.unevenness", "", {0, 1},
                   "How far the height of the grass differs from place to place on terrains wider "
                   "than 120 m, as a share of it: tussocks and hollows up to 6 m wide, which light "
                   "shows."),
            FIELD(grass.unevenness)),
  };
}

std::vector<Key> variation_keys() {
  return {
      bound(number("ageing.age_spread", "", {0, 0.5},
                   "How far the weathering degree differs from place to place."),
            FIELD(ageing.age_spread)),
      bound(number("ageing.age_spread_feature", "m", {0.1, 1000},
                   "Size of such places; terrains wider than 120 m have them of all sizes."),
            FIELD(ageing.age_spread_feature_m)),
      bound(number("ageing.pigment_spread", "", {0, 0.5},
                   "How far chlorophyll and brown pigment differ from place to place, as a share, "
                   "with ageing.colour \"prospect\"."),
            FIELD(ageing.pigment_spread)),
      bound(number("ageing.pigment_spread_feature", "m", {0.1, 1000},
                   "Size of the largest such places; others are down to an eighth of it."),
            FIELD(ageing.pigment_spread_feature_m)),
      bound(list(Kind::numbers, "ageing.frames", "", {0, 1},
                 {.min_items = 1, .max_items = max_film_frames},
                 "Weathering degree of each frame: 0 is fresh, 1 fully withered."),
            FIELD(ageing.frames)),
  };
}

}  // namespace

std::vector<Key> grass_keys() {
  return joined({patch_keys(), plant_keys("grass", FIELD(grass)), texel_keys()});
}

std::vector<Key> ageing_keys() {
  return joined({physiology_keys("ageing", FIELD(ageing)), variation_keys()});
}

std::vector<Key> fur_keys() { return hair_keys("fur", FIELD(ageing.fur)); }

std::vector<Key> species_keys(std::size_t item) {
  const auto of = [item](auto& scene) -> auto& { return scene.species[item]; };
  return joined({
      {bound(plain(Kind::name, "species.name", "", {1, 64}, "Names the species in messages."),
             PART(name)),
       bound(
           number("species.share", "", {0.0001, 1000},
                  "Blades of this species in a patch, relative to the shares of the other species "
                  "that stand in the ground there: all these together are grass.blades. Of a shrub "
                  "its leaves, over the grass, as so many times grass.blades."),
           PART(share))},
      habitat_keys("species", PART(habitat)),
      plant_keys("species", PART(plant)),
      physiology_keys("species", PART(physiology)),
      hair_keys("species", PART(physiology.fur)),
      flower_keys("species", PART(flower)),
  });
}

}  // namespace wold::scene
