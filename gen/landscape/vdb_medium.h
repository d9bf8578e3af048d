#pragma once

#include "core/vdb.h"
#include "landscape/landscape.h"

namespace wold::landscape {

/// Takes voxels of no extinction out of a grid. In one thread: OpenVDB's foreach shares a leaf
/// between threads, whose voxels' states share words.
void leave_out_empty_voxels(openvdb::FloatGrid& extinction);

/// A cloud as OpenVDB's grids, index (1, 1, 1) being its first voxel; voxels without droplets are
/// left out. Neither has a name or a transform.
struct CloudGrids {
  openvdb::FloatGrid::Ptr extinction;  ///< 1/m
  openvdb::Vec3SGrid::Ptr radiance;    ///< of the source, CloudBox::radiance
};

CloudGrids cloud_grids(const CloudBox& cloud);

}  // namespace wold::landscape
