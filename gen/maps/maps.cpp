#include "maps/maps.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "core/files.h"
#include "core/parallel.h"
#include "ground/snowy_ground.h"
#include "maps/geotiff.h"
#include "place/site.h"
#include "scene/calendar.h"
#include "terrain/elevation.h"
#include "terrain/relief.h"

namespace wold::maps {
namespace {

namespace fs = std::filesystem;

constexpr Quantity height = {"height", "m"}, slope = {"slope", "deg"}, growth = {"growth", ""},
                   water = {"water", ""}, weathering = {"weathering", ""},
                   snow_depth = {"snow_depth", "m"}, snow_water = {"snow_water", "mm"};

/// `frame`: 0 of what is the same in all frames.
std::string file_name(const Quantity& quantity, int frame) {
  return frame > 0 ? fmt::format("{}_{:04}.tif", quantity.name, frame)
                   : fmt::format("{}.tif", quantity.name);
}

/// Writes maps of one ground, but for those that are there from the same source, and remembers
/// them.
class Folder {
 public:
  Folder(fs::path folder, const Heightfield& terrain, Georeference place, std::string source)
      : folder_(std::move(folder)),
        terrain_(terrain),
        place_(std::move(place)),
        source_(std::move(source)) {}

  /// Whether the map is there from this source; it is remembered, to be written where it is not.
  bool keeps(const Quantity& quantity, int frame) {
    const fs::path file = folder_ / file_name(quantity, frame);
    files_.push_back({file, quantity.name, quantity.unit, frame});
    return source_of_geotiff(file) == source_;
  }

  template <class ValueAt>
  void write(const Quantity& quantity, int frame, const ValueAt& value_at) {
    if (!keeps(quantity, frame)) fill(quantity, value_at);
  }

  /// Writes the map that keeps() has remembered last.
  template <class ValueAt>
  void fill(const Quantity& quantity, const ValueAt& value_at) {
    FactorMap map(terrain_.samples(), terrain_.square());
    parallel_for(static_cast<std::size_t>(map.samples()), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < map.samples(); ++i)
        map.at(i, j) = static_cast<float>(value_at(map.place_m(i, j)));
    });
    write_geotiff(files_.back().file, map, place_, quantity, source_);
  }

  std::vector<MapFile> files() && { return std::move(files_); }

 private:
  fs::path folder_;
  const Heightfield& terrain_;
  Georeference place_;
  std::string source_;
  std::vector<MapFile> files_;
};

/// Height of the scene's zero.
double zero_m(const scene::Terrain& terrain) {
  return terrain.elevation.empty() ? 0.0 : terrain::read_elevation(terrain).zero_m;
}

void write_ground(const scene::Scene& scene, const place::Site& site, Folder& folder) {
  const double zero = zero_m(scene.terrain);
  folder.write(height, 0, [&](const glm::dvec2& at_m) {
    return zero + double{site.terrain.sample(at_m.x, at_m.y)};
  });
  folder.write(slope, 0, [&](const glm::dvec2& at_m) {
    return terrain::slope_deg(site.terrain, at_m.x, at_m.y);
  });
  folder.write(growth, 0,
               [&](const glm::dvec2& at_m) { return site.growth.sample(at_m.x, at_m.y); });
  folder.write(water, 0, [&](const glm::dvec2& at_m) {
    return site.water ? site.water->share(at_m, site.terrain.step_m()) : 0.0;
  });
}

void write_frame(const scene::Scene& scene, const place::Site& site, int frame, Folder& folder) {
  folder.write(weathering, frame,
               [&](const glm::dvec2& at_m) { return site.withering->at(at_m, frame); });
  if (!site.snow) return;
  if (!folder.keeps(snow_depth, frame)) {
    const ground::SnowyGround ground(scene, site, frame);
    folder.fill(snow_depth, [&](const glm::dvec2& at_m) { return ground.depth_m(at_m); });
  }
  if (site.snow->large || folder.keeps(snow_water, frame)) return;
  const snow::SnowGround::State state = site.snow->ground.at(scene::time_s(scene, frame));
  folder.fill(snow_water, [&](const glm::dvec2& at_m) {
    const double land = site.water ? 1.0 - site.water->share(at_m, site.terrain.step_m()) : 1.0;
    return land * double{state.water_mm.sample(at_m.x, at_m.y)};
  });
}

/// Of a source, and of a ground and its place as they have been read: files beside an elevation
/// model may say where it lies and what its values are.
std::string source_with_ground(const std::string& source, const place::Site& site,
                               const Georeference& place) {
  const auto hash = [](const std::vector<float>& values) {
    return content_hash(
        {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
  };
  return content_hash(fmt::format("{} {} {} {} {} {}", source, place.system, place.south_west_m.x,
                                  place.south_west_m.y, hash(site.terrain.values()),
                                  hash(site.growth.values())));
}

}  // namespace

std::vector<fs::path> map_files(const fs::path& folder, const std::vector<int>& frames) {
  std::vector<fs::path> files;
  for (const Quantity& quantity : {height, slope, growth, water})
    files.push_back(folder / file_name(quantity, 0));
  for (const int frame : frames)
    for (const Quantity& quantity : {weathering, snow_depth, snow_water})
      files.push_back(folder / file_name(quantity, frame));
  return files;
}

std::vector<MapFile> write_maps(const scene::Scene& scene,
                                std::shared_ptr<const phenology::FilmSeason> season,
                                const std::vector<int>& frames, const fs::path& folder,
                                const fs::path& scratch, const std::string& source,
                                Progress& progress) {
  progress.begin("maps", frames.size() + 1);
  make_folder(folder);
  const place::Site site = place::make_site(scene, std::move(season), scratch);
  const scene::Terrain& terrain = scene.terrain;
  const Georeference place =
      georeference(terrain.elevation, terrain.system, terrain.centre, terrain.size_m);
  Folder maps(folder, site.terrain, place, source_with_ground(source, site, place));
  write_ground(scene, site, maps);
  progress.advance(1, "ground");
  for (const int frame : frames) {
    write_frame(scene, site, frame, maps);
    progress.advance(1, fmt::format("frame {}", frame));
  }
  progress.end();
  return std::move(maps).files();
}

std::string as_json(const std::vector<MapFile>& files) {
  constexpr int indent = 2;
  auto list = nlohmann::ordered_json::array();
  for (const MapFile& map : files)
    list.push_back({{"version", 1},
                    {"file", map.file.string()},
                    {"map", map.name},
                    {"unit", map.unit},
                    {"frame", map.frame}});
  return list.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace wold::maps
