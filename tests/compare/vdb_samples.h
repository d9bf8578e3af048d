#pragma once

#include <filesystem>

namespace wold::test {

/// What the sample grids look like.
struct SampleVdb {
  float peak = 2.0F;     ///< of `density`, 8^3 voxels rising along x
  float changed = 0.0F;  ///< added to voxel (3, 4, 5)
  int extra_voxel = 0;   ///< 1: voxel (20, 0, 0) holds `peak` too
  int active_zeros = 0;  ///< so many active voxels of the value 0, outside the others
  double voxel_m = 0.25;
  bool has_emission = true;
};

/// Writes a file with `density` (float) and `emission` (three times the density's value).
void write_sample_vdb(const std::filesystem::path& path, const SampleVdb& sample);

}  // namespace wold::test
