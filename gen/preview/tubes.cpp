#include "preview/tubes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wold::preview {
namespace {

constexpr double nearest_m = 0.02;

struct Corner {
  glm::dvec3 seen;  ///< Perspective::seen()
  glm::vec3 radiance;
};

/// Twice the area of a triangle, signed.
double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The pixels whose middles lie in the triangle and nothing nearer is. Depths are interpolated
/// linearly, which is right enough for what is small.
void paint_triangle(const std::array<Corner, 3>& corners, Canvas& canvas) {
  const glm::dvec2 a(corners[0].seen), b(corners[1].seen), c(corners[2].seen);
  const double whole = area(a, b, c);
  if (whole >= 0.0) return;  // seen from inside the tube
  const glm::dvec2 low = glm::max(glm::floor(glm::min(glm::min(a, b), c)), 0.0);
  const glm::dvec2 high = glm::min(glm::ceil(glm::max(glm::max(a, b), c)),
                                   glm::dvec2(canvas.radiance.width, canvas.radiance.height));
  for (int y = static_cast<int>(low.y); y < high.y; ++y)
    for (int x = static_cast<int>(low.x); x < high.x; ++x) {
      const glm::dvec2 at(x + 0.5, y + 0.5);
      const glm::dvec3 fraction =
          glm::dvec3(area(b, c, at), area(c, a, at), area(a, b, at)) / whole;
      if (fraction.x < 0.0 || fraction.y < 0.0 || fraction.z < 0.0) continue;
      const double depth_m = fraction.x * corners[0].seen.z + fraction.y * corners[1].seen.z +
                             fraction.z * corners[2].seen.z;
      float& nearest = canvas.depth_at(x, y);
      if (depth_m >= nearest) continue;
      nearest = static_cast<float>(depth_m);
      const glm::vec3 radiance = float(fraction.x) * corners[0].radiance +
                                 float(fraction.y) * corners[1].radiance +
                                 float(fraction.z) * corners[2].radiance;
      std::copy_n(&radiance.x, 3, canvas.radiance.pixel(x, y));
    }
}

void paint_quad(const Corner& a, const Corner& b, const Corner& c, const Corner& d,
                Canvas& canvas) {
  for (const Corner* corner : {&a, &b, &c, &d})
    if (corner->seen.z < nearest_m) return;
  paint_triangle({a, b, c}, canvas);
  paint_triangle({a, c, d}, canvas);
}

constexpr int min_rings = 4;
constexpr int max_rings = 7;

/// At most that many of the rings of a tube, from the first to the last.
std::vector<int> drawn_rings(int rings, int max) {
  const int count = std::min(rings, max);
  std::vector<int> drawn;
  drawn.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) drawn.push_back(i * (rings - 1) / std::max(1, count - 1));
  return drawn;
}

/// Whether a tube is so short in the picture that few rings show its bend.
bool is_small(const Tubes& tubes, std::size_t tube, const glm::dmat4& world_from_cell,
              const landscape::Perspective& perspective) {
  constexpr double short_px = 24.0;
  const auto ring = static_cast<std::size_t>(tubes.corners);
  const std::size_t of_tube = static_cast<std::size_t>(tubes.rings) * ring;
  const glm::vec3& from_m = tubes.vertices_m[tube * of_tube];
  const glm::vec3& to_m = tubes.vertices_m[(tube + 1) * of_tube - ring];
  const double depth_m = perspective.seen(glm::dvec3(world_from_cell * glm::dvec4(from_m, 1.0))).z;
  return glm::distance(from_m, to_m) * perspective.pixels_per_m(std::max(depth_m, nearest_m)) <
         short_px;
}

}  // namespace

void paint_tubes(const Tubes& tubes, const glm::dmat4& world_from_cell, const LightAt& light,
                 const landscape::Perspective& perspective, Canvas& canvas) {
  const std::vector<int> few = drawn_rings(tubes.rings, min_rings);
  const std::vector<int> many = drawn_rings(tubes.rings, max_rings);
  const auto corners = static_cast<std::size_t>(tubes.corners);
  std::vector<Corner> tube(many.size() * corners);
  for (std::size_t t = 0; t < tubes.count(); ++t) {
    const std::vector<int>& rings = is_small(tubes, t, world_from_cell, perspective) ? few : many;
    glm::vec3 factor(1.0F);
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const std::size_t ring =
          t * static_cast<std::size_t>(tubes.rings) + static_cast<std::size_t>(rings[r]);
      for (std::size_t c = 0; c < corners; ++c) {
        const glm::dvec3 at_m(world_from_cell *
                              glm::dvec4(tubes.vertices_m[ring * corners + c], 1.0));
        if (r == 0 && c == 0) factor = light(at_m);
        tube[r * corners + c] = {perspective.seen(at_m), tubes.radiance[ring] * factor};
      }
    }
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
      for (std::size_t c = 0; c < corners; ++c) {
        const std::size_t next = (c + 1) % corners;
        paint_quad(tube[r * corners + c], tube[r * corners + next], tube[(r + 1) * corners + next],
                   tube[(r + 1) * corners + c], canvas);
      }
  }
}

}  // namespace wold::preview
