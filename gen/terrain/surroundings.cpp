#include "terrain/surroundings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "terrain/elevation.h"
#include "terrain/known_land.h"
#include "terrain/made_up_land.h"

namespace wold::terrain {
namespace {

constexpr double wider = 3.0;  // each square than the one before

/// Heights along a side: of the square next to the scene's, where a model knows it, and of others.
constexpr int nearest_known_samples = 801, samples = 321;

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

/// Puts a finer map's heights into a map, where the finer one has some.
template <class Finer>
void put(const Finer& finer, GroundMap<double>& heights_m) {
  each_row(heights_m.samples(), [&](int j) {
    for (int i = 0; i < heights_m.samples(); ++i) {
      const glm::dvec2 at_m = heights_m.place_m(i, j);
      if (finer.square().contains(at_m)) heights_m.at(i, j) = finer.sample(at_m.x, at_m.y);
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

}  // namespace

Surroundings::Surroundings(const scene::Terrain& terrain, const Heightfield& ground,
                           std::uint64_t seed, double reach_m)
    : square_(ground.square()),
      plan_(std::make_unique<const Plan>(Plan{terrain, ground, seed, reach_m})) {
  if (!terrain.elevation.empty()) rings();  // models may be at fault
}

const Surroundings::Rings& Surroundings::rings() const {
  std::call_once(made_, [this] {
    rings_ = make(*plan_);
    plan_.reset();
  });
  return rings_;
}

Surroundings::Rings Surroundings::make(const Plan& plan) const {
  const auto& [terrain, ground, seed, reach_m] = plan;
  const MadeUpLand land(ground, seed);
  std::vector<Model> models;
  if (!terrain.elevation.empty()) models.push_back({terrain.elevation});
  if (!terrain.elevation.empty() && !terrain.surroundings.empty())
    models.push_back({terrain.surroundings});
  Rings rings;
  GroundMap<double> finer_m;
  do {
    const GroundGrid grid = grid_of_ring(square_, static_cast<int>(rings.size()), !models.empty());
    GroundMap<double> heights_m(grid.samples, grid.square,
                                std::numeric_limits<double>::quiet_NaN());
    if (!rings.empty()) put(finer_m, heights_m);
    put(ground, heights_m);
    for (Model& model : models) {
      if (model.is_read) continue;
      const GroundMap<double> model_m = heights_around(terrain, model.file, grid);
      if (!model.offset_m) model.offset_m = required_offset_m(model.file, heights_m, model_m);
      add_model(model_m, *model.offset_m, heights_m);
      model.is_read = !reaches_border(model_m);
    }
    finer_m = heights_m;
    rings.push_back(with_made_up_land(filled_in(std::move(heights_m)), land));
  } while (reach_m_of(rings.back()) < reach_m);
  return rings;
}

std::size_t Surroundings::ring_of(const glm::dvec2& at_m) const {
  const Rings& rings = this->rings();
  std::size_t ring = 0;
  while (ring + 1 < rings.size() && !rings[ring].square().contains(at_m)) ++ring;
  return ring;
}

double Surroundings::height_m(const glm::dvec2& at_m) const {
  constexpr double border = 0.05;  // of a square, over which it goes into the next one
  const Rings& rings = this->rings();
  const std::size_t ring = ring_of(at_m);
  const Heightfield& heights_m = rings[ring];
  const double height_m{heights_m.sample(at_m.x, at_m.y)};
  if (ring + 1 == rings.size()) return height_m;
  const Square& square = heights_m.square();
  const glm::dvec2 inside_m =
      glm::min(at_m - square.corner_m, square.corner_m + square.size_m - at_m);
  const double inner =
      glm::smoothstep(0.0, border * square.size_m, std::min(inside_m.x, inside_m.y));
  if (inner >= 1.0) return height_m;
  return std::lerp(double{rings[ring + 1].sample(at_m.x, at_m.y)}, height_m, inner);
}

glm::dvec3 Surroundings::up(const glm::dvec2& at_m) const {
  const double step = step_m(at_m);
  const auto rise = [&](const glm::dvec2& along) {
    return (height_m(at_m + along * step) - height_m(at_m - along * step)) / (2.0 * step);
  };
  return glm::normalize(glm::dvec3(-rise({1.0, 0.0}), -rise({0.0, 1.0}), 1.0));
}

}  // namespace wold::terrain
