#include "grass/mechanics/elastica.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.h"

namespace wold::grass {
namespace {

using std::numbers::pi;
constexpr double step = 1.0 / elastica_segments;
/// No blade stands exactly upright: this lean (rad) decides to which side it buckles.
constexpr double smallest_lean = 1e-4;
/// How well the chain meets the clamp, rad.
constexpr double clamp_tolerance = 1e-7;

/// Rigid segments joined by elastic hinges, hanging from a clamp.
struct Chain {
  std::array<double, elastica_segments> angle;  ///< of each segment from the vertical
  double clamp = 0.0;                           ///< of the clamp
};

/// The chain whose last segment has the angle `tip`. From the free tip down, the moment in a hinge
/// is that in the next one plus what the weight beyond adds over the lever of one segment; it turns
/// the segments against each other, the first one against the clamp by half a segment's bending.
///
/// Where a chain would lean back past the vertical, its weight is left out, so that it goes on
/// straight: the clamp's angle rises with the tip's, and only the chain that bends one way fits.
Chain chain_from_tip(double load, double tip) {
  Chain chain;
  double angle = tip;
  double curvature = 0.0;
  for (int i = elastica_segments - 1; i >= 0; --i) {
    chain.angle[static_cast<std::size_t>(i)] = angle;
    const double weight_beyond = load * (1.0 - (i + 0.5) * step);
    if (angle > 0.0) curvature += weight_beyond * math::sin(angle) * step;
    angle -= curvature * (i > 0 ? step : 0.5 * step);
  }
  chain.clamp = angle;
  return chain;
}

/// Solves chain_from_tip(load, tip).clamp = lean for the tip, by the false position of Anderson and
/// Bjoerck (1973, BIT 13:253), in the logarithm of what the tip lacks to hanging straight down:
/// under great loads that is all that tells one chain from another.
Chain chain_at_clamp(double load, double lean) {
  const auto chain = [&](double lack) { return chain_from_tip(load, pi - math::exp(lack)); };
  double from = math::log(pi - lean), to = math::log(1e-13);
  double misfit_from = chain(from).clamp - lean, misfit_to = chain(to).clamp - lean;
  for (int i = 0; i < 100; ++i) {
    const double next = (from * misfit_to - to * misfit_from) / (misfit_to - misfit_from);
    const Chain found = chain(next);
    const double misfit = found.clamp - lean;
    if (std::abs(misfit) < clamp_tolerance) return found;
    if ((misfit > 0.0) == (misfit_to > 0.0)) {
      const double shrink = 1.0 - misfit / misfit_to;
      misfit_from *= shrink > 0.0 ? shrink : 0.5;
    } else {
      from = to;
      misfit_from = misfit_to;
    }
    to = next;
    misfit_to = misfit;
  }
  return chain(to);
}

}  // namespace

Elastica heavy_elastica(double lean, double load) {
  const double clamp = std::max(lean, smallest_lean);
  const Chain chain = chain_at_clamp(std::min(load, largest_load), clamp);
  Elastica nodes;
  nodes[0].angle = clamp;
  for (std::size_t i = 0; i < elastica_segments; ++i) {
    const double angle = chain.angle[i];
    const double beyond = i + 1 < elastica_segments ? chain.angle[i + 1] : angle;
    nodes[i + 1].angle = 0.5 * (angle + beyond);
    nodes[i + 1].place = nodes[i].place + step * glm::dvec2(math::sin(angle), math::cos(angle));
  }
  return nodes;
}

}  // namespace wold::grass
