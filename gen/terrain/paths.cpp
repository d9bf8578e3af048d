#include "terrain/paths.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "terrain/relief.h"
#include "terrain/walked_way.h"

namespace wold::terrain {
namespace {

constexpr double ragged_m = 0.9, wear_m = 9.0;  // sizes of features

/// People step aside: up to some decimetres over a few metres, a metre over tens of them.
void wander(std::vector<glm::dvec2>& line_m, std::uint64_t key) {
  constexpr double feature_m = 22.0, aside_m = 0.7;
  const Fbm east(random_bits({key, key_of("east"), 0, 0}), 4, 0.8);
  const Fbm north(random_bits({key, key_of("north"), 0, 0}), 4, 0.8);
  for (glm::dvec2& at_m : line_m) {
    const glm::dvec2 place = at_m / feature_m;
    at_m += aside_m * glm::dvec2(east.at(place), north.at(place));
  }
}

/// Without points that are nearer than that to the one before.
std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& line_m, double least_m) {
  std::vector<glm::dvec2> thin{line_m.front()};
  for (const glm::dvec2& at_m : line_m)
    if (glm::distance(at_m, thin.back()) >= least_m) thin.push_back(at_m);
  return thin;
}

/// From the nearest place of a straight piece.
glm::dvec2 from_piece(const glm::dvec2& at_m, const glm::dvec2& begin_m, const glm::dvec2& end_m) {
  const glm::dvec2 along = end_m - begin_m, from_begin = at_m - begin_m;
  const double length2 = glm::dot(along, along);
  const double share =
      length2 > 0.0 ? std::clamp(glm::dot(from_begin, along) / length2, 0.0, 1.0) : 0.0;
  return from_begin - share * along;
}

/// Share of a strip of a width, `far_m` from its middle to the path's, that a path covers.
double covered(double far_m, double path_m, double strip_m) {
  const auto within = [&](double at_m) { return std::clamp(at_m, -0.5 * strip_m, 0.5 * strip_m); };
  return (within(far_m + 0.5 * path_m) - within(far_m - 0.5 * path_m)) / strip_m;
}

/// A path's half width, at most, and what is asked for beside it.
constexpr double near_m = 5.0 + 4.0;

glm::ivec2 square_at(const glm::dvec2& at_m) { return {glm::floor(at_m / near_m)}; }

std::uint64_t key_of_square(const glm::ivec2& square) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(square.x)) << 32U |
         static_cast<std::uint32_t>(square.y);
}

/// How far from its middle ground is another than without the path.
double reach_m(double width_m, double step_m) { return 2.0 * width_m + step_m; }

}  // namespace

Trodden TroddenPlaces::at(int i, int j) const {
  if (rows_.empty()) return {};
  const std::vector<Place>& row = rows_[static_cast<std::size_t>(j)];
  const auto place = std::ranges::lower_bound(row, i, {}, &Place::i);
  return place == row.end() || place->i != i ? Trodden{} : place->trodden;
}

Paths::Paths(const Heightfield& heights_m, const std::vector<scene::Path>& paths,
             std::uint64_t seed, const Water* water)
    : ragged_{random_bits({seed, key_of("paths"), 0, key_of("ragged")}), 4, 0.6},
      wear_{random_bits({seed, key_of("paths"), 0, key_of("wear")}), 3, 0.6} {
  for (const scene::Path& path : paths) {
    if (path.way_m.empty()) continue;
    std::vector<std::vector<glm::dvec2>> legs(path.way_m.size() / 2 - 1);
    parallel_for(legs.size(), [&](std::size_t leg) {
      const double* const way_m = &path.way_m[2 * leg];
      legs[leg] = walked_way(heights_m, {way_m[0], way_m[1]}, {way_m[2], way_m[3]}, water);
    });
    Path walked{{}, path.width_m};
    for (const std::vector<glm::dvec2>& leg : legs)
      walked.line_m.insert(walked.line_m.end(), leg.begin(), leg.end());
    walked.line_m = thinned(walked.line_m, 0.4 * path.width_m);
    wander(walked.line_m, random_bits({seed, key_of("paths"), 0, key_of("wander")}));
    paths_.push_back(std::move(walked));
  }
  file_pieces();
}

glm::dvec2 Paths::from_middle_m(const Piece& piece, const glm::dvec2& at_m) const {
  const std::vector<glm::dvec2>& line_m = paths_[piece.path].line_m;
  return from_piece(at_m, line_m[piece.point], line_m[piece.point + 1]);
}

void Paths::file_pieces() {
  for (std::size_t path = 0; path < paths_.size(); ++path)
    for (std::size_t k = 0; k + 1 < paths_[path].line_m.size(); ++k) {
      const glm::dvec2 &begin_m = paths_[path].line_m[k], &end_m = paths_[path].line_m[k + 1];
      const glm::ivec2 first = square_at(glm::min(begin_m, end_m) - near_m);
      const glm::ivec2 last = square_at(glm::max(begin_m, end_m) + near_m);
      for (int j = first.y; j <= last.y; ++j)
        for (int i = first.x; i <= last.x; ++i) near_[key_of_square({i, j})].push_back({path, k});
    }
}

bool Paths::lead_past(const glm::dvec2& at_m, double beside_m) const {
  const auto pieces = near_.find(key_of_square(square_at(at_m)));
  if (pieces == near_.end()) return false;
  return std::ranges::any_of(pieces->second, [&](const Piece& piece) {
    return glm::length(from_middle_m(piece, at_m)) <= beside_m + 0.5 * paths_[piece.path].width_m;
  });
}

std::vector<std::vector<glm::dvec2>> Paths::lines_m() const {
  std::vector<std::vector<glm::dvec2>> lines;
  for (const Path& path : paths_) lines.push_back(path.line_m);
  return lines;
}

TroddenPlaces Paths::on_grid(const Heightfield& heights_m, const GroundGrid& grid) const {
  std::vector<std::vector<Near>> rows(static_cast<std::size_t>(grid.samples));
  for (std::size_t path = 0; path < paths_.size(); ++path)
    for (std::size_t k = 0; k + 1 < paths_[path].line_m.size(); ++k)
      add_near({path, k}, grid, rows);
  TroddenPlaces places;
  places.rows_.resize(rows.size());
  parallel_for(rows.size(), [&](std::size_t j) {
    // Of a sample near several pieces the nearest counts.
    std::ranges::sort(rows[j], {}, [](const Near& near) { return std::pair(near.i, near.far_m); });
    const auto others = std::ranges::unique(rows[j], {}, &Near::i);
    rows[j].erase(others.begin(), others.end());
    for (const Near& near : rows[j]) {
      const glm::dvec2 at_m =
          grid.square.corner_m + glm::dvec2(near.i, static_cast<double>(j)) * grid.step_m();
      places.rows_[j].push_back(
          {near.i, trodden(near, at_m, gradient(heights_m, at_m.x, at_m.y), grid.step_m())});
    }
  });
  return places;
}

void Paths::add_near(const Piece& piece, const GroundGrid& grid,
                     std::vector<std::vector<Near>>& rows) const {
  const Path& path = paths_[piece.path];
  const double far_m = reach_m(path.width_m, grid.step_m());
  const glm::dvec2 &begin_m = path.line_m[piece.point], &end_m = path.line_m[piece.point + 1];
  const auto sample_at = [&](const glm::dvec2& at_m) {
    return glm::clamp((at_m - grid.square.corner_m) / grid.step_m(), -1.0, 1.0 * grid.samples);
  };
  const glm::ivec2 first(glm::ceil(sample_at(glm::min(begin_m, end_m) - far_m)));
  const glm::ivec2 last(glm::floor(sample_at(glm::max(begin_m, end_m) + far_m)));
  for (int j = std::max(first.y, 0); j <= std::min(last.y, grid.samples - 1); ++j)
    for (int i = std::max(first.x, 0); i <= std::min(last.x, grid.samples - 1); ++i) {
      const glm::dvec2 at_m = grid.square.corner_m + glm::dvec2(i, j) * grid.step_m();
      const double off_m = glm::length(from_middle_m(piece, at_m));
      if (off_m <= far_m) rows[static_cast<std::size_t>(j)].push_back({i, off_m, piece});
    }
}

Trodden Paths::trodden(const Near& near, const glm::dvec2& at_m, const glm::dvec2& ascent,
                       double step_m) const {
  constexpr double soft = 0.4, ragged = 0.16, uneven = 0.1;  // of the width; of the wear
  constexpr double trampled = 0.3, trampled_wide = 2.2;      // of the grass beside; of the width
  constexpr double levelled = 0.8, deep_m = 0.03, edge = 0.25;
  const double width_m = paths_[near.piece.path].width_m, half_m = 0.5 * width_m;
  const double shown = shown_fraction(width_m, step_m);
  const double far_m = near.far_m + shown * ragged * width_m * ragged_.at(at_m / ragged_m);
  const double wear = std::clamp(1.0 - uneven + uneven * wear_.at(at_m / wear_m), 0.7, 1.0);
  const double bare = covered(far_m, width_m, std::max(soft * width_m, step_m));
  const double beside =
      trampled * covered(far_m, trampled_wide * width_m, std::max(width_m, step_m));
  Trodden place{wear * std::max(bare, beside), {}};
  if (near.far_m <= 0.0 || shown <= 0.0) return place;
  const glm::dvec2 outwards = from_middle_m(near.piece, at_m) / near.far_m;
  const double across = levelled * glm::dot(ascent, outwards);
  double rise = 0.0;
  if (far_m < half_m) rise -= across;                      // the tread
  if (far_m >= half_m && far_m < width_m) rise += across;  // banks go back to the slope
  if (std::abs(far_m - half_m) < edge * half_m) rise += deep_m / (2.0 * edge * half_m);
  place.gradient = shown * wear * rise * outwards;
  return place;
}

}  // namespace wold::terrain
