#include "vdb_samples.h"

#include "core/vdb_file.h"

namespace wold::test {
namespace {

template <class Grid, class Value>
typename Grid::Ptr ramp(const char* name, const SampleVdb& sample, const Value& value) {
  auto grid = Grid::create();
  grid->setName(name);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(sample.voxel_m));
  auto voxels = grid->getAccessor();
  for (int i = 0; i < 512; ++i) {
    const openvdb::Coord at(i % 8, i / 8 % 8, i / 64);
    const float change = at == openvdb::Coord(3, 4, 5) ? sample.changed : 0.0F;
    voxels.setValue(at, value(sample.peak * static_cast<float>(at.x()) / 7.0F + change));
  }
  if (sample.extra_voxel == 1) voxels.setValue({20, 0, 0}, value(sample.peak));
  for (int i = 0; i < sample.active_zeros; ++i) voxels.setValue({i, 30, 0}, value(0.0F));
  return grid;
}

}  // namespace

void write_sample_vdb(const std::filesystem::path& path, const SampleVdb& sample) {
  openvdb::initialize();
  openvdb::GridPtrVec grids;
  grids.push_back(ramp<openvdb::FloatGrid>("density", sample, [](float v) { return v; }));
  if (sample.has_emission)
    grids.push_back(
        ramp<openvdb::Vec3SGrid>("emission", sample, [](float v) { return openvdb::Vec3s(v); }));
  write_vdb(path, grids);
}

}  // namespace wold::test
