#include "usd/material.h"

#include <fmt/format.h>

#include "usd/text.h"

namespace wold::usd {
namespace {

/// A UsdUVTexture and how it finds its place. Opacity is a number, the others are colours.
std::string texture_text(const std::string& path, const std::string& name, const Texture& texture) {
  const bool moved =
      texture.place.scale != glm::dvec2(1.0) || texture.place.offset != glm::dvec2(0.0);
  const std::string placed_by = moved ? fmt::format("{}/{}_place.outputs:result", path, name)
                                      : fmt::format("{}/st.outputs:result", path);
  std::string text = fmt::format(
      "def Shader \"{0}\"\n"
      "{{\n"
      "    uniform token info:id = \"UsdUVTexture\"\n"
      "    asset inputs:file = {1}\n"
      "    float4 inputs:scale = ({2}, {3}, {4}, 1)\n"
      "    token inputs:sourceColorSpace = \"raw\"\n"
      "    float2 inputs:st.connect = <{5}>\n"
      "    token inputs:wrapS = \"clamp\"\n"
      "    token inputs:wrapT = \"clamp\"\n"
      "    float outputs:r\n"
      "    float3 outputs:rgb\n"
      "}}\n",
      name, asset(texture.file), number(texture.factor.x), number(texture.factor.y),
      number(texture.factor.z), placed_by);
  if (moved)
    text += fmt::format(
        "def Shader \"{}_place\"\n"
        "{{\n"
        "    uniform token info:id = \"UsdTransform2d\"\n"
        "    float2 inputs:in.connect = <{}/st.outputs:result>\n"
        "    float2 inputs:scale = {}\n"
        "    float2 inputs:translation = {}\n"
        "    float2 outputs:result\n"
        "}}\n",
        name, path, pair(texture.place.scale), pair(texture.place.offset));
  return text;
}

std::string colour_input(const std::string& path, const char* input, const char* picture,
                         const std::optional<Texture>& texture, const glm::dvec3& even) {
  return texture ? fmt::format("    color3f inputs:{}.connect = <{}/{}.outputs:rgb>\n", input, path,
                               picture)
                 : fmt::format("    color3f inputs:{} = {}\n", input, vector(even));
}

constexpr const char* st_reader =
    "def Shader \"st\"\n"
    "{\n"
    "    uniform token info:id = \"UsdPrimvarReader_float2\"\n"
    "    string inputs:varname = \"st\"\n"
    "    float2 outputs:result\n"
    "}\n";

std::string surface_text(const std::string& path, const Surface& surface) {
  std::string text =
      "def Shader \"surface\"\n"
      "{\n"
      "    uniform token info:id = \"UsdPreviewSurface\"\n";
  text += colour_input(path, "diffuseColor", "reflectance", surface.reflectance, glm::dvec3(0.0));
  text += colour_input(path, "emissiveColor", "radiance", surface.radiance,
                       surface.even_radiance.value_or(glm::dvec3(0.0)));
  if (surface.opacity)
    text += fmt::format("    float inputs:opacity.connect = <{}/opacity.outputs:r>\n", path);
  // Of an index of refraction of 1 nothing is mirrored, also where hosts do not know specularColor.
  return text +
         "    float inputs:ior = 1\n"
         "    float inputs:roughness = 1\n"
         "    color3f inputs:specularColor = (0, 0, 0)\n"
         "    int inputs:useSpecularWorkflow = 1\n"
         "    token outputs:surface\n"
         "}\n";
}

}  // namespace

std::string material_text(const std::string& path, const Surface& surface) {
  std::string inside =
      fmt::format("token outputs:surface.connect = <{}/surface.outputs:surface>\n\n", path);
  inside += surface_text(path, surface);
  if (surface.reflectance) inside += texture_text(path, "reflectance", *surface.reflectance);
  if (surface.radiance) inside += texture_text(path, "radiance", *surface.radiance);
  if (surface.opacity) inside += texture_text(path, "opacity", *surface.opacity);
  if (surface.reflectance || surface.radiance || surface.opacity) inside += st_reader;
  return fmt::format("def Material \"{}\"\n{{\n{}}}\n", path.substr(path.rfind('/') + 1),
                     indented(inside));
}

}  // namespace wold::usd
