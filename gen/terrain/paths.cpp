#include "terrain/paths.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "core/samples_between.h"
#include "core/segment.h"
#include "terrain/relief.h"
#include "terrain/walked_way.h"

namespace wold::terrain {
namespace {

constexpr double ragged_m = 0.9, wear_m = 9.0;  // sizes of features
/// A path's half width, at most, and what is asked for beside it.
constexpr double near_m = 5.0 + 4.0;

/// Cuts a line's corners, but for its ends (Chaikin 1974).
std::vector<glm::dvec2> cut_corners(const std::vector<glm::dvec2>& line) {
  std::vector<glm::dvec2> cut{line.front()};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    if (k > 0) cut.push_back(glm::mix(line[k], line[k + 1], 0.25));
    if (k + 2 < line.size()) cut.push_back(glm::mix(line[k], line[k + 1], 0.75));
  }
  cut.push_back(line.back());
  return cut;
}

/// Without points that are nearer than that to the one before.
std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& line_m, double least_m) {
  std::vector<glm::dvec2> thin{line_m.front()};
  for (const glm::dvec2& at_m : line_m)
    if (glm::distance(at_m, thin.back()) >= least_m) thin.push_back(at_m);
  return thin;
}

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

/// Of the path through a number of legs.
std::vector<glm::dvec2> smooth_line(const std::vector<std::vector<glm::dvec2>>& legs,
                                    double width_m, std::uint64_t key) {
  constexpr int rounds = 3;
  constexpr double least_piece = 0.4;  // of the width
  std::vector<glm::dvec2> line_m;
  for (const std::vector<glm::dvec2>& leg : legs)
    line_m.insert(line_m.end(), leg.begin() + (line_m.empty() ? 0 : 1), leg.end());
  for (int round = 0; round < rounds; ++round) line_m = cut_corners(line_m);
  line_m = thinned(line_m, least_piece * width_m);
  wander(line_m, key);
  return line_m;
}

/// Share of a strip of a width, `far_m` from its middle to the path's, that a path covers.
double covered(double far_m, double path_m, double strip_m) {
  const auto within = [&](double at_m) { return std::clamp(at_m, -0.5 * strip_m, 0.5 * strip_m); };
  return (within(far_m + 0.5 * path_m) - within(far_m - 0.5 * path_m)) / strip_m;
}

/// How far from its middle ground is another than without the path.
double reach_m(double width_m, double step_m) { return 2.0 * width_m + step_m; }

std::uint64_t key_of_square(const glm::ivec2& square) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(square.x)) << 32U |
         static_cast<std::uint32_t>(square.y);
}

}  // namespace

Trodden TroddenPlaces::at(int i, int j) const {
  if (rows_.empty()) return {};
  const std::vector<Place>& row = rows_[static_cast<std::size_t>(j)];
  const auto place = std::ranges::lower_bound(row, i, {}, &Place::i);
  return place == row.end() || place->i != i ? Trodden{} : place->trodden;
}

bool TroddenPlaces::empty() const {
  return std::ranges::all_of(rows_, [](const std::vector<Place>& row) { return row.empty(); });
}

Paths::Paths(const Heightfield& heights_m, const std::vector<scene::Path>& paths,
             std::uint64_t seed, const Water* water)
    : ragged_{random_bits({seed, key_of("paths"), 0, key_of("ragged")}), 4, 0.6},
      wear_{random_bits({seed, key_of("paths"), 0, key_of("wear")}), 3, 0.6} {
  using Leg = std::vector<glm::dvec2>;
  std::vector<std::vector<Leg>> legs(paths.size());
  for (std::size_t path = 0; path < paths.size(); ++path)
    legs[path].resize(std::max<std::size_t>(paths[path].way_m.size() / 2, 1) - 1);
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t path = 0; path < paths.size(); ++path)
    for (std::size_t leg = 0; leg < legs[path].size(); ++leg) all.emplace_back(path, leg);
  parallel_for(all.size(), [&](std::size_t k) {
    const auto [path, leg] = all[k];
    const double* const way_m = &paths[path].way_m[2 * leg];
    legs[path][leg] = walked_way(heights_m, {way_m[0], way_m[1]}, {way_m[2], way_m[3]}, water);
  });
  const std::uint64_t key = random_bits({seed, key_of("paths"), 0, key_of("wander")});
  for (std::size_t path = 0; path < paths.size(); ++path)
    if (!legs[path].empty())
      paths_.push_back({smooth_line(legs[path], paths[path].width_m, key), paths[path].width_m});
  file_pieces();
}

glm::dvec2 Paths::from_middle_m(const Piece& piece, const glm::dvec2& at_m) const {
  const glm::dvec2 &begin = begin_m(piece), &end = end_m(piece);
  return at_m - glm::mix(begin, end, share_of_way(at_m, begin, end));
}

glm::ivec2 Paths::square_at(const glm::dvec2& at_m) const { return {glm::floor(at_m / square_m_)}; }

void Paths::file_pieces() {
  std::vector<Piece> pieces;
  for (std::size_t path = 0; path < paths_.size(); ++path)
    for (std::size_t k = 0; k + 1 < paths_[path].line_m.size(); ++k) {
      pieces.push_back({path, k});
      const double length_m = glm::distance(begin_m(pieces.back()), end_m(pieces.back()));
      square_m_ = std::max(square_m_, length_m + near_m);
    }
  for (const Piece& piece : pieces) {
    const auto [low_m, high_m] = box_m(piece, near_m);
    const glm::ivec2 first = square_at(low_m), last = square_at(high_m);
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) near_[key_of_square({i, j})].push_back(piece);
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

TroddenPlaces Paths::on_grid(const Heightfield& heights_m, const GroundGrid& grid,
                             const RowParts& parts) const {
  TroddenPlaces places;
  const std::vector<Piece> pieces = pieces_on(grid);
  if (pieces.empty()) return places;
  places.rows_.resize(static_cast<std::size_t>(grid.samples));
  parallel_for(places.rows_.size(), [&](std::size_t j) {
    places.rows_[j] = row(static_cast<int>(j), pieces, heights_m, grid, parts[j]);
  });
  return places;
}

std::pair<glm::dvec2, glm::dvec2> Paths::box_m(const Piece& piece, double around_m) const {
  return {glm::min(begin_m(piece), end_m(piece)) - around_m,
          glm::max(begin_m(piece), end_m(piece)) + around_m};
}

std::vector<Paths::Piece> Paths::pieces_on(const GroundGrid& grid) const {
  const glm::dvec2 corner_m = grid.square.corner_m;
  std::vector<Piece> pieces;
  for (std::size_t path = 0; path < paths_.size(); ++path)
    for (std::size_t k = 0; k + 1 < paths_[path].line_m.size(); ++k) {
      const auto [low_m, high_m] = box_m({path, k}, reach_m(paths_[path].width_m, grid.step_m()));
      if (glm::all(glm::greaterThanEqual(high_m, corner_m)) &&
          glm::all(glm::lessThanEqual(low_m, corner_m + grid.square.size_m)))
        pieces.push_back({path, k});
    }
  return pieces;
}

std::vector<const Paths::Piece*> Paths::nearest_pieces(std::span<const Piece> of_path, int j,
                                                       const GroundGrid& grid) const {
  const double step_m = grid.step_m(),
               far_m = reach_m(paths_[of_path.front().path].width_m, step_m);
  const glm::dvec2 west_m = grid.square.corner_m + glm::dvec2(0.0, j * step_m);
  std::vector<const Piece*> nearest;
  std::vector<double> off_m(static_cast<std::size_t>(grid.samples), far_m);
  for (const Piece& piece : of_path) {
    const auto [low_m, high_m] = box_m(piece, far_m);
    if (west_m.y < low_m.y || west_m.y > high_m.y) continue;
    nearest.resize(off_m.size(), nullptr);
    const glm::ivec2 along = samples_between(low_m.x, high_m.x, west_m.x, grid);
    for (int i = along[0]; i <= along[1]; ++i) {
      const double here_m = glm::length(from_middle_m(piece, west_m + glm::dvec2(i * step_m, 0.0)));
      const auto sample = static_cast<std::size_t>(i);
      if (here_m >= off_m[sample]) continue;
      off_m[sample] = here_m;
      nearest[sample] = &piece;
    }
  }
  return nearest;
}

/// Of a path's pieces the nearest counts, of paths the one that has worn more.
std::vector<TroddenPlaces::Place> Paths::row(int j, std::span<const Piece> pieces,
                                             const Heightfield& heights_m, const GroundGrid& grid,
                                             const RowPart& part) const {
  std::vector<Trodden> most;
  while (!pieces.empty()) {
    const auto others = std::ranges::find_if(
        pieces, [&](const Piece& piece) { return piece.path != pieces.front().path; });
    const auto of_path = pieces.first(static_cast<std::size_t>(others - pieces.begin()));
    pieces = pieces.subspan(of_path.size());
    const std::vector<const Piece*> nearest = nearest_pieces(of_path, j, grid);
    if (nearest.empty()) continue;
    most.resize(nearest.size());
    visit_row(part, [&](int i) {
      const Piece* const piece = nearest[static_cast<std::size_t>(i)];
      if (piece == nullptr) return;
      const glm::dvec2 at_m = grid.square.corner_m + glm::dvec2(i, j) * grid.step_m();
      const Trodden here =
          trodden(*piece, at_m, gradient(heights_m, at_m.x, at_m.y), grid.step_m());
      Trodden& all = most[static_cast<std::size_t>(i)];
      if (here.bare > all.bare) all = here;
    });
  }
  std::vector<TroddenPlaces::Place> places;
  for (std::size_t i = 0; i < most.size(); ++i)
    if (most[i].bare > 0.0) places.push_back({static_cast<int>(i), most[i]});
  return places;
}

Trodden Paths::trodden(const Piece& piece, const glm::dvec2& at_m, const glm::dvec2& ascent,
                       double step_m) const {
  constexpr double soft = 0.4, ragged = 0.16, uneven = 0.1;  // of the width; of the wear
  constexpr double trampled = 0.3, trampled_wide = 2.2;      // of the grass beside; of the width
  constexpr double levelled = 0.8, deep_m = 0.03, edge = 0.25;
  constexpr double steepest_bank = 0.62;  // what is steeper slides
  const double width_m = paths_[piece.path].width_m, half_m = 0.5 * width_m;
  const double shown = shown_fraction(width_m, step_m);
  const glm::dvec2 off = from_middle_m(piece, at_m);
  const double off_m = glm::length(off);
  const double far_m = off_m + shown * ragged * width_m * ragged_.at(at_m / ragged_m);
  const double wear = std::clamp(1.0 - uneven + uneven * wear_.at(at_m / wear_m), 0.7, 1.0);
  const double bare = covered(far_m, width_m, std::max(soft * width_m, step_m));
  const double beside =
      trampled * covered(far_m, trampled_wide * width_m, std::max(width_m, step_m));
  Trodden place{.bare = wear * std::max(bare, beside), .level = shown * wear * levelled * bare};
  if (off_m <= 0.0 || shown <= 0.0) return place;
  const glm::dvec2 outwards = off / off_m;
  const double across = levelled * glm::dot(ascent, outwards);
  const double room = std::max(0.0, steepest_bank - glm::length(ascent));
  double rise = 0.0;
  if (far_m < half_m) rise -= across;                                               // the tread
  if (far_m >= half_m && far_m < width_m) rise += std::clamp(across, -room, room);  // its bank
  if (std::abs(far_m - half_m) < edge * half_m) rise += deep_m / (2.0 * edge * half_m);
  place.gradient = shown * wear * rise * outwards;
  return place;
}

}  // namespace wold::terrain
