#include "landscape/vdb_medium.h"

namespace wold::landscape {

void leave_out_empty_voxels(openvdb::FloatGrid& extinction) {
  for (auto at = extinction.beginValueOn(); at; ++at)
    if (!(*at > 0.0F)) at.setValueOff();
  extinction.pruneGrid();
}

CloudGrids cloud_grids(const CloudBox& cloud) {
  CloudGrids grids = {openvdb::FloatGrid::create(0.0F),
                      openvdb::Vec3SGrid::create(openvdb::Vec3s(0.0F))};
  auto extinction = grids.extinction->getAccessor();
  auto radiance = grids.radiance->getAccessor();
  std::size_t i = 0;
  for (int z = 1; z <= cloud.voxels.z; ++z)
    for (int y = 1; y <= cloud.voxels.y; ++y)
      for (int x = 1; x <= cloud.voxels.x; ++x, ++i) {
        if (!(cloud.extinction_per_m[i] > 0.0F)) continue;
        const glm::vec3& light = cloud.radiance[i];
        extinction.setValue(openvdb::Coord(x, y, z), cloud.extinction_per_m[i]);
        radiance.setValue(openvdb::Coord(x, y, z), openvdb::Vec3s(light.x, light.y, light.z));
      }
  return grids;
}

}  // namespace wold::landscape
