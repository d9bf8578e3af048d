#include "terrain/surroundings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "terrain/elevation.h"
#include "terrain/known_land.h"
#include "terrain/made_up_land.h"
#include "terrain/resampling.h"

namespace wold::terrain {
namespace {

constexpr double wider = 3.0;  // each square than the one before

/// Heights along a side: of the square next to the scene's, where a model knows it, and of others.
/// Some of them lie on the border of the square within.
constexpr int nearest_known_samples = 802, samples = 322;
static_assert((nearest_known_samples - 1) % 3 == 0 && (samples - 1) % 3 == 0 && wider == 3.0);

/// How much finer features are shown than the steps of heights that are kept, and how much higher
/// they are on steep land than on land of the mean slope, at most.
constexpr double refinement = 8.0, max_roughness = 1.0;

GroundGrid grid_of_ring(const Square& middle, int ring, bool is_known) {
  double size_m = middle.size_m;
  for (int i = 0; i <= ring; ++i) size_m *= wider;
  return {{middle.corner_m - 0.5 * (size_m - middle.size_m), size_m},
          ring == 0 && is_known ? nearest_known_samples : samples};
}

template <class Visit>
void each_row(int rows, const Visit& visit) {
  parallel_for(static_cast<std::size_t>(rows),
               [&](std::size_t row) { visit(static_cast<int>(row)); });
}

/// How far a place lies outside of a square; negative inside.
double outside_m(const Square& square, const glm::dvec2& at_m) {
  const glm::dvec2 out_m = glm::max(square.corner_m - at_m, at_m - square.corner_m - square.size_m);
  return std::max(out_m.x, out_m.y);
}

/// Puts a finer map's heights into a map, where the finer one has some: on its border, too,
/// whatever rounding makes of it.
template <class Finer>
void put(const Finer& finer, GroundMap<double>& heights_m) {
  const double rounding_m = 1e-6 * heights_m.step_m();
  each_row(heights_m.samples(), [&](int j) {
    for (int i = 0; i < heights_m.samples(); ++i) {
      const glm::dvec2 at_m = heights_m.place_m(i, j);
      if (outside_m(finer.square(), at_m) <= rounding_m)
        heights_m.at(i, j) = finer.sample(at_m.x, at_m.y);
    }
  });
}

/// How much higher the scene's zero counts than a model's: by the land that both know. None where
/// they have none in common.
std::optional<double> offset_m(const GroundMap<double>& known_m, const GroundMap<double>& model_m) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < known_m.values().size(); ++i) {
    const double offset = known_m.values()[i] - model_m.values()[i];
    if (std::isnan(offset)) continue;
    sum += offset;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

/// The same of a model next to the scene's square. Throws InputError where it lies elsewhere.
double required_offset_m(const std::string& file, const GroundMap<double>& known_m,
                         const GroundMap<double>& model_m) {
  const auto offset = offset_m(known_m, model_m);
  if (!offset)
    throw InputError(
        fmt::format("terrain.surroundings: {}: expected heights in and around the square of {} m "
                    "(terrain.size), where terrain.elevation has some; it has none there",
                    file, known_m.size_m() / wider));
  return *offset;
}

/// What a model knows where nobody did.
void add_model(const GroundMap<double>& model_m, double offset_m, GroundMap<double>& heights_m) {
  for (std::size_t i = 0; i < heights_m.values().size(); ++i) {
    double& height_m = heights_m.values()[i];
    if (std::isnan(height_m)) height_m = model_m.values()[i] + offset_m;
  }
}

/// Whether a model has heights at the border of a square, so that it may reach farther.
bool reaches_border(const GroundMap<double>& model_m) {
  const int last = model_m.samples() - 1;
  for (int i = 0; i <= last; ++i)
    for (const double height_m :
         {model_m.at(i, 0), model_m.at(i, last), model_m.at(0, i), model_m.at(last, i)})
      if (!std::isnan(height_m)) return true;
  return false;
}

/// A model of the land around.
struct Model {
  const std::string& file;
  std::optional<double> offset_m = {};  ///< offset_m() of the nearest square
  bool is_read = false;                 ///< all of it that is needed
};

Heightfield with_made_up_land(const KnownLand& known, const MadeUpLand& land) {
  const GroundMap<double>& heights_m = known.heights_m;
  Heightfield all(heights_m.samples(), heights_m.square());
  each_row(all.samples(), [&](int j) {
    for (int i = 0; i < all.samples(); ++i) {
      double height_m = heights_m.at(i, j);
      if (const double from_known_m = known.distance_m.at(i, j); from_known_m > 0.0)
        height_m += land.height_m(all.place_m(i, j), all.step_m(), from_known_m);
      all.at(i, j) = static_cast<float>(height_m);
    }
  });
  return all;
}

/// A height between those of a map that are kept, smooth across their cells, by cubic convolution.
/// It is theirs at their places.
double smooth_height_m(const Heightfield& map, const glm::dvec2& at_m) {
  const glm::dvec2 place = (at_m - map.corner_m()) / map.step_m();
  const glm::dvec2 corner = glm::floor(place);
  const auto of_column = cubic_weights(place.x - corner.x);
  const auto of_row = cubic_weights(place.y - corner.y);
  const auto inside = [&](double k) {
    return static_cast<int>(std::clamp(k, 0.0, map.samples() - 1.0));
  };
  double sum_m = 0.0;
  for (std::size_t j = 0; j < 4; ++j)
    for (std::size_t i = 0; i < 4; ++i)
      sum_m += of_row[j] * of_column[i] *
               double{map.at(inside(corner.x + static_cast<double>(i) - 1.0),
                             inside(corner.y + static_cast<double>(j) - 1.0))};
  return sum_m;
}

/// Rise per distance to the east and to the north, by differences over two steps.
template <class Height>
glm::dvec2 gradient(const Height& height_m, const glm::dvec2& at_m, double step_m) {
  const auto rise = [&](const glm::dvec2& along) {
    return (height_m(at_m + along * step_m) - height_m(at_m - along * step_m)) / (2.0 * step_m);
  };
  return {rise({1.0, 0.0}), rise({0.0, 1.0})};
}

/// Of a map and of what is shown of it.
MadeUpLand::Steps steps_in(const Heightfield& map, double shown_m) {
  return {map.step_m(), std::max(map.step_m() / refinement, shown_m)};
}

double slope_at(const Heightfield& map, const glm::dvec2& at_m) {
  const auto height_m = [&](const glm::dvec2& place_m) {
    return double{map.sample(place_m.x, place_m.y)};
  };
  return glm::length(gradient(height_m, at_m, map.step_m()));
}

double mean_slope(const Heightfield& map) {
  double sum = 0.0;
  for (int j = 0; j < map.samples(); ++j)
    for (int i = 0; i < map.samples(); ++i) sum += slope_at(map, map.place_m(i, j));
  return sum / static_cast<double>(map.values().size());
}

}  // namespace

Surroundings::Surroundings(const scene::Terrain& terrain, const Heightfield& ground,
                           std::uint64_t seed, double reach_m)
    : square_(ground.square()),
      plan_(std::make_unique<const Plan>(Plan{terrain, ground, seed, reach_m})) {
  if (!terrain.elevation.empty()) land();  // models may be at fault
}

const Surroundings::Land& Surroundings::land() const {
  if (const Land* made = made_.load(std::memory_order_acquire)) return *made;
  const std::lock_guard lock(making_);
  if (!land_) {
    land_ = std::make_unique<const Land>(make(*plan_));
    plan_.reset();
    made_.store(land_.get(), std::memory_order_release);
  }
  return *land_;
}

Surroundings::Land Surroundings::make(const Plan& plan) const {
  const auto& [terrain, ground, seed, reach_m] = plan;
  Land land{MadeUpLand(ground, seed), {}, std::numeric_limits<double>::lowest()};
  std::vector<Model> models;
  if (!terrain.elevation.empty()) models.push_back({terrain.elevation});
  if (!terrain.elevation.empty() && !terrain.surroundings.empty())
    models.push_back({terrain.surroundings});
  GroundMap<double> finer_m;
  do {
    const GroundGrid grid =
        grid_of_ring(square_, static_cast<int>(land.rings.size()), !models.empty());
    GroundMap<double> heights_m(grid.samples, grid.square,
                                std::numeric_limits<double>::quiet_NaN());
    if (!land.rings.empty()) put(finer_m, heights_m);
    put(ground, heights_m);
    for (Model& model : models) {
      if (model.is_read) continue;
      const GroundMap<double> model_m = heights_around(terrain, model.file, grid);
      if (!model.offset_m) model.offset_m = required_offset_m(model.file, heights_m, model_m);
      add_model(model_m, *model.offset_m, heights_m);
      model.is_read = !reaches_border(model_m);
    }
    finer_m = heights_m;
    Heightfield map = with_made_up_land(filled_in(std::move(heights_m)), land.made_up);
    const double slope = mean_slope(map);
    HighestAround highest(map);
    const double most_finer_m = max_roughness * land.made_up.most_finer_m(steps_in(map, 0.0));
    land.highest_m = std::max(land.highest_m, highest.highest_m() + most_finer_m);
    land.rings.push_back({std::move(map), slope, std::move(highest), most_finer_m});
  } while (reach_m_of(land.rings.back().map.size_m()) < reach_m);
  return land;
}

std::size_t Surroundings::ring_of(const glm::dvec2& at_m) const {
  const std::vector<Ring>& rings = land().rings;
  std::size_t ring = 0;
  while (ring + 1 < rings.size() && !rings[ring].map.square().contains(at_m)) ++ring;
  return ring;
}

/// How much a square counts at a place in it: less near its border, where it goes over into the
/// next one.
double Surroundings::part_within(std::size_t ring, const glm::dvec2& at_m) const {
  constexpr double border = 0.05;  // of a square
  if (ring + 1 == land().rings.size()) return 1.0;
  const Square square = land().rings[ring].map.square();
  return glm::smoothstep(0.0, border * square.size_m, -outside_m(square, at_m));
}

/// A height at a place, from the squares that count there.
template <class HeightInRing>
double Surroundings::between_rings(const glm::dvec2& at_m, const HeightInRing& height_in) const {
  const std::vector<Ring>& rings = land().rings;
  const std::size_t ring = ring_of(at_m);
  const double height_m = height_in(rings[ring]), within = part_within(ring, at_m);
  return within >= 1.0 ? height_m : std::lerp(height_in(rings[ring + 1]), height_m, within);
}

double Surroundings::finer_m(const Ring& ring, const glm::dvec2& at_m, double shown_m) const {
  const MadeUpLand::Steps steps = steps_in(ring.map, shown_m);
  if (steps.fine_m >= steps.coarse_m || ring.slope <= 0.0) return 0.0;
  const double rough = std::min(slope_at(ring.map, at_m) / ring.slope, max_roughness);
  return rough * land().made_up.finer_m(at_m, steps, std::max(0.0, outside_m(square_, at_m)));
}

double Surroundings::coarse_height_m(const glm::dvec2& at_m) const {
  return between_rings(at_m,
                       [&](const Ring& ring) { return double{ring.map.sample(at_m.x, at_m.y)}; });
}

double Surroundings::height_m(const glm::dvec2& at_m, double shown_m) const {
  return between_rings(at_m, [&](const Ring& ring) {
    return smooth_height_m(ring.map, at_m) + finer_m(ring, at_m, shown_m);
  });
}

double Surroundings::highest_m(const glm::dvec2& at_m) const {
  const std::vector<Ring>& rings = land().rings;
  const auto highest_in = [&](const Ring& ring) {
    return ring.highest.highest_m(at_m) + ring.most_finer_m;
  };
  const std::size_t ring = ring_of(at_m);
  const double highest_m = highest_in(rings[ring]);
  return part_within(ring, at_m) >= 1.0 ? highest_m
                                        : std::max(highest_m, highest_in(rings[ring + 1]));
}

glm::dvec3 Surroundings::up(const glm::dvec2& at_m, double shown_m) const {
  const double shown = std::max(step_m(at_m) / refinement, shown_m);
  const auto height = [&](const glm::dvec2& place_m) { return height_m(place_m, shown); };
  return glm::normalize(glm::dvec3(-gradient(height, at_m, shown), 1.0));
}

}  // namespace wold::terrain
