#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "cloud/periodic_map.h"
#include "cloud/texture_set.h"

namespace wold::cloud {

/// A layer's clouds over its whole period: ranks in steps of 1/65536, 0 the thinnest.
using LayerMap = PeriodicMap<std::uint16_t>;

/// One of three patches that meet at a place.
struct Patch {
  glm::ivec2 vertex;    ///< of the triangle grid, wrapped: the same after a period
  double weight = 0.0;  ///< >= 0; those of the three sum to 1
};

/// A grid of nearly equilateral triangles that repeats after `cells` cells.
class TriangleGrid {
 public:
  /// cells >= 1 each.
  explicit TriangleGrid(const glm::ivec2& cells);
  /// The triangle's corners around a place, in cells, any numbers. Weights are barycentric
  /// coordinates cubed and normalised: patches keep their shape over most of their area.
  std::array<Patch, 3> around(const glm::dvec2& place) const;
  /// Vertices of a period along a row, and rows.
  const glm::ivec2& vertices() const { return vertices_; }

 private:
  glm::ivec2 vertices_;  ///< along a period; an even number of rows
  glm::dvec2 per_cell_;  ///< vertices along a row, and rows, per cell
};

/// The texture in every cell, one by chance of the key: seams and all ([Wang2010], 2.2).
LayerMap repeated_as_paper(const TextureSet& textures, const glm::ivec2& cells,
                           const glm::ivec2& size_px, std::uint64_t key);

/// By-example tiling without seams or visible repetition that keeps the textures' histogram (Heitz
/// and Neyret 2018, High-performance by-example noise using a histogram-preserving blending
/// operator): Gaussianised ranks G_i of three patches with random places in the textures are
/// blended to sum(w_i G_i) / sqrt(sum w_i^2) and turned back into ranks. Where the textures have
/// patches, noise of the layer's own with that distribution, too, is added before.
LayerMap repeated_by_blending(const TextureSet& textures, const glm::ivec2& cells,
                              const glm::ivec2& size_px, std::uint64_t key);

}  // namespace wold::cloud
