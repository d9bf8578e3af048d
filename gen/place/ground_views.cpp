#include "place/ground_views.h"

#include <algorithm>

#include "scene/calendar.h"

namespace wold::place {
namespace {

bool are_alike(const landscape::Camera& a, const landscape::Camera& b) {
  return a.eye_m == b.eye_m && a.target_m == b.target_m &&
         a.field_of_view_deg == b.field_of_view_deg;
}

/// Of ground that a grid's picture shows and no finer one: `view` without what lies inside the soft
/// border of the finer one.
View beside(const View& view, const GroundGrid& grid, const GroundGrid& finer) {
  // The border takes two steps, and maps of light have values four steps apart.
  constexpr double border_steps = 6.0;
  const double border_m = border_steps * grid.step_m();
  const double inside_m = finer.square.size_m - 2.0 * border_m;
  if (inside_m <= 0.0) return view;
  return view.outside({finer.square.corner_m + border_m, inside_m});
}

/// Where nothing stands on a detail it shows no farther than light and slopes need.
View of_detail(const View& view, const GroundGrid& grid, const Stands& stands) {
  constexpr double of_side = 0.05;
  if (stands(grid.square)) return view;
  return view.reaching(std::min(view.reach_m(), of_side * grid.square.size_m));
}

View in_sight(const scene::Scene& scene, const Heightfield& terrain,
              const landscape::Camera& camera) {
  return View(camera, scene.render.size_px[0], scene.render.size_px[1]).over(terrain);
}

}  // namespace

std::vector<View> views_of_pictures(const View& view, const GroundGrid& whole,
                                    const std::vector<GroundGrid>& details, const Stands& stands) {
  if (details.empty()) return {view};
  std::vector<View> views{beside(view, whole, details.front())};
  for (std::size_t i = 0; i < details.size(); ++i) {
    const View all = of_detail(view, details[i], stands);
    const bool finest = i + 1 == details.size();
    views.push_back(finest ? all : beside(all, details[i], details[i + 1]));
  }
  return views;
}

std::vector<View> views_of_film(const scene::Scene& scene, const Heightfield& terrain) {
  constexpr std::size_t most = 8;
  std::vector<landscape::Camera> cameras;
  for (int frame = 1; frame <= scene::frame_count(scene); ++frame) {
    const landscape::Camera camera = camera_of_frame(scene, terrain, frame);
    const auto same = [&](const landscape::Camera& other) { return are_alike(camera, other); };
    if (std::ranges::none_of(cameras, same)) cameras.push_back(camera);
    if (cameras.size() > most) return {};
  }
  std::vector<View> views;
  for (const landscape::Camera& camera : cameras) views.push_back(in_sight(scene, terrain, camera));
  return views;
}

View view_of_frame(const scene::Scene& scene, const Heightfield& terrain, int frame) {
  return in_sight(scene, terrain, camera_of_frame(scene, terrain, frame));
}

}  // namespace wold::place
