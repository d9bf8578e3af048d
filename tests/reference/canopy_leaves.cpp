// Writes what canopy.py traces paths through:
//
//     canopy_leaves FOLDER
//
//     FOLDER/w0.300_v2.ply ...        the blades of a variant of the meadow's patch, as leaves,
//     with
//                                     reflectance and transmittance (mitsuba/leaf_files.h)
//     FOLDER/w0.300_v2_mirrored.exr   fraction of light that each tube's gloss reflects
//     FOLDER/sky_20.exr               the sky at a height of the sun, degrees (Daylight's unit)
//     FOLDER/canopy.json              the rest: {"patch_m", "variants", "weathering", "views_deg",
//                                     "ground_albedo", "specular_exponent",
//                                     "suns": [{"elevation_deg", "irradiance"}]}
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "canopy_scene.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "grass/geometry/blade_tubes.h"
#include "grass/optics/shading.h"
#include "grass/texel/blade_patch.h"
#include "light/daylight.h"
#include "mitsuba/leaf_files.h"

namespace wold {
namespace {

namespace fs = std::filesystem;

landscape::BladeMesh leaves(const grass::BladePatch& patch, const grass::MeadowModel& model,
                            const grass::Lighting& lighting, std::string name) {
  auto tubes =
      std::make_shared<Tubes>(grass::blade_tubes(patch, model, lighting, {}, patch.patch_m));
  grass::add_leaf_shades(patch, model, *tubes);
  return {std::move(name), tubes};
}

/// As `mirrored` of source_radiance(), a row a blade, as wide as the leaves' pictures.
void write_gloss(const grass::BladePatch& patch, const grass::MeadowModel& model,
                 const scene::Scene& scene, const Tubes& tubes, const fs::path& path) {
  Image mirrored(tubes.rings, static_cast<int>(patch.blades.size()), 1);
  const float lobe = grass::highlight_albedo(static_cast<float>(scene.grass.specular_exponent));
  for (std::size_t i = 0; i < mirrored.values.size(); ++i) {
    const std::size_t blade = i / static_cast<std::size_t>(tubes.rings);
    mirrored.values[i] = lobe * model.of(patch.blades[blade]).specular(patch.ages[blade]);
  }
  write_image(path, mirrored, PixelFormat::float32);
}

void write_canopy(const fs::path& folder) {
  const scene::Scene scene = test::canopy_scene(test::canopy_suns_deg.front());
  const grass::MeadowModel model(scene);
  const grass::Lighting any =
      grass::make_lighting(light::Daylight(scene.sun, scene.sky), {0.0, 0.0, 1.0}, glm::vec3(0.0F));
  for (int variant = 0; variant < scene.grass.variants; ++variant) {
    const grass::WitheringPatch patch(scene, model, variant);
    for (const double weathering : test::canopy_weathering_degrees) {
      const std::string name = fmt::format("w{:.3f}_v{}", weathering, variant);
      const grass::BladePatch withered = patch.at(weathering);
      const landscape::BladeMesh mesh = leaves(withered, model, any, name);
      mitsuba::write_leaves(mesh, folder);
      write_gloss(withered, model, scene, *mesh.tubes, folder / (name + "_mirrored.exr"));
    }
  }
  nlohmann::json canopy{{"patch_m", scene.grass.patch_m},
                        {"variants", scene.grass.variants},
                        {"weathering", test::canopy_weathering_degrees},
                        {"views_deg", test::canopy_views_deg},
                        {"ground_albedo", scene.terrain.ground_albedo},
                        {"specular_exponent", scene.grass.specular_exponent}};
  for (const double sun_deg : test::canopy_suns_deg) {
    const scene::Scene lit = test::canopy_scene(sun_deg);
    const light::Daylight day(lit.sun, lit.sky);
    const glm::vec3 sun = day.sun_irradiance();
    canopy["suns"].push_back({{"elevation_deg", sun_deg}, {"irradiance", {sun.r, sun.g, sun.b}}});
    write_image(folder / fmt::format("sky_{:.0f}.exr", sun_deg), day.sunless_sky_image(512),
                PixelFormat::float32);
  }
  write_file(folder / "canopy.json", canopy.dump(2) + '\n');
}

}  // namespace
}  // namespace wold

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: canopy_leaves FOLDER\n");
    return 2;
  }
  try {
    wold::make_folder(arguments[1]);
    wold::write_canopy(arguments[1]);
  } catch (const wold::Error& error) {
    fmt::print(stderr, "canopy_leaves: {}\n", error.what());
    return 4;
  }
}
