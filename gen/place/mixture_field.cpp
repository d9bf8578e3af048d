#include "place/mixture_field.h"

#include <algorithm>
#include <bit>
#include <ranges>
#include <set>

#include "core/parallel.h"
#include "place/cell_window.h"
#include "scene/species.h"

namespace wold::place {
namespace {

/// Places along a side of a square that are looked at.
constexpr int samples = 257;

/// Mixtures are sets of missing species, a bit for each.
int species_apart(int a, int b) { return std::popcount(static_cast<unsigned>(a ^ b)); }

}  // namespace

MixtureField::MixtureField(const scene::Scene& scene, const Heightfield& terrain)
    : mixtures_(static_cast<int>(scene::mixtures_of(scene).size())) {
  if (mixtures_ == 1) return;
  terrain_ = std::make_shared<const Heightfield>(terrain);
  habitats_ = std::make_shared<const Habitats>(scene, *terrain_);
  present_.clear();
  find_present(terrain.square());
  if (is_large(scene)) find_present(CellWindow(scene).square);
  add_present_without_shrubs(scene);
  instead_.clear();
  for (int mixture = 0; mixture < mixtures_; ++mixture)
    instead_.push_back(*std::ranges::min_element(
        present_, {}, [&](int other) { return species_apart(mixture, other); }));
}

int MixtureField::at(const glm::dvec2& at_m) const {
  return habitats_ ? instead_[static_cast<std::size_t>(wanted(at_m))] : 0;
}

int MixtureField::wanted(const glm::dvec2& at_m) const {
  int missing = 0, likeliest = 0;
  double max = -2.0;
  for (int species = 0; species < habitats_->count(); ++species) {
    const double excess = habitats_->excess(species, at_m);
    if (excess <= 0.0) missing |= 1 << species;
    if (excess > max) likeliest = species;
    max = std::max(max, excess);
  }
  return missing < mixtures_ ? missing : missing & ~(1 << likeliest);
}

void MixtureField::find_present(const Square& square) {
  const GroundMap<int> places(samples, square);
  std::vector<std::set<int>> rows(samples);
  parallel_for(rows.size(), [&](std::size_t row) {
    for (int i = 0; i < samples; ++i)
      rows[row].insert(wanted(places.place_m(i, static_cast<int>(row))));
  });
  std::set<int> all(present_.begin(), present_.end());
  for (const std::set<int>& row : rows) all.insert(row.begin(), row.end());
  present_.assign(all.begin(), all.end());
}

void MixtureField::add_present_without_shrubs(const scene::Scene& scene) {
  std::set<int> all(present_.begin(), present_.end());
  for (const int mixture : present_) all.insert(scene::without_shrubs(scene, mixture));
  present_.assign(all.begin(), all.end());
}

}  // namespace wold::place
