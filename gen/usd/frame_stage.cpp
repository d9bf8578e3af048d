#include "usd/frame_stage.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/pinhole.h"
#include "usd/flakes_text.h"
#include "usd/frame_files.h"
#include "usd/grass_text.h"
#include "usd/ground_file.h"
#include "usd/layer.h"
#include "usd/light_variant.h"
#include "usd/material.h"
#include "usd/text.h"

namespace wold::usd {
namespace {

using landscape::Landscape;

/// A matrix of three directions and a place.
glm::dmat4 frame_of(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z,
                    const glm::dvec3& at_m) {
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(at_m, 1.0)};
}

/// So far that all there is can be seen.
double farthest_m(const Landscape& landscape) {
  const glm::dvec3& eye_m = landscape.camera.eye_m;
  const Heightfield& terrain = landscape.terrain;
  const auto [low, high] = std::ranges::minmax_element(terrain.values());
  double far_m = 0.0;
  const auto see = [&](const glm::dvec3& at_m) {
    far_m = std::max(far_m, glm::distance(at_m, eye_m));
  };
  for (const double z : {double{*low}, double{*high}})
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
      see(glm::dvec3(terrain.corner_m() + corner * terrain.size_m(), z));
  if (const auto& backdrop = landscape.backdrop)
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}})
      see(backdrop->corner_m + corner.x * backdrop->right_m + corner.y * backdrop->up_m);
  for (const landscape::CloudBox& cloud : landscape.clouds) {
    see(cloud.corner_m);
    see(cloud.corner_m + cloud.voxel_m * glm::dvec3(cloud.voxels));
  }
  return 1.1 * far_m;
}

/// Apertures and focal lengths count in tenths of a unit, here of a metre: 36 mm wide.
std::string camera_text(const Landscape& landscape) {
  constexpr double width = 0.36, near_m = 0.05;
  const landscape::Camera& camera = landscape.camera;
  const CameraAxes axes(camera.eye_m, camera.target_m);
  const auto sample = [&](const std::string& value) {
    return fmt::format("{{ {}: {} }}", landscape.frame, value);
  };
  return fmt::format(
      "def Camera \"camera\"\n"
      "{{\n"
      "    float2 clippingRange.timeSamples = {}\n"
      "    float focalLength.timeSamples = {}\n"
      "    float horizontalAperture.timeSamples = {}\n"
      "    token projection = \"perspective\"\n"
      "    float verticalAperture.timeSamples = {}\n"
      "    matrix4d xformOp:transform.timeSamples = {}\n"
      "    uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
      "}}\n",
      sample(pair({near_m, farthest_m(landscape)})),
      sample(number(0.5 * width / half_width(camera.field_of_view_deg))), sample(number(width)),
      sample(number(width * landscape.height_px / landscape.width_px)),
      sample(matrix(frame_of(axes.right, axes.up, -axes.forward, camera.eye_m))));
}

/// A distant light shines along -z of its own; normalised, its intensity is what a plane that faces
/// it receives.
std::string sun_text(const Landscape& landscape) {
  const glm::dvec3 irradiance =
      landscape.exposure_gain * glm::dvec3(landscape.unlit->sun_irradiance);
  const double most = std::max({irradiance.x, irradiance.y, irradiance.z});
  if (!(most > 0.0)) return {};
  const glm::dvec3& to_sun = landscape.daylight.to_sun;
  const CameraAxes axes(glm::dvec3(0.0), -to_sun);
  return fmt::format(
      "def DistantLight \"sun\"\n"
      "{{\n"
      "    float inputs:angle = 0.53\n"
      "    color3f inputs:color = {}\n"
      "    float inputs:intensity = {}\n"
      "    bool inputs:normalize = 1\n"
      "    matrix4d xformOp:transform = {}\n"
      "    uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
      "}}\n",
      vector(irradiance / most), number(most),
      matrix(frame_of(axes.right, axes.up, to_sun, glm::dvec3(0.0))));
}

/// A dome's own y is up. Its picture's middle, like ours, looks south once that is turned to z.
std::string sky_text(const Landscape& landscape) {
  return fmt::format(
      "def DomeLight \"sky\"\n"
      "{{\n"
      "    float inputs:intensity = {}\n"
      "    token inputs:texture:format = \"latlong\"\n"
      "    float3 xformOp:rotateXYZ = (90, 0, 0)\n"
      "    uniform token[] xformOpOrder = [\"xformOp:rotateXYZ\"]\n"
      "}}\n",
      number(landscape.exposure_gain));
}

std::string ground_text(const Landscape& landscape, const std::string& ground) {
  std::string text = fmt::format(
      "def Mesh \"ground\" (\n"
      "    prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
      "    prepend references = {}\n"
      ")\n"
      "{{\n"
      "    rel material:binding = </Landscape/Materials/ground>\n",
      asset("data/" + ground));
  for (std::size_t i = 1; i <= landscape.ground_details.size(); ++i)
    text += fmt::format(
        "\n"
        "    over \"detail_{0}\" (\n"
        "        prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
        "    )\n"
        "    {{\n"
        "        rel material:binding = </Landscape/Materials/ground_detail_{0}>\n"
        "    }}\n",
        i);
  return text + "}\n";
}

std::string cloud_text(const Landscape& landscape, const landscape::CloudBox& cloud) {
  return fmt::format(
      "def Xform \"{}\"\n"
      "{{\n"
      "    double3 xformOp:translate = {}\n"
      "    uniform token[] xformOpOrder = [\"xformOp:translate\"]\n"
      "\n{}}}\n",
      cloud.name, vector(cloud.corner_m),
      indented(volume_text(fmt::format("/Landscape/Clouds/{}", cloud.name),
                           frame_folder(landscape) / (cloud.name + ".vdb"),
                           cloud.voxel_m * glm::dvec3(cloud.voxels))));
}

std::string clouds_text(const Landscape& landscape) {
  if (landscape.clouds.empty()) return {};
  std::string clouds;
  for (const landscape::CloudBox& cloud : landscape.clouds) clouds += cloud_text(landscape, cloud);
  return "def Scope \"Clouds\"\n{\n" + indented(clouds) + "}\n";
}

/// How hosts that render from a stage make the picture.
std::string render_text(const Landscape& landscape) {
  return fmt::format(
      "\n"
      "def Scope \"Render\"\n"
      "{{\n"
      "    def RenderSettings \"settings\"\n"
      "    {{\n"
      "        rel camera = </Landscape/camera>\n"
      "        uniform int2 resolution = ({}, {})\n"
      "    }}\n"
      "}}\n",
      landscape.width_px, landscape.height_px);
}

std::string facts_of(const Landscape& landscape) {
  return fmt::format(
      "double exposureGain = {}\n"
      "int frame = {}\n"
      "double timeSeconds = {}\n"
      "double weatheringDegree = {}\n",
      number(landscape.exposure_gain), landscape.frame, number(landscape.time_s),
      number(landscape.weathering));
}

constexpr const char* doc =
    "A landscape by Wold. The variant set light of /Landscape has baked, which shows the radiance "
    "of Wold's pictures, and lit, which leaves it to sun, sky and lights of your own.";

}  // namespace

std::string frame_text(const Landscape& landscape, const std::string& ground) {
  const Grass grass(landscape);
  std::string text = layer_header({landscape.frame, landscape.frame}, doc, facts_of(landscape)) +
                     landscape_begin();
  for (const std::string& part : {camera_text(landscape), sun_text(landscape), sky_text(landscape),
                                  ground_text(landscape, ground), grass.text(),
                                  clouds_text(landscape), flakes_text(landscape)})
    text += indented(part) + "\n";
  text += "    variantSet \"light\" = {\n" +
          indented(light_variant(landscape, grass, Light::baked), 2) +
          indented(light_variant(landscape, grass, Light::lit), 2) + "    }\n}\n";
  return text + render_text(landscape);
}

}  // namespace wold::usd
