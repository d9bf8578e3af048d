#include "usd/light_variant.h"

#include <fmt/format.h>

#include "usd/flakes_text.h"
#include "usd/frame_files.h"
#include "usd/ground_file.h"
#include "usd/material.h"
#include "usd/mesh_text.h"
#include "usd/text.h"

namespace wold::usd {
namespace {

using landscape::Landscape;

std::string file_of(const Landscape& landscape, const std::string& name) {
  return (frame_folder(landscape) / name).generic_string();
}

Surface glowing(const Landscape& landscape, const std::string& picture, const PicturePlace& place) {
  return {.radiance =
              Texture{file_of(landscape, picture), glm::dvec3(landscape.exposure_gain), place}};
}

/// The whole ground's, or that of a detail: what is known without light has no finer pictures.
Surface ground_surface(const Landscape& landscape, Light light, std::size_t detail) {
  const Heightfield& terrain = landscape.terrain;
  if (light == Light::lit) {
    const ColourMap& albedo = landscape.unlit->ground_albedo;
    return {.reflectance = Texture{file_of(landscape, "ground_albedo.exr"), glm::dvec3(1.0),
                                   place_in(terrain, albedo.square(), albedo.samples())}};
  }
  if (detail == 0)
    return glowing(landscape, "ground.exr",
                   place_in(terrain, landscape.ground.square(), landscape.ground.samples()));
  const landscape::GroundDetail& finer = landscape.ground_details[detail - 1];
  return glowing(
      landscape, detail_picture(detail),
      place_in(terrain, Square{finer.corner_m, finer.map.size_m()}, finer.map.samples()));
}

std::string materials_text(const Landscape& landscape, Light light) {
  const std::string scope = "/Landscape/Materials/";
  std::string text = material_text(scope + "ground", ground_surface(landscape, light, 0));
  for (std::size_t i = 1; i <= landscape.ground_details.size(); ++i)
    text += material_text(fmt::format("{}ground_detail_{}", scope, i),
                          ground_surface(landscape, light, i));
  if (light == Light::baked && landscape.backdrop)
    text += material_text(scope + "backdrop", glowing(landscape, "backdrop.exr", {}));
  text += flake_materials_text(landscape);
  return "def Scope \"Materials\"\n{\n" + indented(text) + "}\n";
}

/// A rectangle far behind everything.
std::string backdrop_text(const Landscape& landscape) {
  if (!landscape.backdrop) return {};
  const landscape::Backdrop& backdrop = *landscape.backdrop;
  const glm::dvec3& low_m = backdrop.corner_m;
  const glm::vec3 corners_m[] = {low_m, low_m + backdrop.right_m,
                                 low_m + backdrop.right_m + backdrop.up_m, low_m + backdrop.up_m};
  return fmt::format(
      "def Mesh \"backdrop\" (\n"
      "    prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
      ")\n"
      "{{\n"
      "    uniform bool doubleSided = 1\n"
      "    float3[] extent = {}\n"
      "    int[] faceVertexCounts = [4]\n"
      "    int[] faceVertexIndices = [0, 1, 2, 3]\n"
      "    rel material:binding = </Landscape/Materials/backdrop>\n"
      "    point3f[] points = {}\n"
      "    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (\n"
      "        interpolation = \"vertex\"\n"
      "    )\n"
      "    uniform token subdivisionScheme = \"none\"\n"
      "}}\n",
      extent_text(corners_m),
      array(corners_m, [](const glm::vec3& at_m) { return vector(glm::dvec3(at_m)); }));
}

}  // namespace

std::string light_variant(const Landscape& landscape, const Grass& grass, Light light) {
  const bool is_baked = light == Light::baked;
  std::string text = fmt::format(
      "over \"sky\"\n"
      "{{\n"
      "    asset inputs:texture:file = {}\n"
      "}}\n",
      asset(file_of(landscape, is_baked ? "sky.exr" : "sky_without_sun.exr")));
  text += materials_text(landscape, light) + grass.materials_text(light);
  if (is_baked) text += backdrop_text(landscape);
  return fmt::format("\"{}\" {{\n{}}}\n", is_baked ? "baked" : "lit", indented(text));
}

}  // namespace wold::usd
