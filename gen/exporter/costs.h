#pragma once

namespace wold::exporter {

/// Bytes of an exporter's files. A film's are those of each frame, and what its frames share once.
struct FileCosts {
  double frame = 0.0;                  ///< per frame
  double frame_terrain_sample = 0.0;   ///< per frame and sample of the terrain
  double frame_ground_sample = 0.0;    ///< per frame and sample of the ground's pictures
  double frame_light_sample = 0.0;     ///< per frame and sample of the maps that multiply the grass
  double frame_part = 0.0;             ///< per frame and part of a cell
  double frame_cloud_voxel = 0.0;      ///< per frame and voxel of a cloud
  double frame_haze_voxel = 0.0;       ///< per frame and voxel of snow that blows
  double shared_terrain_sample = 0.0;  ///< per sample of a terrain; snow makes others
  double shared_blade = 0.0;           ///< per blade of a patch that is shown as blades
  double shared_volume = 0.0;          ///< per volume
  /// Grids of FilmSettings::density_bits: numbers per voxel of a volume, and of those that volumes
  /// share which differ in light alone.
  double shared_density_grids = 0.0, shared_texel_grids = 0.0;
  double shared_filled_voxel = 0.0;  ///< per voxel with grass
};

/// Bytes that a renderer has of its own while it makes one picture.
struct MemoryCosts {
  double start = 0.0;           ///< of the program, before it reads anything
  double ground_sample = 0.0;   ///< per sample of the ground's pictures
  double cloud_voxel = 0.0;     ///< per voxel of a cloud
  double haze_voxel = 0.0;      ///< per voxel of snow that blows
  double terrain_sample = 0.0;  ///< per sample of the terrain
  double part = 0.0;            ///< per part of a cell
  double blade = 0.0;           ///< per blade of a patch that is shown as blades
  double density_grids = 0.0;   ///< as FileCosts::shared_density_grids
  double texel_grids = 0.0;     ///< as FileCosts::shared_texel_grids
  double voxel = 0.0;           ///< per voxel of a volume
  double filled_voxel = 0.0;    ///< per voxel with grass
};

}  // namespace wold::exporter
