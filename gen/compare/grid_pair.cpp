#include "compare/grid_pair.h"

#include <fmt/format.h>

#include "compare/vdb.h"
#include "core/df3.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

Json box_json(const GridFacts& facts) {
  return {{facts.box_min.x, facts.box_min.y, facts.box_min.z},
          {facts.box_max.x, facts.box_max.y, facts.box_max.z}};
}

Json to_json(const GridMetrics& grid) {
  Json json = {{"name", grid.name},
               {"type", {grid.got.type, grid.want.type}},
               {"same_transform", grid.same_transform},
               {"active_voxels", {grid.got.active_voxels, grid.want.active_voxels}},
               {"box", {box_json(grid.got), box_json(grid.want)}}};
  if (!grid.is_compared) return json;
  json["active_in_one"] = {grid.active_only_got, grid.active_only_want};
  json.update(to_json(static_cast<const Differences&>(grid)));
  return json;
}

std::vector<std::string> grid_faults(const GridMetrics& grid) {
  if (!grid.same_type) return {fmt::format("type {}, want {}", grid.got.type, grid.want.type)};
  if (!grid.is_compared)
    return {fmt::format("values of type {} cannot be compared", grid.got.type)};
  if (!grid.same_transform) return {"the transforms differ"};
  return {};
}

std::vector<Measure> grid_measures(const GridMetrics& grid, const Limits& limits) {
  if (!grid.is_compared) return {};
  std::vector<Measure> list = measures(grid, limits);
  list.push_back({.name = "share of voxels active in only one",
                  .value = grid.fraction_active_in_one,
                  .max = limits.allowed_fraction});
  return list;
}

void add(const GridMetrics& grid, const Limits& limits, Comparison& comparison) {
  for (const std::string& fault : grid_faults(grid))
    comparison.faults.push_back(fmt::format("grid {}: {}", grid.name, fault));
  for (Measure& measure : grid_measures(grid, limits)) {
    measure.name = fmt::format("grid {}: {}", grid.name, measure.name);
    comparison.measures.push_back(std::move(measure));
  }
  comparison.metrics["grids"].push_back(to_json(grid));
}

/// Filled is what the renderer meets: values above 0.
struct Filled {
  std::size_t only_got = 0;
  std::size_t only_want = 0;
};

Filled filled_in_one(const Df3& got, const Df3& want) {
  Filled filled;
  for (std::size_t i = 0; i < got.values.size(); ++i) {
    if (want.values[i] == 0.0F && got.values[i] > 0.0F) ++filled.only_got;
    if (got.values[i] == 0.0F && want.values[i] > 0.0F) ++filled.only_want;
  }
  return filled;
}

Differences value_differences(const Df3& got, const Df3& want, double soft) {
  DifferenceSum sum(soft);
  for (std::size_t i = 0; i < got.values.size(); ++i) {
    sum.add(got.values[i], want.values[i]);
    sum.end_sample();
  }
  return sum.result();
}

}  // namespace

Comparison compare_vdbs(const fs::path& got, const fs::path& want, const Limits& limits) {
  const VdbMetrics metrics = compare_vdb(got, want, limits.soft);
  Comparison result;
  for (const std::string& name : metrics.only_want)
    result.faults.push_back(fmt::format("grid {} is missing", name));
  for (const std::string& name : metrics.only_got)
    result.faults.push_back(fmt::format("grid {} is not wanted", name));
  result.metrics["grids"] = Json::array();
  for (const GridMetrics& grid : metrics.grids) add(grid, limits, result);
  return result;
}

Comparison compare_df3s(const fs::path& got_path, const fs::path& want_path, const Limits& limits) {
  const Df3 got = read_df3(got_path);
  const Df3 want = read_df3(want_path);
  Comparison result;
  if (got.size != want.size) {
    result.faults.push_back(fmt::format("got {} x {} x {} values, want {} x {} x {}", got.size.x,
                                        got.size.y, got.size.z, want.size.x, want.size.y,
                                        want.size.z));
    return result;
  }
  const Differences differences = value_differences(got, want, limits.soft);
  const Filled filled = filled_in_one(got, want);
  result.metrics = {{"size", {got.size.x, got.size.y, got.size.z}},
                    {"bits", {got.bits, want.bits}}};
  // No limit: 8 bits hold as 0 what 16 bits hold as a trace.
  result.metrics["filled_in_one"] = {filled.only_got, filled.only_want};
  result.metrics.update(to_json(differences));
  result.measures = measures(differences, limits);
  return result;
}

}  // namespace wold::compare
