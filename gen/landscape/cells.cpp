#include "landscape/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/noise.h"
#include "core/random.h"
#include "landscape/view.h"

namespace wold::landscape {
namespace {

/// A number in [0, 1) of a cell, for a purpose.
double cell_uniform(const scene::Scene& scene, const glm::ivec2& cell, const char* purpose) {
  const auto index =
      (static_cast<std::uint64_t>(cell.y) << 32) | static_cast<std::uint32_t>(cell.x);
  return random_uniform({scene.seed, key_of("cell"), index, key_of(purpose)});
}

struct Texel {
  int variant = 0;
  int turn = 0;
};

/// How much two neighbours look alike: the same variant shows even when it is turned, and levels
/// that use fewer turns undo the difference.
int likeness(const Texel& a, const Texel& b) {
  if (a.variant != b.variant) return 0;
  return a.turn == b.turn ? 3 : 1;
}

/// One of the texels that look least like the neighbours; `uniform` in [0, 1) chooses.
Texel unlike(const std::vector<Texel>& neighbours, int variants, double uniform) {
  std::vector<Texel> best;
  int least = 1000;
  for (int k = 0; k < variants * 4; ++k) {
    const Texel candidate{k / 4, k % 4};
    int sum = 0;
    for (const Texel& neighbour : neighbours) sum += likeness(candidate, neighbour);
    if (sum < least) best.clear();
    least = std::min(least, sum);
    if (sum == least) best.push_back(candidate);
  }
  return best[static_cast<std::size_t>(uniform * static_cast<double>(best.size()))];
}

/// Variant and turn of every cell, row by row from the south-west corner: each looks at its left
/// and lower neighbours.
std::vector<Texel> choose_texels(const scene::Scene& scene, int per_side) {
  std::vector<Texel> texels;
  for (int j = 0; j < per_side; ++j)
    for (int i = 0; i < per_side; ++i) {
      std::vector<Texel> neighbours;
      if (i > 0) neighbours.push_back(texels.back());
      if (j > 0) neighbours.push_back(texels[texels.size() - static_cast<std::size_t>(per_side)]);
      texels.push_back(
          unlike(neighbours, scene.grass.variants, cell_uniform(scene, {i, j}, "texel")));
    }
  return texels;
}

glm::dvec2 centre_m(const glm::ivec2& cell, double patch_m) {
  return (glm::dvec2(cell) + 0.5) * patch_m;
}

int choose_key_frame(const scene::Scene& scene, const glm::ivec2& cell, int frame) {
  const std::vector<double>& keys = scene.grass.key_frames;
  const double wanted = local_weathering(scene, centre_m(cell, scene.grass.patch_m), frame);
  const auto above = std::upper_bound(keys.begin(), keys.end(), wanted);
  if (above == keys.begin()) return 0;
  const auto below = static_cast<int>(above - keys.begin()) - 1;
  if (above == keys.end()) return below;
  const double share = (wanted - *(above - 1)) / (*above - *(above - 1));
  return cell_uniform(scene, cell, "key frame") < share ? below + 1 : below;
}

/// Whether a level is fine enough where one metre covers `pixels_per_m`.
bool is_fine_enough(const scene::Grass& grass, int level, double pixels_per_m) {
  const double voxel_m = grass.patch_m / grass.levels[static_cast<std::size_t>(level)];
  return voxel_m * pixels_per_m <= grass.pixels_per_voxel;
}

/// The coarsest level that is fine enough, else the finest.
int choose_level(const scene::Grass& grass, double pixels_per_m) {
  for (int level = static_cast<int>(grass.levels.size()) - 1; level > 0; --level)
    if (is_fine_enough(grass, level, pixels_per_m)) return level;
  return 0;
}

bool choose_blades(const scene::Scene& scene, double pixels_per_m) {
  if (scene.render.grass == "auto") return !is_fine_enough(scene.grass, 0, pixels_per_m);
  return scene.render.grass != "texels";
}

void check_frame(const scene::Scene& scene, int frame) {
  const std::size_t frames = scene.ageing.frames.size();
  if (frame < 1 || static_cast<std::size_t>(frame) > frames)
    throw InputError(fmt::format("frame {} does not exist: the scene has {}", frame, frames));
}

}  // namespace

int cells_per_side(const scene::Scene& scene) {
  return static_cast<int>(std::floor(scene.terrain.size_m / scene.grass.patch_m + 1e-9));
}

glm::dmat4 world_from_cell(const Heightfield& terrain, double patch_m, const glm::ivec2& cell,
                           int turn) {
  const glm::dvec2 low = glm::dvec2(cell) * patch_m;
  const glm::dvec2 high = low + patch_m;
  const double z00 = terrain.sample(low.x, low.y);
  const double z10 = terrain.sample(high.x, low.y);
  const double z01 = terrain.sample(low.x, high.y);
  const double z11 = terrain.sample(high.x, high.y);
  const glm::dvec2 rise(((z10 + z11) - (z00 + z01)) / (2.0 * patch_m),
                        ((z01 + z11) - (z00 + z10)) / (2.0 * patch_m));
  constexpr int cosines[] = {1, 0, -1, 0};
  const double c = cosines[turn & 3];
  const double s = cosines[(turn + 3) & 3];
  const glm::dvec2 east(c, s);  // where the turned cell's axes point
  const glm::dvec2 north(-s, c);
  const glm::dvec2 centre = (low + high) / 2.0;
  const glm::dvec2 origin = centre - (east + north) * (patch_m / 2.0);
  const double z = (z00 + z10 + z01 + z11) / 4.0 + glm::dot(rise, origin - centre);
  return {glm::dvec4(east, glm::dot(rise, east), 0), glm::dvec4(north, glm::dot(rise, north), 0),
          glm::dvec4(0, 0, 1, 0), glm::dvec4(origin, z, 1)};
}

int turns_of_level(int voxels_per_side) {
  if (voxels_per_side >= 200) return 1;
  return voxels_per_side >= 100 ? 2 : 4;
}

double local_weathering(const scene::Scene& scene, const glm::dvec2& at_m, int frame) {
  const double degree = scene.ageing.frames[static_cast<std::size_t>(frame - 1)];
  const double fade = 4.0 * degree * (1.0 - degree);
  const Fbm field{random_bits({scene.seed, key_of("weathering"), 0, key_of("field")}), 2, 1.0};
  const double noise =
      std::clamp(0.6 * fbm(at_m / scene.ageing.variation_feature_m, field), -1.0, 1.0);
  return std::clamp(degree + scene.ageing.variation * fade * noise, 0.0, 1.0);
}

std::vector<CellChoice> choose_cells(const scene::Scene& scene, const Heightfield& terrain,
                                     int frame) {
  check_frame(scene, frame);
  const scene::Grass& grass = scene.grass;
  const int per_side = cells_per_side(scene);
  const std::vector<Texel> texels = choose_texels(scene, per_side);
  const View view(resolved_camera(scene.camera, terrain), scene.render.size_px[0],
                  scene.render.size_px[1]);
  const double margin_m = 1.75 * grass.patch_m +  // half a cell and one more
                          grass.height_m * std::max(1.5, 0.5 + 2.2 * grass.height_spread);
  std::vector<CellChoice> choices;
  for (std::size_t k = 0; k < texels.size(); ++k) {
    CellChoice choice;
    choice.cell = {static_cast<int>(k) % per_side, static_cast<int>(k) / per_side};
    const glm::dvec2 at_m = centre_m(choice.cell, grass.patch_m);
    const glm::dvec3 middle_m(at_m, terrain.sample(at_m.x, at_m.y) + grass.height_m / 2.0);
    if (!view.may_see(middle_m, margin_m)) continue;
    const double jitter = 0.9 + 0.2 * cell_uniform(scene, choice.cell, "level");
    const double pixels_per_m = view.pixels(1.0, middle_m) * jitter;
    choice.level = choose_level(grass, pixels_per_m);
    choice.blades = choose_blades(scene, pixels_per_m);
    choice.variant = texels[k].variant;
    const int side = grass.levels[static_cast<std::size_t>(choice.level)];
    const bool turns = !choice.blades && scene.ageing.fur.clumps == 0;  // a coat has one nap
    choice.turn = turns ? texels[k].turn % turns_of_level(side) : 0;
    choice.key_frame = choose_key_frame(scene, choice.cell, frame);
    choice.world_from_cell = world_from_cell(terrain, grass.patch_m, choice.cell, choice.turn);
    choices.push_back(choice);
  }
  return choices;
}

}  // namespace wold::landscape
