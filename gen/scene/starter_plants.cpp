#include "scene/starter_plants.h"

#include <utility>

#include "scene/species.h"

namespace wold::scene {
namespace {

/// The scene's grass under another name; `share` is relative to that of the grass itself, 1.
Species grass_of(const Scene& scene, const char* name, double share) {
  Species grass = species_of(scene).front();
  grass.name = name;
  grass.share = share;
  return grass;
}

const KeyNames& keys_of_plants() {
  static const KeyNames names = {"species.name",
                                 "species.share",
                                 "species.cover",
                                 "species.feature",
                                 "species.steepest",
                                 "species.driest",
                                 "species.crown",
                                 "species.height",
                                 "species.height_spread",
                                 "species.width",
                                 "species.lean",
                                 "species.lean_spread",
                                 "species.bend",
                                 "species.mingle",
                                 "species.droop",
                                 "species.litter",
                                 "species.fresh_spread",
                                 "species.chlorophyll_content",
                                 "species.carotenoid_content",
                                 "species.brown_pigment",
                                 "species.petals",
                                 "species.petal_length",
                                 "species.petal_width",
                                 "species.petal_opening",
                                 "species.petal_colour"};
  return names;
}

}  // namespace

Species bushes(const Scene& scene) {
  Species bushes = grass_of(scene, "bushes", 20.0);
  bushes.habitat.cover = 0.12;
  bushes.habitat.feature_m = 2.3;
  bushes.habitat.steepest_deg = 45.0;
  Plant& plant = bushes.plant;
  plant.crown_m = 0.45;
  plant.height_m = 0.02;
  plant.height_spread = 0.35;
  plant.width_m = 0.007;
  plant.lean_deg = 40.0;
  plant.lean_spread_deg = 15.0;
  plant.bend = 0.4;
  // Bushes that stay green in every leaf look painted among straw.
  plant.mingle = {{"evergreen", {}}, {"evergreen", {}}, {"evergreen", {}}, {"late", {}}};
  Physiology& physiology = bushes.physiology;
  physiology.droop = 0.4;
  physiology.litter = 0.2;
  physiology.fresh_spread = 0.2;
  physiology.chlorophyll_ug_cm2 = 45.0;
  physiology.carotenoid_ug_cm2 = 11.0;
  return bushes;
}

Species pale_grass(const Scene& scene) {
  Species grass = grass_of(scene, "pale_grass", 1.0);
  grass.habitat.cover = 0.45;
  grass.habitat.feature_m = 30.0;
  grass.plant.height_m = 0.2;
  grass.plant.width_m = 0.003;
  grass.plant.lean_deg = 22.0;
  grass.physiology.chlorophyll_ug_cm2 = 13.0;
  grass.physiology.brown_pigment = 0.35;
  grass.physiology.fresh_spread = 0.35;
  grass.physiology.litter = 0.8;
  return grass;
}

Species lush_grass(const Scene& scene) {
  Species grass = grass_of(scene, "lush_grass", 1.0);
  grass.habitat.cover = 0.25;
  grass.habitat.feature_m = 8.0;
  grass.habitat.driest = 0.4;
  grass.plant.height_m = 0.42;
  grass.plant.width_m = 0.008;
  grass.plant.lean_deg = 20.0;
  grass.physiology.chlorophyll_ug_cm2 = 33.0;
  grass.physiology.fresh_spread = 0.28;
  grass.physiology.litter = 0.6;
  return grass;
}

Species hawkbits(const Scene& scene) {
  Species hawkbits = grass_of(scene, "hawkbit", 0.005);
  Plant& plant = hawkbits.plant;
  plant.height_m = 0.27;
  plant.height_spread = 0.15;
  plant.width_m = 0.0018;
  plant.lean_deg = 10.0;
  Flower& flower = hawkbits.flower;
  flower.petals = 18;
  flower.length_m = 0.014;
  flower.width_m = 0.004;
  flower.opening_deg = 72.0;
  flower.colour = PetalColour::yellow;
  return hawkbits;
}

void let_grow(Starter& starter, std::vector<Species> plants) {
  Scene& scene = starter.scene;
  scene.species = {species_of(scene).front()};
  for (Species& plant : plants) scene.species.push_back(std::move(plant));
  scene.grass.variants = 2;  // of each way in which plants stand together
  starter.keys = joined(starter.keys, keys_of_plants());
  starter.keys.emplace_back("grass.variants");
}

}  // namespace wold::scene
