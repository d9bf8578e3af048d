#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace wold::usd {

/// Where in a picture a place is looked up: at = scale * st + offset, from its lower left corner.
struct PicturePlace {
  glm::dvec2 scale{1.0};
  glm::dvec2 offset{0.0};
};

/// A picture of linear values, each channel times a factor.
struct Texture {
  std::string file;  ///< from the layer's folder on
  glm::dvec3 factor{1.0};
  PicturePlace place{};
};

/// What a surface does: it glows, or scatters all the same in every direction, or both. It mirrors
/// nothing.
struct Surface {
  std::optional<Texture> radiance = {};
  std::optional<glm::dvec3> even_radiance = {};  ///< the same everywhere, where there is no picture
  std::optional<Texture> reflectance = {};       ///< fraction of the light
  std::optional<Texture> opacity = {};           ///< its first channel
};

/// A Material prim with a UsdPreviewSurface and the readers it needs. `path` is where it will be,
/// such as "/Landscape/Materials/ground". Surfaces find their pictures by the primvar `st`.
std::string material_text(const std::string& path, const Surface& surface);

}  // namespace wold::usd
