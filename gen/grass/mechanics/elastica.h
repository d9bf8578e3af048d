#pragma once

#include <array>
#include <glm/glm.hpp>

namespace wold::grass {

/// Segments of the chain that stands for an elastica: within 0.3 % of the continuum up to a load of
/// 50.
inline constexpr int elastica_segments = 64;

/// Load beyond which an elastica bends no further: a hairpin less than a fiftieth of its length
/// high.
inline constexpr double largest_load = 1000.0;

/// A place on an elastica of length 1.
struct ElasticaNode {
  double angle = 0.0;     ///< of the tangent from the upward vertical, rad
  glm::dvec2 place{0.0};  ///< from the root, (along the heading, up)
};

/// Nodes at equal distances from the root to the tip.
using Elastica = std::array<ElasticaNode, elastica_segments + 1>;

/// The heavy elastica: an inextensible blade, clamped at its root at `lean` from the upward
/// vertical (rad, 0 to pi / 2), that bends under its own weight,
///   theta'' = -B (1 - u) sin(theta),  theta(0) = lean,  theta'(1) = 0,  u = s / L,
/// with the load B = q L^3 / (E I) >= 0, q its weight per length. Of several equilibria it is the
/// one that bends one way only, which is the stable one. An upright blade stands up to Greenhill's
/// B = 7.8373 (1881, Proceedings of the Cambridge Philosophical Society 4:65) and buckles towards
/// its heading beyond. The ground is not in the way.
Elastica heavy_elastica(double lean, double load);

}  // namespace wold::grass
