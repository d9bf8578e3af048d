#include "landscape/far_field.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "landscape/cells.h"
#include "terrain/relief.h"

namespace wold::landscape {
namespace {

glm::dvec3 on_ground(const Heightfield& terrain, const glm::dvec2& at_m) {
  return {at_m, terrain.sample(at_m.x, at_m.y)};
}

/// Every sample of a map that may be in the picture, in parallel: visit(i, j, place in metres).
template <class Map, class Visit>
void each_in_view(const Map& map, const Heightfield& terrain, const View& view,
                  const Visit& visit) {
  parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < map.samples(); ++i) {
      const glm::dvec3 at_m = on_ground(terrain, glm::dvec2(i, j) * map.step_m());
      constexpr double margin_m = 2.0;
      if (view.may_see(at_m, margin_m)) visit(i, j, at_m);
    }
  });
}

/// More grass along a ray, where the same number of blades stands on each square metre of a slope.
double slope_factor(const glm::dvec2& gradient) {
  return std::sqrt(1.0 + glm::dot(gradient, gradient));
}

/// The look at a weathering degree, between those of the two key frames around it.
FarLook look_at(const std::map<int, PatchLook>& looks, const std::vector<double>& key_frames,
                double weathering, const glm::dvec3& direction) {
  const auto above = std::upper_bound(key_frames.begin() + 1, key_frames.end() - 1, weathering);
  const auto key = static_cast<int>(above - key_frames.begin());
  const double share = (weathering - *(above - 1)) / (*above - *(above - 1));
  const FarLook before = looks.at(key - 1).along(direction);
  const FarLook after = looks.at(key).along(direction);
  return {glm::mix(before.radiance, after.radiance, share),
          std::lerp(before.transmittance, after.transmittance, share)};
}

/// A line of sight as a cell sees it that is sheared to the slope; the flattest still goes down.
glm::dvec3 in_cell(const glm::dvec3& sight, const glm::dvec2& gradient) {
  const double down = sight.z - glm::dot(gradient, glm::dvec2(sight));
  return {sight.x, sight.y, std::min(down, -0.03)};
}

}  // namespace

double far_share(const scene::Grass& grass, const View& view, const glm::dvec3& at_m) {
  const double relative = view.pixels(grass.height_m, at_m) / std::max(grass.far_pixels, 1e-9);
  return 1.0 - glm::smoothstep(0.75, 1.25, relative);
}

bool has_far_field(const scene::Scene& scene, const Heightfield& terrain, const View& view) {
  constexpr int places = 64;
  for (int j = 0; j <= places; ++j)
    for (int i = 0; i <= places; ++i) {
      const glm::dvec2 at_m = glm::dvec2(i, j) * (terrain.size_m() / places);
      const glm::dvec3 place_m = on_ground(terrain, at_m);
      if (view.may_see(place_m, terrain.size_m() / places) &&
          far_share(scene.grass, view, place_m) > 0.0)
        return true;
    }
  return false;
}

std::vector<int> far_key_frames(const scene::Scene& scene, int frame) {
  const std::vector<double>& keys = scene.grass.key_frames;
  const auto [least, most] = weathering_range(scene, frame);
  const auto first = std::upper_bound(keys.begin() + 1, keys.end() - 1, least) - 1;
  const auto last = std::upper_bound(keys.begin() + 1, keys.end() - 1, most);
  std::vector<int> frames;
  for (auto key = first; key <= last; ++key) frames.push_back(static_cast<int>(key - keys.begin()));
  return frames;
}

void paint_far_grass(ColourMap& ground, const scene::Scene& scene, const Heightfield& terrain,
                     const FactorMap& growth, const ColourMap& light, const View& view, int frame,
                     const std::map<int, PatchLook>& looks) {
  each_in_view(ground, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const double share = far_share(scene.grass, view, at_m);
    if (share <= 0.0) return;
    const glm::dvec2 gradient = terrain::gradient(terrain, at_m.x, at_m.y);
    const double weathering = local_weathering(scene, glm::dvec2(at_m), frame);
    const FarLook look = thickened(look_at(looks, scene.grass.key_frames, weathering,
                                           in_cell(view.line_of_sight(at_m), gradient)),
                                   slope_factor(gradient) * double{growth.sample(at_m.x, at_m.y)});
    const glm::vec3 grass = glm::vec3(look.radiance) * light.sample(at_m.x, at_m.y);
    const glm::vec3 seen = grass + static_cast<float>(look.transmittance) * ground.at(i, j);
    ground.at(i, j) = glm::mix(ground.at(i, j), seen, static_cast<float>(share));
  });
}

FactorMap standing_grass(const scene::Scene& scene, const Heightfield& terrain,
                         const FactorMap& growth, const View& view) {
  FactorMap factor(growth.samples(), growth.size_m());
  each_in_view(factor, terrain, view, [&](int i, int j, const glm::dvec3& at_m) {
    const glm::dvec2 gradient = terrain::gradient(terrain, at_m.x, at_m.y);
    const double standing = 1.0 - far_share(scene.grass, view, at_m);
    factor.at(i, j) = growth.at(i, j) * static_cast<float>(standing * slope_factor(gradient));
  });
  return factor;
}

}  // namespace wold::landscape
