#include "preview/camera_picture.h"

#include <algorithm>
#include <cmath>

#include "core/angle.h"
#include "core/colour.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "landscape/light_on_grass.h"
#include "preview/flakes.h"
#include "preview/ground_and_sky.h"
#include "preview/tubes.h"

namespace wold::preview {
namespace {

constexpr int finer = 2;  // pixels of a canvas along one of the picture

void paint_grass(const landscape::Landscape& landscape, const landscape::Perspective& perspective,
                 Canvas& canvas) {
  const LightAt light = [&](const glm::dvec3& at_m) {
    return landscape::light_on_grass(landscape, glm::dvec2(at_m));
  };
  for (const landscape::BladeCell& cell : landscape.blade_cells)
    paint_tubes(*landscape.blade_meshes[static_cast<std::size_t>(cell.mesh)].tubes,
                cell.world_from_cell, light, perspective, canvas);
}

}  // namespace

Image developed(const Image& radiance, double gain, int factor) {
  Image picture(radiance.width / factor, radiance.height / factor, 3);
  parallel_for(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (int j = 0; j < factor; ++j)
          for (int i = 0; i < factor; ++i)
            // What is brighter than white is white, however bright: else edges are jagged.
            sum += std::clamp(gain * radiance.pixel(x * factor + i, y * factor + j)[c], 0.0, 1.0);
        picture.pixel(x, y)[c] = static_cast<float>(srgb_encoded(sum / (factor * factor)));
      }
  });
  return picture;
}

Image camera_picture(const landscape::Landscape& landscape, int width_px) {
  const double aspect = static_cast<double>(landscape.height_px) / landscape.width_px;
  const int height_px = std::max(1, static_cast<int>(std::lround(aspect * width_px)));
  Canvas canvas(finer * width_px, finer * height_px);
  const landscape::Perspective perspective(landscape.camera,
                                           {canvas.radiance.width, canvas.radiance.height});
  paint_ground_and_sky(landscape, perspective, canvas);
  paint_grass(landscape, perspective, canvas);
  if (landscape.fog) paint_fog(*landscape.fog, perspective, canvas);
  paint_haze(landscape.clouds, perspective, canvas);
  paint_flakes(landscape.flakes, perspective, canvas);
  return developed(canvas.radiance, landscape.exposure_gain, finer);
}

Image patch_picture(const Tubes& tubes, double patch_m, double height_m, const glm::vec3& light,
                    const glm::ivec2& size_px) {
  constexpr double far_away = 12.0;  // in widths of what is seen
  const double width_m = std::max(1.45 * patch_m, 1.15 * height_m * size_px.x / size_px.y);
  const glm::dvec3 middle_m(0.5 * patch_m, 0.5 * patch_m, 0.45 * height_m);
  const landscape::Camera camera{middle_m + far_away * width_m * glm::dvec3(0.25, -0.93, 0.27),
                                 middle_m, degrees(2.0 * math::atan(0.5 / far_away))};
  Canvas canvas(finer * size_px.x, finer * size_px.y);
  std::fill(canvas.radiance.values.begin(), canvas.radiance.values.end(), 0.05F);
  const LightAt same = [&](const glm::dvec3&) { return light; };
  paint_tubes(tubes, glm::dmat4(1.0), same,
              {camera, {canvas.radiance.width, canvas.radiance.height}}, canvas);
  return developed(canvas.radiance, 1.0, finer);
}

}  // namespace wold::preview
