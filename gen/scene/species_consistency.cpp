#include "scene/species_consistency.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/species.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

/// Texels are cubes of voxels in memory; taller ones than this many patches exhaust it.
constexpr double max_patches_high = 4.0;
/// Standard deviations at which widths of blades are cut.
constexpr double max_deviations = 2.2;

/// The tables in which a species' keys stand.
struct Tables {
  std::string plant = "grass";
  std::string physiology = "ageing";
  std::string fur = "fur";
};

/// What is judged: a species, its keys' tables, its blades in a patch, and the patch.
struct Judged {
  Species species;
  Tables in;
  int blades = 0;
  double patch_m = 0.0;
};

Rule veins_shrink_less(const Judged& judged) {
  const Physiology& ageing = judged.species.physiology;
  const std::string& table = judged.in.physiology;
  return {{table + ".vein_shrinkage", table + ".mesophyll_shrinkage"},
          ageing.vein_shrinkage < ageing.mesophyll_shrinkage,
          fmt::format("{0}.vein_shrinkage: found {1}, expected less than {2} "
                      "({0}.mesophyll_shrinkage): veins shrink less than the tissue around",
                      table, ageing.vein_shrinkage, ageing.mesophyll_shrinkage)};
}

Rule keel_fits_the_blade(const Judged& judged) {
  const Plant& plant = judged.species.plant;
  const std::string& table = judged.in.plant;
  return {{table + ".keel_depth", table + ".width", judged.in.physiology + ".droop_rule"},
          judged.species.physiology.droop_rule != DroopRule::elastica ||
              plant.keel_depth_m <= 0.5 * plant.width_m,
          fmt::format("{0}.keel_depth: found {1} m, expected at most {2} m, half of {0}.width: a "
                      "blade folded flat is no deeper",
                      table, plant.keel_depth_m, 0.5 * plant.width_m)};
}

Rule hair_droops_by_the_papers_rule(const Judged& judged) {
  const Physiology& ageing = judged.species.physiology;
  return {{judged.in.physiology + ".droop_rule", judged.in.fur + ".clumps"},
          !is_hair(ageing) || ageing.droop_rule == DroopRule::paper,
          fmt::format("{}.droop_rule: found \"{}\", expected \"paper\" for fur ({}.clumps is "
                      "{}): wet hairs are drawn together, not bowed by their weight",
                      judged.in.physiology, word_of(ageing.droop_rule), judged.in.fur,
                      ageing.fur.clumps)};
}

Rule hair_moves_in_closed_form(const Judged& judged) {
  const Physiology& ageing = judged.species.physiology;
  return {
      {judged.in.physiology + ".motion", judged.in.fur + ".clumps"},
      !is_hair(ageing) || ageing.motion == AgeingMotion::closed_form,
      fmt::format("{}.motion: found \"{}\", expected \"closed_form\" for fur ({}.clumps is "
                  "{}): hairs stand up as they dry, Algorithm 1 lets blades fall",
                  judged.in.physiology, word_of(ageing.motion), judged.in.fur, ageing.fur.clumps)};
}

Rule blades_fit_the_patch(const Judged& judged) {
  const Plant& plant = judged.species.plant;
  const std::string& table = judged.in.plant;
  return {
      {table + ".height", "grass.patch", table + ".height_spread"},
      max_standing_m(plant) <= max_patches_high * judged.patch_m,
      fmt::format("{0}.height: found {1} m, with {0}.height_spread up to {2} m, expected at "
                  "most {3} times grass.patch ({4} m)",
                  table, plant.height_m, max_standing_m(plant), max_patches_high, judged.patch_m)};
}

Rule blades_are_narrower_than_the_patch(const Judged& judged) {
  const Plant& plant = judged.species.plant;
  const std::string& table = judged.in.plant;
  const double widest_m = plant.width_m * (1.0 + max_deviations * plant.width_spread);
  return {{table + ".width", "grass.patch", table + ".width_spread"},
          widest_m < judged.patch_m,
          fmt::format("{0}.width: found {1} m, with {0}.width_spread up to {2:.3g} m, expected "
                      "less than grass.patch ({3} m)",
                      table, plant.width_m, widest_m, judged.patch_m)};
}

Rule every_sample_has_a_blade(const Judged& judged) {
  const std::string& table = judged.in.plant;
  return {{table + ".mingle", "grass.blades"},
          judged.species.plant.mingle.size() <= static_cast<std::size_t>(judged.blades),
          fmt::format("{}.mingle: found {} samples, expected at most one for each of the {} "
                      "blades of a patch (grass.blades)",
                      table, judged.species.plant.mingle.size(), judged.blades)};
}

Rule has_a_blade(const Judged& judged) {
  return {{judged.in.plant + ".share", "grass.blades"},
          judged.blades > 0,
          fmt::format("{}.share: found {}, which leaves this species none of the blades of a patch "
                      "(grass.blades), expected one at least",
                      judged.in.plant, judged.species.share)};
}

Rule flowers_stand_on_grass(const Judged& judged) {
  const Physiology& ageing = judged.species.physiology;
  const std::string& table = judged.in.plant;
  return {{table + ".petals", judged.in.fur + ".clumps"},
          judged.species.flower.petals == 0 || !is_hair(ageing),
          fmt::format("{0}.petals: found {1}, expected 0 for fur ({2}.clumps is {3}): hairs do not "
                      "flower",
                      table, judged.species.flower.petals, judged.in.fur, ageing.fur.clumps)};
}

Rule stalks_do_not_move(const Judged& judged) {
  const Physiology& ageing = judged.species.physiology;
  const std::string& table = judged.in.plant;
  return {{table + ".petals", judged.in.physiology + ".motion"},
          judged.species.flower.petals == 0 || ageing.motion == AgeingMotion::closed_form,
          fmt::format("{0}.motion: found \"{1}\", expected \"closed_form\" for a species that "
                      "flowers ({2}.petals is {3}): its stalks stand still, Algorithm 1 lets "
                      "blades fall",
                      judged.in.physiology, word_of(ageing.motion), table,
                      judged.species.flower.petals)};
}

Rule flowers_fit_the_patch(const Judged& judged) {
  const Flower& flower = judged.species.flower;
  const std::string& table = judged.in.plant;
  const double widest_m = std::max({flower.length_m, flower.width_m, flower.disc_m});
  return {{table + ".petals", table + ".petal_length", table + ".petal_width", table + ".disc",
           "grass.patch"},
          flower.petals == 0 || widest_m < 0.5 * judged.patch_m,
          fmt::format("{0}.petals: found petals and a disc of up to {1} m ({0}.petal_length, "
                      "{0}.petal_width, {0}.disc), expected less than half of grass.patch ({2} m)",
                      table, widest_m, judged.patch_m)};
}

/// Of two limits of a habitat.
Rule leaves_room(const std::string& table, const char* low_key, double low, const char* high_key,
                 double high) {
  return {{table + '.' + high_key, table + '.' + low_key},
          low < high,
          fmt::format("{0}.{1}: found {2}, expected more than {3} ({0}.{4})", table, high_key, high,
                      low, low_key)};
}

std::vector<Rule> grows_somewhere(const Judged& judged) {
  const Habitat& habitat = judged.species.habitat;
  const std::string& table = judged.in.plant;
  return {leaves_room(table, "gentlest", habitat.gentlest_deg, "steepest", habitat.steepest_deg),
          leaves_room(table, "lowest", habitat.lowest_m, "highest", habitat.highest_m),
          leaves_room(table, "driest", habitat.driest, "wettest", habitat.wettest),
          leaves_room(table, "shadiest", habitat.shadiest, "sunniest", habitat.sunniest)};
}

/// Each of them doubles the mixtures, and so the patches.
Rule few_have_a_habitat(const Scene& scene) {
  const auto count = std::ranges::count_if(scene.species, has_habitat);
  return {{item_name("species", scene.species.size() - 1), "species[1]"},
          count <= max_with_habitat,
          fmt::format("[[species]]: found {} that do not grow everywhere, expected at most {}: "
                      "each mixture of them has patches of its own",
                      count, max_with_habitat)};
}

/// Blades, leaves and petals of a patch: each is lit by itself.
constexpr int max_lit = 40000;

/// Of a patch on which they all stand.
long leaves_of_shrubs(const std::vector<Judged>& all) {
  long leaves = 0;
  for (const Judged& one : all)
    if (is_shrub(one.species)) leaves += one.blades;
  return leaves;
}

Rule few_petals_are_drawn(const Scene& scene, long leaves) {
  const auto petals = [](const Species& one) { return one.flower.petals; };
  const auto fullest = std::ranges::max_element(scene.species, {}, petals);
  const std::string item =
      item_name("species", static_cast<std::size_t>(fullest - scene.species.begin()));
  const long drawn = max_drawn(scene) - leaves;
  return {{item + ".petals", "grass.blades"},
          petals(*fullest) == 0 || drawn <= max_lit,
          fmt::format("{}.petals: found {}, with which a patch has {} blades and petals "
                      "(grass.blades is {}), expected at most {}: fewer petals or a smaller share",
                      item, petals(*fullest), drawn, scene.grass.blades, max_lit)};
}

Rule few_leaves_are_drawn(const Judged& judged, long leaves) {
  return {{judged.in.plant + ".share", judged.in.plant + ".crown", "grass.blades"},
          !is_shrub(judged.species) || leaves <= max_lit,
          fmt::format("{}.share: found {}, with which the shrubs of a patch have {} blades on "
                      "their twigs (grass.blades times their share), expected at most {}",
                      judged.in.plant, judged.species.share, leaves, max_lit)};
}

std::vector<Judged> judged_species(const Scene& scene) {
  const std::vector<int> blades = blades_of(scene);
  std::vector<Judged> all;
  for (const Species& species : species_of(scene)) {
    const std::size_t item = all.size();
    Judged judged{species, {}, blades[item], scene.grass.patch_m};
    if (!scene.species.empty()) {
      const std::string table = item_name("species", item);
      judged.in = {table, table, table};
    }
    all.push_back(std::move(judged));
  }
  return all;
}

}  // namespace

std::vector<Rule> species_rules(const Scene& scene) {
  std::vector<Rule> rules;
  for (const Judged& judged : judged_species(scene))
    for (Rule& rule :
         std::vector{blades_fit_the_patch(judged), blades_are_narrower_than_the_patch(judged),
                     has_a_blade(judged), every_sample_has_a_blade(judged),
                     veins_shrink_less(judged), keel_fits_the_blade(judged),
                     hair_droops_by_the_papers_rule(judged), hair_moves_in_closed_form(judged)})
      rules.push_back(std::move(rule));
  if (scene.species.empty()) return rules;
  rules.push_back(few_have_a_habitat(scene));
  const std::vector<Judged> all = judged_species(scene);
  const long leaves = leaves_of_shrubs(all);
  rules.push_back(few_petals_are_drawn(scene, leaves));
  for (const Judged& judged : all) {
    for (Rule& rule : grows_somewhere(judged)) rules.push_back(std::move(rule));
    rules.push_back(few_leaves_are_drawn(judged, leaves));
    rules.push_back(flowers_stand_on_grass(judged));
    rules.push_back(flowers_fit_the_patch(judged));
    rules.push_back(stalks_do_not_move(judged));
  }
  return rules;
}

}  // namespace wold::scene
