#include "grass/geometry/silhouette.h"

#include "core/elementary.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/snow_ridge.h"

namespace wold::grass {
namespace {

void append_blade(const Blade& blade, const BladePose& pose, const BladeAxis& axis, int segments,
                  Piece piece, std::vector<Piece>& pieces) {
  const float length_m = blade.length_m * pose.length_scale;
  piece.b_m = on_patch_m(blade, axis.at(0.0F));
  for (int i = 1; i <= segments; ++i) {
    piece.a_m = piece.b_m;
    piece.along_a = piece.along_b;
    piece.along_b = static_cast<float>(i) / static_cast<float>(segments);
    const AxisPoint to = axis.at(length_m * piece.along_b);
    piece.b_m = on_patch_m(blade, to);
    piece.tangent = from_plane(blade, to.tangent);
    const float middle = 0.5F * (piece.along_a + piece.along_b);
    piece.half_m = glm::vec2(blade.radius_m * pose.mesophyll_width * (1.0F - middle));
    pieces.push_back(piece);
  }
}

void append_ridge(const Blade& blade, const BladePose& pose, const BladeAxis& axis, Piece piece,
                  std::vector<Piece>& pieces) {
  constexpr int segments = 48;
  const float length_m = blade.length_m * pose.length_scale;
  const glm::vec3 root_m = foot_m(blade);
  piece.snow = true;
  piece.level = glm::vec3(-blade.heading.y, blade.heading.x, 0.0F);
  for (int i = 0; i < segments; ++i) {
    piece.along_a = static_cast<float>(i) / segments;
    piece.along_b = static_cast<float>(i + 1) / segments;
    const float middle = 0.5F * (piece.along_a + piece.along_b);
    const AxisPoint at = axis.at(length_m * middle);
    const SnowRidge ridge = snow_ridge(blade, pose, middle, at);
    if (ridge.half_height_m <= 0.0F) continue;
    const glm::vec2 half_way = 0.5F * length_m / segments * at.tangent;
    piece.a_m = root_m + from_plane(blade, ridge.centre_m - half_way);
    piece.b_m = root_m + from_plane(blade, ridge.centre_m + half_way);
    piece.tangent = from_plane(blade, at.tangent);
    piece.upper = from_plane(blade, upper_side(at.tangent));
    piece.half_m = {ridge.half_width_m, ridge.half_height_m};
    pieces.push_back(piece);
  }
}

/// Where a ray along `direction` through a place meets the ground's plane, in patches.
glm::dvec2 on_ground(const glm::vec3& place_m, const glm::vec3& direction, double patch_m) {
  const glm::vec2 slope = glm::vec2(direction) / direction.z;
  return glm::dvec2((glm::vec2(place_m) - place_m.z * slope) / static_cast<float>(patch_m));
}

}  // namespace

std::vector<Piece> pieces_of(const std::vector<Blade>& blades, const std::vector<BladePose>& poses,
                             int segments) {
  std::vector<Piece> pieces;
  pieces.reserve(blades.size() * static_cast<std::size_t>(segments));
  for (std::uint32_t i = 0; i < blades.size(); ++i) {
    const BladeAxis axis(blades[i], poses[i]);
    append_blade(blades[i], poses[i], axis, segments, {.blade = i}, pieces);
    if (poses[i].snow > 0.0F) append_ridge(blades[i], poses[i], axis, {.blade = i}, pieces);
  }
  return pieces;
}

Strip strip_of(const Piece& piece, double patch_m, const glm::vec3& direction) {
  const glm::vec3 across = glm::cross(piece.tangent, direction);
  const glm::vec3 aside = across / std::max(glm::length(across), 1e-3F);
  const float reach_m = piece.snow ? math::hypot(piece.half_m.x * glm::dot(aside, piece.level),
                                                 piece.half_m.y * glm::dot(aside, piece.upper))
                                   : piece.half_m.x;
  return {on_ground(piece.a_m, direction, patch_m), on_ground(piece.b_m, direction, patch_m),
          on_ground(aside * reach_m, direction, patch_m)};
}

}  // namespace wold::grass
