#include "mitsuba/scene_file.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/error.h"
#include "mitsuba/leaf_files.h"
#include "mitsuba/texel_files.h"

namespace wold::mitsuba {
namespace {

using landscape::Landscape;

/// Nine digits: what a float needs. Throws FileError for what is no number.
std::string number(double value) {
  if (!std::isfinite(value))
    throw FileError(fmt::format(
        "found {} among the numbers for Mitsuba, expected a finite one: this is a fault of wold",
        value));
  return fmt::format("{:.9g}", value);
}

std::string vector(const glm::dvec3& v) {
  return fmt::format("{}, {}, {}", number(v.x), number(v.y), number(v.z));
}

/// An affine map, as rows.
std::string to_world(const glm::dmat4& matrix) {
  std::string values;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) values += number(matrix[column][row]) + ' ';
  return fmt::format("<transform name=\"to_world\"><matrix value=\"{}\"/></transform>", values);
}

glm::dmat4 translation(const glm::dvec3& by_m) {
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(by_m, 1.0);
  return matrix;
}

/// From the unit cube to a box.
glm::dmat4 box_matrix(const glm::dvec3& low_m, const glm::dvec3& high_m) {
  glm::dmat4 matrix = translation(low_m);
  for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = high_m[axis] - low_m[axis];
  return matrix;
}

/// From Mitsuba's cube, which reaches from -1 to 1, to the unit cube.
const glm::dmat4 unit_from_cube = box_matrix(glm::dvec3(0.5), glm::dvec3(1.0));

/// Twice what a ray is lifted off a wall so far away, shared by the two walls of neighbours.
double inset_m(double distance_m) { return 1e-4 * (1.0 + distance_m); }

/// How far boxes of texels reach below their foot, in sides of their patch. A ray that left a box
/// just above the ground would be lifted through the ground.
constexpr double rooted_share = 0.1;

std::string picture(const char* name, const std::string& file, const std::string& more = {}) {
  return fmt::format(
      "<texture name=\"{}\" type=\"bitmap\"><string name=\"filename\" value=\"{}\"/>"
      "<boolean name=\"raw\" value=\"true\"/><string name=\"wrap_mode\" value=\"clamp\"/>{}"
      "</texture>",
      name, file, more);
}

std::string grid(const char* name, const std::string& file, const glm::dmat4& world_from_unit) {
  return fmt::format(
      "<volume name=\"{}\" type=\"gridvolume\"><string name=\"filename\" value=\"{}\"/>"
      "<boolean name=\"raw\" value=\"true\"/>{}</volume>",
      name, file, to_world(world_from_unit));
}

/// A medium in a box that shows no walls. `inside`: what a heterogeneous medium consists of.
std::string medium_box(const glm::dmat4& world_from_box, const std::string& inside) {
  return fmt::format(
      "  <shape type=\"cube\">{}<bsdf type=\"null\"/>\n"
      "    <medium name=\"interior\" type=\"heterogeneous\">{}</medium></shape>\n",
      to_world(world_from_box * unit_from_cube), inside);
}

bool has_media(const Landscape& landscape) {
  return !landscape.cells.empty() || !shown_clouds(landscape).empty();
}

std::string settings(const Landscape& landscape) {
  return fmt::format(
      "  <default name=\"spp\" value=\"{}\"/>\n"
      "  <default name=\"exposure_gain\" value=\"{}\"/>\n"
      "  <integrator type=\"{}\"><integer name=\"max_depth\" value=\"-1\"/>"
      "<integer name=\"rr_depth\" value=\"16\"/></integrator>\n",
      landscape.samples, number(landscape.exposure_gain),
      has_media(landscape) ? "volpath" : "path");
}

std::string camera(const Landscape& landscape) {
  const landscape::Camera& camera = landscape.camera;
  return fmt::format(
      "  <sensor type=\"perspective\">\n"
      "    <transform name=\"to_world\">"
      "<lookat origin=\"0, 0, 0\" target=\"{}\" up=\"0, 0, 1\"/></transform>\n"
      "    <string name=\"fov_axis\" value=\"x\"/><float name=\"fov\" value=\"{}\"/>"
      "<float name=\"near_clip\" value=\"0.001\"/><float name=\"far_clip\" value=\"1e6\"/>\n"
      "    <sampler type=\"independent\"><integer name=\"sample_count\" value=\"$spp\"/>"
      "</sampler>\n"
      "    <film type=\"hdrfilm\"><integer name=\"width\" value=\"{}\"/>"
      "<integer name=\"height\" value=\"{}\"/>"
      "<string name=\"pixel_format\" value=\"rgb\"/>"
      "<string name=\"component_format\" value=\"float32\"/><rfilter type=\"box\"/></film>\n"
      "  </sensor>\n",
      vector(camera.target_m - camera.eye_m), number(camera.field_of_view_deg), landscape.width_px,
      landscape.height_px);
}

/// Mitsuba's own sky has y up; its picture, like ours, begins in the north, which is -z there, and
/// goes on to the east, x.
std::string lights(const Landscape& landscape) {
  std::string text =
      "  <emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/>"
      "<transform name=\"to_world\"><rotate x=\"1\" angle=\"90\"/></transform></emitter>\n";
  if (landscape.unlit->sun_irradiance != glm::vec3(0.0F))
    text += fmt::format(
        "  <emitter type=\"directional\"><vector name=\"direction\" value=\"{}\"/>"
        "<rgb name=\"irradiance\" value=\"{}\"/></emitter>\n",
        vector(-landscape.daylight.to_sun), vector(landscape.unlit->sun_irradiance));
  return text;
}

/// A mesh of the ground with its picture. The values of a map lie on its border, pixels within a
/// picture's.
std::string ground(const Landscape& landscape, const std::string& file,
                   const glm::dvec3& origin_m) {
  const double samples = landscape.unlit->ground_albedo.samples();
  const std::string to_pixels = fmt::format(
      "<transform name=\"to_uv\"><scale x=\"{0}\" y=\"{0}\"/>"
      "<translate x=\"{1}\" y=\"{1}\"/></transform>",
      number((samples - 1.0) / samples), number(0.5 / samples));
  return fmt::format(
      "  <shape type=\"ply\"><string name=\"filename\" value=\"../{}\"/>{}\n"
      "    <bsdf type=\"twosided\"><bsdf type=\"diffuse\">{}</bsdf></bsdf></shape>\n",
      file, to_world(translation(origin_m - landscape.camera.eye_m)),
      picture("reflectance", "ground.exr", to_pixels));
}

/// The meshes of blades, each a group to make instances of.
std::string leaves(const Landscape& landscape) {
  std::string text;
  for (std::size_t i = 0; i < landscape.blade_meshes.size(); ++i) {
    const auto files = leaf_files(landscape.blade_meshes[i].name, "../leaves");
    fmt::format_to(std::back_inserter(text),
                   "  <shape type=\"shapegroup\" id=\"leaves_{}\"><shape type=\"ply\">"
                   "<string name=\"filename\" value=\"{}\"/>"
                   "<boolean name=\"face_normals\" value=\"true\"/>\n"
                   "    <bsdf type=\"bilambertian\">{}{}</bsdf></shape></shape>\n",
                   i, files[0].generic_string(), picture("reflectance", files[1].generic_string()),
                   picture("transmittance", files[2].generic_string()));
  }
  for (const landscape::BladeCell& cell : landscape.blade_cells)
    fmt::format_to(std::back_inserter(text),
                   "  <shape type=\"instance\"><ref id=\"leaves_{}\"/>{}</shape>\n", cell.mesh,
                   to_world(translation(-landscape.camera.eye_m) * cell.world_from_cell));
  return text;
}

std::string cell_text(const Landscape& landscape, const landscape::Cell& cell) {
  const landscape::Volume& volume = landscape.volumes[static_cast<std::size_t>(cell.volume)];
  const double patch_m = landscape.patch_m;
  const glm::dvec3 size_m(patch_m, patch_m, volume.voxels.z * volume.voxel_m);
  const glm::dmat4 seen_from_cell = translation(-landscape.camera.eye_m) * cell.world_from_cell;
  const glm::dvec2 middle = 0.5 * (cell.part.low + cell.part.high) * patch_m;
  const glm::dvec3 seen_m(seen_from_cell * glm::dvec4(middle, 0.0, 1.0));
  const glm::dvec3 inset(glm::dvec2(inset_m(glm::length(seen_m))), 0.0);
  const glm::dvec3 low_m = glm::dvec3(cell.part.low * patch_m, -rooted_share * patch_m) + inset;
  const glm::dvec3 high_m = glm::dvec3(cell.part.high * patch_m, size_m.z) - inset;
  const glm::dvec3 at_m = seen_m + landscape.camera.eye_m;
  const auto files = texel_files(texel_name(volume), "../texels");
  const glm::dmat4 grid_place = seen_from_cell * box_matrix(glm::dvec3(0.0), size_m);
  return medium_box(
      seen_from_cell * box_matrix(low_m, high_m),
      grid("sigma_t", files[0].generic_string(), grid_place) +
          grid("albedo", files[1].generic_string(), grid_place) +
          fmt::format("<float name=\"scale\" value=\"{}\"/>",
                      number(double{landscape.extinction_factor.sample(at_m.x, at_m.y)})));
}

/// Droplets swallow next to nothing of visible light.
constexpr double droplet_albedo = 0.9999;

std::string cloud_text(const Landscape& landscape, const landscape::CloudBox& cloud) {
  const glm::dvec3 low_m = cloud.corner_m - landscape.camera.eye_m;
  const glm::dmat4 place = box_matrix(low_m, low_m + cloud.voxel_m * glm::dvec3(cloud.voxels));
  return medium_box(place,
                    grid("sigma_t", cloud_file(cloud), place) +
                        fmt::format("<rgb name=\"albedo\" value=\"{}\"/>"
                                    "<phase type=\"hg\"><float name=\"g\" value=\"{}\"/></phase>",
                                    number(droplet_albedo), number(cloud.asymmetry)));
}

}  // namespace

std::vector<const landscape::CloudBox*> shown_clouds(const Landscape& landscape) {
  std::vector<const landscape::CloudBox*> shown;
  for (const landscape::CloudBox& cloud : landscape.clouds)
    if (!cloud.is_haze) shown.push_back(&cloud);
  return shown;
}

std::string cloud_file(const landscape::CloudBox& cloud) { return cloud.name + ".vol"; }

std::string scene_text(const Landscape& landscape, const std::string& terrain,
                       const std::string& boulders) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
      "<!-- Frame {}, weathering degree {}. Metres from the eye; x east, y north, z up. -->\n"
      "<scene version=\"3.0.0\">\n",
      landscape.frame, number(landscape.weathering));
  text += settings(landscape) + camera(landscape) + lights(landscape) +
          ground(landscape, terrain, glm::dvec3(0.0));
  if (!boulders.empty()) text += ground(landscape, boulders, landscape.boulders.origin_m);
  text += leaves(landscape);
  for (const landscape::Cell& cell : landscape.cells) text += cell_text(landscape, cell);
  for (const landscape::CloudBox* cloud : shown_clouds(landscape))
    text += cloud_text(landscape, *cloud);
  return text + "</scene>\n";
}

}  // namespace wold::mitsuba
