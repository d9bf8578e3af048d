#include "compare/vdb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/error.h"
#include "core/vdb_file.h"

namespace wold::compare {
namespace {

using Comparable = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid,
                                     openvdb::BoolGrid, openvdb::Vec3SGrid>;
using GridsByName = std::map<std::string, openvdb::GridBase::Ptr>;

/// A value as a list of components.
template <class T>
auto components(const T& value) {
  if constexpr (openvdb::VecTraits<T>::IsVec)
    return std::array<double, 3>{value[0], value[1], value[2]};
  else
    return std::array<double, 1>{static_cast<double>(value)};
}

glm::ivec3 to_glm(const openvdb::Coord& coord) { return {coord.x(), coord.y(), coord.z()}; }

std::vector<std::pair<std::string, std::string>> metadata_text(const openvdb::MetaMap& map) {
  std::vector<std::pair<std::string, std::string>> text;
  for (auto entry = map.beginMeta(); entry != map.endMeta(); ++entry)
    text.emplace_back(entry->first, entry->second->str());
  return text;
}

template <class Grid>
void add_range(const Grid& grid, GridFacts& facts) {
  for (auto value = grid.cbeginValueOn(); value; ++value)
    for (double component : components(*value)) {
      if (!std::isfinite(component)) {
        ++facts.non_finite;
        continue;
      }
      facts.min = facts.has_range ? std::min(facts.min, component) : component;
      facts.largest = facts.has_range ? std::max(facts.largest, component) : component;
      facts.has_range = true;
    }
}

GridFacts facts_of(const openvdb::GridBase& grid) {
  GridFacts facts;
  facts.name = grid.getName();
  facts.type = grid.type();
  facts.stored_as_half = grid.saveFloatAsHalf();
  const openvdb::CoordBBox box = grid.evalActiveVoxelBoundingBox();
  facts.box_min = to_glm(box.min());
  facts.box_max = to_glm(box.max());
  const openvdb::Vec3d voxel = grid.voxelSize();
  facts.voxel_m = {voxel.x(), voxel.y(), voxel.z()};
  facts.active_voxels = grid.activeVoxelCount();
  facts.memory_bytes = grid.memUsage();
  facts.metadata = metadata_text(grid);
  grid.apply<Comparable>([&](const auto& typed) { add_range(typed, facts); });
  return facts;
}

GridsByName grids_by_name(const std::filesystem::path& path) {
  const openvdb::GridPtrVecPtr all = read_vdb(path);
  GridsByName grids;
  for (const openvdb::GridBase::Ptr& grid : *all) grids[grid->getName()] = grid;
  return grids;
}

template <class Grid>
openvdb::MaskTree active_voxels(const Grid& grid) {
  openvdb::MaskTree mask(grid.tree(), false, openvdb::TopologyCopy());
  mask.voxelizeActiveTiles();
  return mask;
}

template <class Grid>
Differences value_differences(const Grid& got, const Grid& want,
                              const openvdb::MaskTree& active_in_either, double soft,
                              double range) {
  DifferenceSum sum(soft, range);
  const auto got_values = got.getConstAccessor();
  const auto want_values = want.getConstAccessor();
  for (auto voxel = active_in_either.cbeginValueOn(); voxel; ++voxel) {
    const auto a = components(got_values.getValue(voxel.getCoord()));
    const auto b = components(want_values.getValue(voxel.getCoord()));
    for (std::size_t i = 0; i < a.size(); ++i) sum.add(a[i], b[i]);
    sum.end_sample();
  }
  return sum.result();
}

/// A tile of a few bytes stands for millions of voxels, which are compared one by one.
void require_comparable(const openvdb::GridBase& grid) {
  constexpr std::uint64_t max_voxels = std::uint64_t{1} << 28;
  if (const std::uint64_t voxels = grid.activeVoxelCount(); voxels > max_voxels)
    throw FileError(fmt::format("found {} active voxels in the grid {}, expected {} at most",
                                voxels, grid.getName(), max_voxels));
}

/// How many voxels are in the first but not in the second.
std::uint64_t only_in(openvdb::MaskTree first, const openvdb::MaskTree& second) {
  first.topologyDifference(second);
  return first.activeVoxelCount();
}

/// What differences are relative to; 1 for a grid of zeros.
double magnitude(const GridFacts& facts) {
  const double largest = std::max(std::abs(facts.min), std::abs(facts.largest));
  return largest > 0.0 ? largest : 1.0;
}

template <class Grid>
void compare_typed(const Grid& got, const Grid& want, double soft, GridMetrics& metrics) {
  require_comparable(got);
  require_comparable(want);
  const openvdb::MaskTree got_active = active_voxels(got);
  const openvdb::MaskTree want_active = active_voxels(want);
  openvdb::MaskTree either = got_active;
  either.topologyUnion(want_active);
  metrics.active_only_got = only_in(got_active, want_active);
  metrics.active_only_want = only_in(want_active, got_active);
  const auto in_one = static_cast<double>(metrics.active_only_got + metrics.active_only_want);
  metrics.fraction_active_in_one =
      in_one / static_cast<double>(std::max<std::uint64_t>(either.activeVoxelCount(), 1));
  static_cast<Differences&>(metrics) =
      value_differences(got, want, either, soft, magnitude(metrics.want));
}

GridMetrics compare_grids(const openvdb::GridBase& got, const openvdb::GridBase& want,
                          double soft) {
  GridMetrics metrics;
  metrics.name = want.getName();
  metrics.got = facts_of(got);
  metrics.want = facts_of(want);
  metrics.same_type = metrics.got.type == metrics.want.type;
  metrics.same_transform = got.constTransform() == want.constTransform();
  if (!metrics.same_type) return metrics;
  metrics.is_compared = want.apply<Comparable>([&](const auto& typed) {
    compare_typed(static_cast<const std::decay_t<decltype(typed)>&>(got), typed, soft, metrics);
  });
  return metrics;
}

}  // namespace

VdbFacts vdb_facts(const std::filesystem::path& path) {
  const openvdb::GridPtrVecPtr grids = read_vdb(path);
  VdbFacts facts;
  for (const openvdb::GridBase::Ptr& grid : *grids) facts.grids.push_back(facts_of(*grid));
  facts.metadata = metadata_text(*read_vdb_metadata(path));
  return facts;
}

VdbMetrics compare_vdb(const std::filesystem::path& got, const std::filesystem::path& want,
                       double soft) {
  const GridsByName got_grids = grids_by_name(got);
  const GridsByName want_grids = grids_by_name(want);
  VdbMetrics metrics;
  for (const auto& [name, grid] : want_grids) {
    const auto found = got_grids.find(name);
    if (found == got_grids.end())
      metrics.only_want.push_back(name);
    else
      metrics.grids.push_back(compare_grids(*found->second, *grid, soft));
  }
  for (const auto& [name, grid] : got_grids)
    if (!want_grids.contains(name)) metrics.only_got.push_back(name);
  return metrics;
}

}  // namespace wold::compare
