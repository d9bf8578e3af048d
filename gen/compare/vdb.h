#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "compare/differences.h"

namespace wold::compare {

/// One grid of an OpenVDB file, for people. Boxes are index space, both ends included.
struct GridFacts {
  std::string name;
  std::string type;  ///< OpenVDB's: "Tree_float_5_4_3"
  bool stored_as_half = false;
  glm::ivec3 box_min{0};
  glm::ivec3 box_max{-1};
  glm::dvec3 voxel_m{0.0};
  std::uint64_t active_voxels = 0;
  std::uint64_t memory_bytes = 0;
  bool has_range = false;  ///< false: no active voxel, or a type without a range
  double min = 0.0;        ///< over active voxels and all components
  double largest = 0.0;
  std::uint64_t non_finite = 0;  ///< active values that are no finite numbers
  std::vector<std::pair<std::string, std::string>> metadata;
};

struct VdbFacts {
  std::vector<GridFacts> grids;
  std::vector<std::pair<std::string, std::string>> metadata;
};

/// Throws FileError when the file is missing or damaged.
VdbFacts vdb_facts(const std::filesystem::path& path);

/// How two grids of one name differ, over all voxels that are active in either, relative to the
/// largest magnitude in `want`.
struct GridMetrics : Differences {
  std::string name;
  GridFacts got;
  GridFacts want;
  bool same_type = false;
  bool same_transform = false;
  bool is_compared = false;           ///< values of this type can be compared and were
  std::uint64_t active_only_got = 0;  ///< voxels
  std::uint64_t active_only_want = 0;
  double fraction_active_in_one = 0.0;  ///< of those that are active in either
};

struct VdbMetrics {
  std::vector<GridMetrics> grids;  ///< by name
  std::vector<std::string> only_got;
  std::vector<std::string> only_want;
};

/// Compares grids by name: float, double, int32 and vec3s values. Throws FileError when a file is
/// missing or damaged.
VdbMetrics compare_vdb(const std::filesystem::path& got, const std::filesystem::path& want,
                       double soft);

}  // namespace wold::compare
