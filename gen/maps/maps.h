#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/progress.h"
#include "phenology/film_season.h"
#include "scene/scene.h"

namespace wold::maps {

/// A map that has been written, or was there.
struct MapFile {
  std::filesystem::path file;
  std::string name;
  std::string unit;  ///< "" for fractions
  int frame = 0;     ///< from 1; 0: the same in all of them
};

/// All files that write_maps() may write.
std::vector<std::filesystem::path> map_files(const std::filesystem::path& folder,
                                             const std::vector<int>& frames);

/// Writes what a scene's ground is like as GeoTIFFs into a folder, a value at each of its heights:
/// height.tif (over the elevation model's zero, or the scene's), slope.tif (degrees), growth.tif
/// (share on which grass grows), water.tif (share that is a lake), and of each of the frames (from
/// 1) weathering_0001.tif (degree of the grass), snow_depth_0001.tif (m), and on terrains that are
/// not large snow_water_0001.tif (mm of water in that snow). `season`: phenology::film_season() of
/// the scene; `scratch`: a folder for this call alone. `source`: a hash of what they are made from
/// beside the ground that is read here. Maps that are there from the same source and ground stay as
/// they are. Throws what place::make_site() throws, FileError and InterruptedError.
std::vector<MapFile> write_maps(const scene::Scene& scene,
                                std::shared_ptr<const phenology::FilmSeason> season,
                                const std::vector<int>& frames, const std::filesystem::path& folder,
                                const std::filesystem::path& scratch, const std::string& source,
                                Progress& progress);

/// As a JSON array of objects with the keys version, file, map, unit and frame, a line break at the
/// end.
std::string as_json(const std::vector<MapFile>& files);

}  // namespace wold::maps
