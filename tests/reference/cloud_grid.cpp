// Writes what clouds.py follows light through:
//
//     cloud_grid FOLDER
//
//     FOLDER/cloud.vol             extinction of the droplets, 1/m (mitsuba/grid_file.h)
//     FOLDER/sky_20_towards.exr    sky and ground for a height and side of the sun (Daylight's
//     unit) FOLDER/clouds.json           the rest: {"low_m", "high_m", "asymmetry", "eye_m",
//     "target_m",
//                                  "field_of_view_deg", "size_px", "suns": [{"name", "direction",
//                                  "irradiance"}]}
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cloud_scene.h"
#include "core/error.h"
#include "core/files.h"
#include "core/image.h"
#include "mitsuba/grid_file.h"
#include "support/places.h"

namespace wold {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

template <class Vector>
Json json_of(const Vector& vector) {
  Json values = Json::array();
  for (int i = 0; i < Vector::length(); ++i) values.push_back(vector[i]);
  return values;
}

Image sky_picture(const light::Daylight& day) {
  Image picture = day.sunless_sky_image(512);
  for (int y = picture.height / 2; y < picture.height; ++y)
    std::fill_n(picture.pixel(0, y), 3 * picture.width, test::cloud_ground_radiance);
  return picture;
}

Json sun_of(const test::CloudSun& sun, const fs::path& folder) {
  const scene::Scene scene = test::cloud_scene(sun);
  const light::Daylight day(scene.sun, scene.sky);
  const std::string name = fmt::format("{:.0f}_{}", sun.elevation_deg, sun.side);
  write_image(folder / fmt::format("sky_{}.exr", name), sky_picture(day), PixelFormat::float32);
  return {{"name", name},
          {"direction", json_of(day.sun_direction())},
          {"irradiance", json_of(day.sun_irradiance_at(test::cloud_middle_m))}};
}

void write_cloud(const fs::path& folder) {
  const cloud::CloudVolume volume = test::cloud_volume(test::tests_folder() / "data/light");
  write_file(folder / "cloud.vol", mitsuba::grid_bytes(volume.box.voxels, volume.extinction_per_m));
  const landscape::Camera camera = test::cloud_camera();
  const glm::dvec3 size_m = glm::dvec3(volume.box.voxels) * volume.box.voxel_m;
  Json cloud{{"low_m", json_of(volume.box.corner_m)},
             {"high_m", json_of(volume.box.corner_m + size_m)},
             {"asymmetry", volume.asymmetry},
             {"eye_m", json_of(camera.eye_m)},
             {"target_m", json_of(camera.target_m)},
             {"field_of_view_deg", camera.field_of_view_deg},
             {"size_px", json_of(test::cloud_picture_px)}};
  for (const test::CloudSun& sun : test::cloud_suns()) cloud["suns"].push_back(sun_of(sun, folder));
  write_file(folder / "clouds.json", cloud.dump(2) + '\n');
}

}  // namespace
}  // namespace wold

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: cloud_grid FOLDER\n");
    return 2;
  }
  try {
    wold::make_folder(arguments[1]);
    wold::write_cloud(arguments[1]);
  } catch (const wold::Error& error) {
    fmt::print(stderr, "cloud_grid: {}\n", error.what());
    return 4;
  }
}
